// The versions of the libraries that a tool runs with.
#pragma once

#include <string>
#include <vector>

namespace uhas::tools {

/// "HDF5 1.10.8" and so on, in the order of the alphabet. The version is that of the library that is loaded where it
/// can tell, else that of the one compiled against.
std::vector<std::string> library_versions();

}  // namespace uhas::tools
