// What was inferred of a hand, as a table.
#pragma once

#include <iosfwd>
#include <span>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {

/// One line a finding: the hand config's key, the value in words, the confidence and the reason.
void print_findings(std::ostream& out, std::span<const HandFinding> findings);

}  // namespace uhas::tools
