#include "uhas/runtime/encoding/encoder_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "uhas/kinematics/finger_groups.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

constexpr int kSamples = 512;
constexpr int kRowsASide = 4;  // of delta theta, beside that of 0

/// In every displacement starts are as far apart as this, radii: else they end in the same place.
constexpr double kApart = 0.2;

/// Fingers that share a joint are sought together; in the reading `field` all are, for each point follows two planes.
std::vector<std::vector<int>> fingers_sought_together(const HandProfile& profile, FieldReading field) {
  std::vector<std::vector<int>> joints;
  for (const ProfileFinger& finger : profile.fingers) joints.push_back(independent_joints(profile.tree, finger.joints));
  if (field == FieldReading::finger) return group_fingers(joints);
  std::vector<int> all;
  for (int f = static_cast<int>(joints.size()); f-- > 0;) all.push_back(f);
  return {all};
}

/// The joints and the unknowns of each group, displacements before azimuths: a descent that moves the displacements
/// alone takes the first of them.
std::vector<FingerGroup> compile_groups(const HandProfile& profile, FieldReading field, int vectors) {
  std::vector<FingerGroup> groups;
  for (std::vector<int>& fingers : fingers_sought_together(profile, field)) {
    FingerGroup group;
    std::vector<int> joints;
    for (int f : fingers)
      joints.insert(joints.end(), profile.fingers[f].joints.begin(), profile.fingers[f].joints.end());
    group.joints = independent_joints(profile.tree, joints);
    for (int f : fingers)
      for (int j = 1; j <= vectors; ++j) group.unknowns.push_back({f, j});
    group.displacements = static_cast<int>(group.unknowns.size());
    for (int f : fingers)
      if (profile.fingers[f].lateral_table >= 0) group.unknowns.push_back({f, 0});
    group.fingers = std::move(fingers);
    groups.push_back(std::move(group));
  }
  return groups;
}

EncoderFinger compile_finger(const HandProfile& profile, const ProfileFinger& finger, int vectors) {
  EncoderFinger compiled{.slots = finger.slots,
                         .lateral_table = finger.lateral_table,
                         .joints = independent_joints(profile.tree, finger.joints),
                         .postures = {}};
  for (int j = 1; j <= vectors; ++j) compiled.lower[j] = -kRadialBound, compiled.upper[j] = kRadialBound;
  if (finger.lateral_table >= 0) {
    const LateralTable& table = profile.lateral_tables[finger.lateral_table];
    compiled.lower[0] = table.delta_theta_lower, compiled.upper[0] = table.delta_theta_upper;
  }
  return compiled;
}

/// Element `index` of the van der Corput sequence: ever finer, evenly spread in [0, 1).
double van_der_corput(int index, int base) {
  double value = 0, digit = 1.0 / base;
  for (; index > 0; index /= base, digit /= base) value += digit * (index % base);
  return value;
}

/// From [0, 1) to displacements, denser where points fade: there a posture changes most.
double displacement_at(double share) {
  constexpr std::array<double, 4> shares{0, 0.2, 0.5, 1}, displacements{-kRadialBound, -1.05, -0.45, kRadialBound};
  int k = 0;
  while (share > shares[k + 1]) ++k;
  return std::lerp(displacements[k], displacements[k + 1], (share - shares[k]) / (shares[k + 1] - shares[k]));
}

/// The undeformed sphere, then Halton's points.
std::vector<FingerAction> sample_displacements(int vectors) {
  constexpr std::array<int, kMaxDrivingVectors> primes{2, 3, 5, 7};
  std::vector<FingerAction> samples(kSamples);
  for (int n = 1; n < kSamples; ++n)
    for (int j = 0; j < vectors; ++j) samples[n][1 + j] = displacement_at(van_der_corput(n, primes[j]));
  return samples;
}

/// Steps of delta theta from 0, to both bounds.
double rows_away(const EncoderFinger& finger, double delta_theta) {
  const double bound = delta_theta < 0 ? finger.lower[0] : finger.upper[0];
  return bound == 0 ? 0 : std::copysign(kRowsASide * delta_theta / bound, delta_theta);
}

}  // namespace

