// Is a profile sound, and is it still of this model?
#pragma once

#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"

namespace uhas::tools {

struct Check {
  std::string item;  ///< what was looked at: a file, or a property in words
  bool passed = false;
  std::string detail;  ///< what was found
};

/// Shows that the zero action returns the wrapped pose. What `read_profile` refuses never comes here.
std::vector<Check> check_behaviour(const HandProfile& profile);

/// Compares the SHA-256 of every file of the model with the profile's.
std::vector<Check> check_sources(const HandProfile& profile, const HandModel& model);

}  // namespace uhas::tools
