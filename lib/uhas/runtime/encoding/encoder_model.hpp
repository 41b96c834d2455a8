// The constant half of an encoder, and its linear start: the action read off a posture without solving.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

/// What an action says to one finger: delta theta (rad), then delta r of the V driving vectors (sphere radii).
using FingerAction = std::array<double, 1 + kMaxDrivingVectors>;

/// One number of a FingerAction that is sought.
struct Unknown {
  int finger;
  int number;  ///< 0 = delta theta, j = delta r of driving vector j
};

/// Fingers that cannot be encoded one without the other.
struct FingerGroup {
  std::vector<int> fingers;
  std::vector<int> joints;        ///< independent joints that move these fingers, and no finger of another group
  std::vector<Unknown> unknowns;  ///< displacements first, then the delta theta of fingers that have a lateral table
  int displacements = 0;          ///< how many of `unknowns` are displacements
};

/// A weighted surface point and the share of each driving vector in its displacement.
struct EncoderPoint {
  int joint;
  Vector3d p_joint;  ///< in the joint's moved frame (m)
  double rho, weight;
  std::array<double, kMaxDrivingVectors> hat;  ///< [V] interpolation weights at the point's polar angle
};

struct EncoderFinger {
  std::array<bool, kSlotCount> slots;
  FingerAction lower{}, upper{};  ///< bounds of an action; those of delta theta are 0 without a lateral table
  int lateral_table;              ///< -1 = none
  std::vector<EncoderPoint> points;
};

struct EncoderModel {
  EncoderModel(const HandProfile& profile, const SolveOptions& options, int vectors);

  /// The linear start (docs/method.md#encode-and-retarget): delta theta from the lateral tables, delta r by least squares
  /// of |p| / r - rho on the hats.
  /// @param q             [joint] followers where their masters put them
  /// @param T_palm_joint  [joint] room for the moved frames at `q`
  /// @param actions       [finger] out
  void start(std::span<const double> q, std::span<RigidTransformd> T_palm_joint,
             std::span<FingerAction> actions) const noexcept;

  /// The action that says `actions` [finger]: the same value in all slots of a finger. `values`: [5 + 5 V].
  template <class Real>
  void write_action(std::span<const FingerAction> actions, std::span<Real> values) const noexcept {
    for (std::size_t f = 0; f < fingers.size(); ++f) {
      for (int slot = 0; slot < kSlotCount; ++slot) {
        if (!fingers[f].slots[slot]) continue;
        values[slot] = static_cast<Real>(actions[f][0]);
        for (int j = 0; j < driving_vectors; ++j)
          values[kSlotCount + driving_vectors * slot + j] = static_cast<Real>(actions[f][1 + j]);
      }
    }
  }

  int driving_vectors;
  double radius;
  Vector3d center_palm;  ///< sphere centre in the palm frame (m)
  KinematicTree tree;
  std::vector<double> unit;  ///< [joint] what a residual counts as 1: 1 rad, or r (m) for a sliding joint
  std::vector<LateralTable> lateral_tables;
  std::vector<EncoderFinger> fingers;
  std::vector<FingerGroup> groups;
};

/// `profile` with wider limits of the encompassing joints: a joint held at a limit has no derivative, so a descent that
/// begins there would never find the way back to a posture inside.
HandProfile with_wider_limits(HandProfile profile);

}  // namespace uhas
