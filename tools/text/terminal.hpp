// Text that stands out where a person reads it on a terminal, and stays plain everywhere else.
#pragma once

#include <iosfwd>
#include <string>

namespace uhas::tools {

enum class Tone { plain, heading, dim, lateral, encompassing, warning, error };

/// Whether text written to `out`, std::cout or std::cerr, may hold colours: it goes to a terminal, the environment has
/// no NO_COLOR (https://no-color.org) and does not call the terminal dumb.
bool has_colour(const std::ostream& out);

/// `text` in the colour of `tone` where `out` has colours, else as it is.
std::string toned(const std::ostream& out, const std::string& text, Tone tone);

}  // namespace uhas::tools
