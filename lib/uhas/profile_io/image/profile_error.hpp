// The error of this room: a file that is no usable hand profile.
#pragma once

#include <string>

#include "uhas/base/errors.hpp"

namespace uhas {

inline constexpr const char* rebuild_remedy = "rebuild it with uhas-build-profile";

inline Error profile_error(const std::string& path, const std::string& problem,
                           const std::string& remedy = rebuild_remedy) {
  return {ErrorCode::invalid_profile, path, problem, remedy};
}

}  // namespace uhas
