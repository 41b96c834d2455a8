// The constant half of an encoder: which fingers hang together, the bounds of their numbers, and sampled actions with the
// postures that they give, from which descents start.
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

/// A sampled action and how far its posture is from the one that is sought (rad).
struct SampledStart {
  FingerAction action;
  double distance;
};

struct EncoderFinger {
  std::array<bool, kSlotCount> slots;
  FingerAction lower{}, upper{};  ///< bounds of an action; those of delta theta are 0 without a lateral table
  int lateral_table;              ///< -1 = none
  std::vector<int> joints;        ///< independent ones
  /// [row of delta theta][of `joints`][sample] `coordinate_of` the joint in the posture that the sampled action gives
  std::vector<std::vector<std::vector<float>>> postures;
};

struct EncoderModel {
  EncoderModel(const HandProfile& profile, const SolveOptions& options, int vectors,
               const CascadeSolver<double>& solver);

  /// Where the lateral joint stands in the finger's table, exact for every posture that a solve gives.
  double delta_theta_of(const EncoderFinger& finger, std::span<const double> q) const noexcept;

  /// The sampled action whose posture comes nearest to `q` [joint], with the delta theta of `q`, away from `taken`.
  /// @param distances  [sample] room
  SampledStart start(const EncoderFinger& finger, std::span<const double> q, std::span<const FingerAction> taken,
                     std::span<float> distances) const noexcept;

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
  KinematicTree tree;
  std::vector<double> unit;  ///< [joint] what a residual counts as 1: 1 rad, or r (m) for a sliding joint
  std::vector<LateralTable> lateral_tables;
  std::vector<FingerGroup> groups;
  std::vector<FingerAction> samples;  ///< displacements; delta theta goes by row
  std::vector<EncoderFinger> fingers;

 private:
  double coordinate_of(int joint, double q) const noexcept;
  void solve_samples(CascadeSolver<double> solver);
};

}  // namespace uhas
