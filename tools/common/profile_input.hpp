// Hand profiles as the tools read them.
#pragma once

#include <string>

#include "common/tool.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

/// As uhas::read_profile; with --untrusted as read_untrusted_profile.
HandProfile read_profile(const Tool& tool, const std::string& path);

}  // namespace uhas::tools
