// Which links of a hand hold together.
#pragma once

#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Whether links of the hand hold together: rigidly, or one carries the other by joints with no geometry between them.
class LinkAdjacency {
 public:
  /// `has_geometry`: one element a link of `profile`.
  LinkAdjacency(const HandProfile& profile, const std::vector<bool>& has_geometry);

  /// `first`, `second`: indices of links with geometry.
  bool adjacent(int first, int second) const;

 private:
  std::vector<int> joint_;   // [link] that carries it, -1 = palm
  std::vector<int> before_;  // [joint] the next joint toward the palm that carries geometry, -1 = palm
};

}  // namespace uhas
