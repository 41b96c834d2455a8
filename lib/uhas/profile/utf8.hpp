// Whether bytes are UTF-8: names come from files of any encoding, and JSON and HDF5 promise UTF-8 to their readers.
#pragma once

#include <string_view>

namespace uhas {

/// True for well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF).
bool is_utf8(std::string_view text) noexcept;

}  // namespace uhas
