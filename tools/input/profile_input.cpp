#include "input/profile_input.hpp"

#include "uhas/profile_io/read_profile.hpp"

namespace uhas::tools {

HandProfile read_profile(Tool& tool, const std::string& path) {
  tool.files().read(path);
  return read_untrusted_profile(path, tool.limits().child());
}

}  // namespace uhas::tools
