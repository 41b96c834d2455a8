// What the checks of a profile found, as a table.
#pragma once

#include <iosfwd>
#include <span>

#include "input/profile_check.hpp"

namespace uhas::tools {

/// One line a check.
void print_checks(std::ostream& out, std::span<const Check> checks);

}  // namespace uhas::tools
