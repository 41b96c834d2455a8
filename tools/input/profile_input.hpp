// Hand profiles as the tools read them.
#pragma once

#include <string>

#include "command_line/tool.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

/// As `read_untrusted_profile`, within the tool's limits. Throws Error(write_failed) when it is written as well.
HandProfile read_profile(Tool& tool, const std::string& path);

}  // namespace uhas::tools
