// Two profiles of one hand, described in two ways.
#pragma once

#include <set>
#include <string>

#include "uhas/profile/hand_profile.hpp"

namespace uhas::test {

/// How the second description differs from the first, in what the profile may show.
struct Relation {
  double scale = 1;
  std::set<std::string> flipped{};  ///< joints whose axis and limits changed sign
  bool mirrored = false;
};

/// How far two hands are followed.
enum class Extent {
  tables,    ///< slots, classes, poses and lateral tables
  solutions  ///< what rays hit, and solutions, too
};

/// Checks that both are the same (design, section 4) but for `relation`; prints by how much they differ.
/// @param what  names the change in the printed line
void check_same_hand(const HandProfile& original, const HandProfile& changed, const Relation& relation,
                     const std::string& what, Extent extent = Extent::solutions);

}  // namespace uhas::test