EncoderModel::EncoderModel(const HandProfile& profile, const SolveOptions& options, int vectors,
                           const CascadeSolver<double>& solver)
    : driving_vectors(vectors),
      tree(profile.tree),
      lateral_tables(profile.lateral_tables),
      groups(compile_groups(profile, options.field, vectors)),
      samples(sample_displacements(vectors)) {
  for (const Joint& joint : tree.joints) unit.push_back(joint.kind == JointKind::prismatic ? profile.radius : 1.0);
  for (const ProfileFinger& finger : profile.fingers) fingers.push_back(compile_finger(profile, finger, vectors));
  solve_samples(solver);
}

/// all fingers at once, each at its own delta theta of the row
void EncoderModel::solve_samples(CascadeSolver<double> solver) {
  std::vector<double> values(kSlotCount * (1 + driving_vectors)), q(tree.joints.size());
  std::vector<FingerAction> actions(fingers.size());
  constexpr int rows = 2 * kRowsASide + 1;
  for (EncoderFinger& finger : fingers)
    finger.postures.assign(rows, std::vector(finger.joints.size(), std::vector<float>(kSamples)));
  for (int row = 0; row < rows; ++row) {
    const double steps = row - kRowsASide;
    for (int n = 0; n < kSamples; ++n) {
      for (std::size_t f = 0; f < fingers.size(); ++f) {
        actions[f] = samples[n];
        actions[f][0] = std::abs(steps) / kRowsASide * (steps < 0 ? fingers[f].lower[0] : fingers[f].upper[0]);
      }
      write_action<double>(actions, values);
      solver.solve({.values = values, .driving_vectors_phi = {}}, q);
      for (EncoderFinger& finger : fingers)
        for (std::size_t i = 0; i < finger.joints.size(); ++i)
          finger.postures[row][i][n] = static_cast<float>(coordinate_of(finger.joints[i], q[finger.joints[i]]));
    }
  }
}

/// In residual units. A joint at a limit counts as beyond it: there a descent feels nothing, so it should start at
/// limits where the posture is at limits, and only there.
double EncoderModel::coordinate_of(int joint, double q) const noexcept {
  constexpr double beyond = 0.1, rounding = 1e-6;
  const Joint& j = tree.joints[joint];
  const double side = q <= j.lower + rounding ? -1 : q >= j.upper - rounding ? 1 : 0;
  return q / unit[joint] + side * beyond;
}

double EncoderModel::delta_theta_of(const EncoderFinger& finger, std::span<const double> q) const noexcept {
  if (finger.lateral_table < 0) return 0;
  const LateralTable& table = lateral_tables[finger.lateral_table];
  return look_up_delta_theta<double>(table.inverse_q, table.delta_theta_lower, table.delta_theta_upper, q[table.joint]);
}

SampledStart EncoderModel::start(const EncoderFinger& finger, std::span<const double> q,
                                 std::span<const FingerAction> taken, std::span<float> distances) const noexcept {
  const double delta_theta = delta_theta_of(finger, q);
  const auto& postures = finger.postures[kRowsASide + std::lround(rows_away(finger, delta_theta))];

  // squared
  std::fill(distances.begin(), distances.end(), 0.0f);
  for (std::size_t i = 0; i < finger.joints.size(); ++i) {
    const float sought = static_cast<float>(coordinate_of(finger.joints[i], q[finger.joints[i]]));
    for (int n = 0; n < kSamples; ++n) distances[n] += (postures[i][n] - sought) * (postures[i][n] - sought);
  }
  // none near a start before
  const auto is_near = [&](const FingerAction& a, const FingerAction& b) {
    for (int j = 1; j <= driving_vectors; ++j)
      if (std::abs(a[j] - b[j]) >= kApart) return false;
    return true;
  };
  for (const FingerAction& other : taken)
    for (int n = 0; n < kSamples; ++n)
      if (is_near(samples[n], other)) distances[n] = std::numeric_limits<float>::infinity();

  // the least of each eighth first: these are looked at side by side
  std::array<float, 8> least;
  least.fill(std::numeric_limits<float>::infinity());
  static_assert(kSamples % least.size() == 0);
  for (int n = 0; n < kSamples; n += static_cast<int>(least.size()))
    for (std::size_t k = 0; k < least.size(); ++k) least[k] = std::min(least[k], distances[n + k]);
  const auto nearest = std::find(distances.begin(), distances.end(), *std::min_element(least.begin(), least.end()));
  SampledStart start{samples[nearest - distances.begin()], std::sqrt(double(*nearest))};
  start.action[0] = delta_theta;
  return start;
}

}  // namespace uhas
