// The library's errors in the words of the command line.
#pragma once

#include <string>

namespace uhas::tools {

/// `message` of the library with options in place of the fields that it names: "raise ModelLoadOptions::max_links"
/// becomes "raise the bound by --limit links=N".
std::string with_option_names(std::string message);

}  // namespace uhas::tools
