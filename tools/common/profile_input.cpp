#include "common/profile_input.hpp"

#include "uhas/profile_io/read_profile.hpp"

namespace uhas::tools {

HandProfile read_profile(const Tool& tool, const std::string& path) {
  return tool.untrusted() ? read_untrusted_profile(path) : uhas::read_profile(path);
}

}  // namespace uhas::tools
