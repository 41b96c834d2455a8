// What was inferred of a hand, as tables.
#pragma once

#include <iosfwd>

#include "uhas/profile_builder/build_stages.hpp"

namespace uhas::tools {

/// The findings, then each finger with its joints and its tip.
void print_hand_explanation(std::ostream& out, const BuildStages& stages);

}  // namespace uhas::tools
