// Bounds on the shape of an XML text, checked before a parser that recurses sees it.
#pragma once

#include <string>
#include <string_view>

namespace uhas {

/// XML parsers recurse once a level of elements and search the attributes of a tag linearly; this refuses, in one pass,
/// what would exhaust the stack or the user's patience, and text that ends inside a tag.
/// Throws Error: limit_exceeded, syntax; both name `file` and the line.
void check_xml_bounds(std::string_view text, const std::string& file);

}  // namespace uhas
