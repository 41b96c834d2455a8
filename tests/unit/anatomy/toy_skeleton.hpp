// Skeletons built joint by joint. At q = 0 a finger is straight along +z; turns about +y carry it toward +x.
#pragma once

#include <utility>
#include <vector>

#include "support/toy_tree.hpp"
#include "uhas/anatomy/fingers/hand_skeleton.hpp"

namespace uhas::test {

inline constexpr Vector3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

struct ToyLimits {
  double lower = -0.2, upper = 1.6;
};

/// Adds hinges about `axis` at the foot of each phalanx along `direction`, the first one at `root` on joint `parent`.
inline FingerSkeleton add_hinges(KinematicTree& tree, int parent, Vector3d root, ToyLimits limits = {},
                                 Vector3d direction = kZ, Vector3d axis = kY,
                                 const std::vector<double>& phalanges = {0.05, 0.03, 0.02}) {
  FingerSkeleton finger;
  for (const double length : phalanges) {
    parent = add_hinge(tree, parent, root, axis, limits.lower, limits.upper);
    finger.joints.push_back(parent);
    finger.p_tip_joint = length * direction;
    root += length * direction;
  }
  return finger;
}

/// The same behind a joint about `axis_before` at `root`.
inline FingerSkeleton add_hinges_behind(KinematicTree& tree, Vector3d axis_before, ToyLimits limits_before,
                                        Vector3d root, ToyLimits limits = {}, double metacarpal = 0) {
  const int before = add_hinge(tree, -1, root, axis_before, limits_before.lower, limits_before.upper);
  FingerSkeleton finger = add_hinges(tree, before, root + metacarpal * kZ, limits);
  finger.joints.insert(finger.joints.begin(), before);
  return finger;
}

}  // namespace uhas::test
