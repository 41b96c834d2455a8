// The files that the library carries for reports.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace uhas {

/// page/page.html with its scripts and its style in it; the element `uhas-report` waits for the document.
std::string_view embedded_page();

/// The runtime, compiled from hand_module.cpp.
std::span<const std::byte> embedded_hand_module();

}  // namespace uhas
