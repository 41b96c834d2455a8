// Random hands that know their own anatomy.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "uhas/model/hand_model.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::test {

/// What is true of a finger by construction.
struct RandomFinger {
  std::vector<std::string> joints;                 ///< root to tip
  std::vector<std::optional<JointClass>> classes;  ///< one a joint; nothing where either is right
  std::optional<int> slot;                         ///< one that it owns for certain
  Vector3d p_tip_joint;                            ///< fingertip in the last joint's frame, as it was made (m)
};

/// A hand and its truth. What its making leaves open, either answer to is right: see `random_hand.cpp` for the rules.
struct RandomHand {
  HandModel model;
  std::vector<RandomFinger> fingers;  ///< across the palm from the thumb's side; the thumb last
  Vector3d normal_root;               ///< outward palm normal in the root frame, joints above the palm at zero
  std::optional<bool> has_thumb;      ///< the last finger is a thumb
  std::optional<Handedness> handedness;
  bool has_surface = true;  ///< the fingers have meshes
};

/// Fingers: two to five of one to five joints, in a row with or without a thumb or around an axis. Each hand is placed,
/// turned, mirrored, and described (joint frames, axis signs, zeros, order) at random. One seed makes one hand.
RandomHand make_random_hand(std::uint64_t seed);

}  // namespace uhas::test
