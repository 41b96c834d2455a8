#include "uhas/lateral_tables/lateral_tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "uhas/base/errors.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/classification/finger_sweep.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/kinematics/lateral_lookup.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

/// A joint value and the canonical azimuth of the fingertip on the wrapped hand, unwrapped along the sweep.
struct Sample {
  double q, theta;
};

/// What every sweep of a hand needs.
struct Hand {
  const Anatomy& anatomy;
  const SphereFrame& frame;
  std::span<const JointClassification> classes;
  SphereWrapper& wrapper;

  bool is_free_lateral(int joint) const {
    return classes[joint].joint_class == JointClass::lateral && anatomy.tree.joints[joint].mimic_master < 0;
  }

  /// The pose wrapped with the lateral joints as they are in `q`.
  std::vector<double> wrapped(std::vector<double> q) const {
    apply_mimics(anatomy.tree, q);
    wrapper.wrap(q);
    return q;
  }

  /// Canonical azimuth of the fingertip on the hand wrapped with the lateral joints as they are in `q`, whose
  /// encompassing joints become scratch.
  double wrapped_azimuth(int finger, std::span<double> q) const {
    apply_mimics(anatomy.tree, q);
    wrapper.wrap_finger(finger, q);
    const double azimuth = to_spherical(fingertip_in_sphere(anatomy, frame, finger, q)).azimuth;
    return frame.mirrored ? -azimuth : azimuth;
  }
};

/// The finger whose azimuth a lateral joint's table records: of those that it, or a follower of it, belongs to, the one
/// with the lowest slot; -1 = none.
int finger_of(const Anatomy& anatomy, const SphereFrame& frame, int joint) {
  int lowest = -1;
  for (int f : fingers_moved(anatomy, joint))
    if (lowest < 0 || frame.own_slot[f] < frame.own_slot[lowest]) lowest = f;
  return lowest;
}

/// `count` samples of the joint from `first` to `last`, the other lateral joints as in `q`.
std::vector<Sample> sweep(const Hand& hand, int joint, int finger, std::vector<double> q, double first, double last,
                          int count) {
  std::vector<Sample> samples;
  for (int k = 0; k < count; ++k) {
    q[joint] = k + 1 == count ? last : first + (last - first) * k / (count - 1);
    const double azimuth = hand.wrapped_azimuth(finger, q);
    const double before = samples.empty() ? azimuth : samples.back().theta;
    samples.push_back({q[joint], before + wrap_angle(azimuth - before)});
  }
  return samples;
}

/// Rate of the azimuth between neighbouring samples, and the rates' median magnitude.
struct Rates {
  std::vector<double> rate;
  double median = 0;
};

Rates rates_of(std::span<const Sample> samples) {
  Rates rates;
  std::vector<double> magnitude;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    rates.rate.push_back((samples[k].theta - samples[k - 1].theta) / (samples[k].q - samples[k - 1].q));
    magnitude.push_back(std::abs(rates.rate.back()));
  }
  std::nth_element(magnitude.begin(), magnitude.begin() + magnitude.size() / 2, magnitude.end());
  rates.median = magnitude[magnitude.size() / 2];
  return rates;
}

/// Whether the wrap jumps between two samples (an encompassing joint goes over to another contact): halving the
/// interval again and again leaves most of the step in one half.
bool jumps(const Hand& hand, int joint, int finger, std::vector<double> q, Sample a, Sample b) {
  constexpr int halvings = 12;
  const double step = std::abs(b.theta - a.theta);
  for (int i = 0; i < halvings; ++i) {
    q[joint] = (a.q + b.q) / 2;
    const double azimuth = hand.wrapped_azimuth(finger, q);
    const Sample middle{q[joint], a.theta + wrap_angle(azimuth - a.theta)};
    (std::abs(middle.theta - a.theta) > std::abs(b.theta - middle.theta) ? b : a) = middle;
  }
  return std::abs(b.theta - a.theta) > step / 2;
}

/// The stretch of samples [first, last] with the widest azimuth range over which the azimuth runs one way,
/// nowhere slower than 5 % of the sweep's median rate (docs/method.md#lateral-tables), without a step from k to k
/// + 1 of which `jumps(k)`.
std::pair<int, int> widest_monotone_stretch(std::span<const Sample> samples, const std::function<bool(int k)>& jumps) {
  const Rates rates = rates_of(samples);
  const auto usable = [&](int k) {
    const double magnitude = std::abs(rates.rate[k]);
    if (magnitude == 0 || magnitude < 0.05 * rates.median) return false;
    constexpr double suspicious = 3;  // times the median; only such a step can hide a jump that matters
    return magnitude < suspicious * rates.median || !jumps(k);
  };

  // runs of usable steps with one sign, from the first sample on; the widest of them
  std::pair<int, int> best{0, 0};
  const auto extent = [&](std::pair<int, int> s) { return std::abs(samples[s.second].theta - samples[s.first].theta); };
  for (int first = 0; first < static_cast<int>(rates.rate.size());) {
    int last = first;
    while (last < static_cast<int>(rates.rate.size()) && (rates.rate[last] > 0) == (rates.rate[first] > 0) &&
           usable(last))
      ++last;
    if (extent({first, last}) > extent(best)) best = {first, last};
    first = std::max(last, first + 1);
  }
  return best;
}

/// Joint value where the piecewise-linear table reaches `theta`.
double invert(const LateralTable& table, double theta) {
  const bool rising = table.theta.back() > table.theta.front();
  const auto before = [&](double a, double b) { return rising ? a < b : a > b; };
  // the segment that holds theta, or the one at that end of the table; linear in it
  const auto above = std::lower_bound(table.theta.begin() + 1, table.theta.end() - 1, theta, before);
  const std::size_t k = above - table.theta.begin();
  const double share = (theta - table.theta[k - 1]) / (table.theta[k] - table.theta[k - 1]);
  return std::clamp(table.q[k - 1] + share * (table.q[k] - table.q[k - 1]), table.q[k - 1], table.q[k]);
}

/// Fills the inverse: knots are doubled until q -> theta -> q returns every sample well within the 1e-3 rad
/// it must hold.
void fill_inverse(LateralTable& table) {
  constexpr double round_trip = 2e-4;  // rad
  constexpr int most_knots = 1 << 14;
  for (int m = 64; m <= most_knots; m *= 2) {
    // m knots to each side of delta theta = 0, which returns neutral
    table.inverse_q.assign(2 * m + 1, table.neutral);
    for (int k = 1; k <= m; ++k) {
      table.inverse_q[m - k] = invert(table, table.theta_initial + table.delta_theta_lower * k / m);
      table.inverse_q[m + k] = invert(table, table.theta_initial + table.delta_theta_upper * k / m);
    }

    // the worst round trip over the samples
    double worst = 0;
    for (std::size_t i = 0; i < table.q.size(); ++i)
      worst = std::max(
          worst, std::abs(look_up_lateral<double>(table.inverse_q, table.delta_theta_lower, table.delta_theta_upper,
                                                  table.theta[i] - table.theta_initial) -
                          table.q[i]));
    if (worst <= round_trip) return;
  }
}

/// The table of `joint`, the other lateral joints as in `q`: a first sweep finds the stretch, a second one samples it
/// evenly about its middle, so that neutral is a sample of its own. A table that drives its finger has no jump in it;
/// one that only says where a joint's neutral is may have, since nobody runs through it. Empty, with neutral in the
/// middle of the limits, when fewer than three samples run one way.
LateralTable build_table(const Hand& hand, int joint, int finger, const std::vector<double>& q, int steps,
                         bool drives) {
  const auto stretch_of = [&](const std::vector<Sample>& samples) {
    return widest_monotone_stretch(
        samples, [&](int k) { return drives && jumps(hand, joint, finger, q, samples[k], samples[k + 1]); });
  };

  // a sweep of the whole range finds the stretch
  const Joint& j = hand.anatomy.tree.joints[joint];
  const std::vector<Sample> whole = sweep(hand, joint, finger, q, j.lower, j.upper, steps);
  const auto [first, last] = stretch_of(whole);

  LateralTable table;
  table.joint = joint;
  table.neutral = (j.lower + j.upper) / 2;
  if (first == last) return table;

  // a finer one of the stretch, which may end a little earlier now; its middle sample is neutral
  const std::vector<Sample> stretch = sweep(hand, joint, finger, q, whole[first].q, whole[last].q, steps | 1);
  const auto [begin, end] = stretch_of(stretch);
  const int half = (end - begin) / 2;
  if (half == 0) return table;
  // an odd number of steps has no sample in the middle: the slower end goes, whichever way the joint counts
  const auto speed = [&](int k) { return std::abs(stretch[k + 1].theta - stretch[k].theta); };
  const int spare = (end - begin) % 2 == 1 && speed(begin) < speed(end - 1) ? 1 : 0;
  const int middle = begin + spare + half;
  for (int k = middle - half; k <= middle + half; ++k) {
    table.q.push_back(stretch[k].q);
    table.theta.push_back(stretch[k].theta);
  }
  table.neutral = stretch[middle].q;

  // keep theta_initial within (-pi, pi], the rest of the table unwrapped about it
  table.theta_initial = wrap_angle(stretch[middle].theta);
  const double turns = table.theta_initial - stretch[middle].theta;
  for (double& theta : table.theta) theta += turns;
  table.theta[half] = table.theta_initial;  // whatever rounding made of it

  // what delta theta may be, and the way back from it to the joint
  table.delta_theta_lower = std::min(table.theta.front(), table.theta.back()) - table.theta_initial;
  table.delta_theta_upper = std::max(table.theta.front(), table.theta.back()) - table.theta_initial;
  fill_inverse(table);
  return table;
}

/// Whether the fingertip moves at least 0.3 of its distance from the joint per radian at the pose `q`.
bool moves_its_tip(const Hand& hand, int joint, int finger, std::vector<double> q) {
  constexpr double least_share = 0.3, step = 1e-4;
  if (hand.anatomy.tree.joints[joint].kind == JointKind::prismatic) return true;
  std::vector<RigidTransformd> T_palm_joint(q.size());
  forward_kinematics(hand.anatomy.tree, q, T_palm_joint);
  // the fingertip's way by a small step of the joint
  const Vector3d tip = fingertip_in_sphere(hand.anatomy, hand.frame, finger, q);
  const double arm = norm(hand.frame.T_palm_sphere * tip - T_palm_joint[joint].translation);
  set_with_followers(hand.anatomy.tree, joint, q[joint] + step, q);
  return norm(fingertip_in_sphere(hand.anatomy, hand.frame, finger, q) - tip) >= least_share * arm * step;
}

double azimuth_range(const LateralTable& table) { return table.delta_theta_upper - table.delta_theta_lower; }

}  // namespace

LateralTables build_lateral_tables(const Anatomy& anatomy, const SphereFrame& frame,
                                   std::span<const JointClassification> classes, std::span<const double> q_closed,
                                   const LateralTableOptions& options) {
  constexpr int fewest_steps = 11;
  if (options.steps < fewest_steps)
    throw Error(ErrorCode::invalid_config, "", "a lateral table of " + std::to_string(options.steps) + " steps",
                "use at least 11");
  SphereWrapper wrapper(anatomy, frame, classes, q_closed);
  const Hand hand{anatomy, frame, classes, wrapper};
  LateralTables result;
  result.table_of_finger.assign(anatomy.fingers.size(), -1);

  // every lateral joint by itself, the others open: this gives each its neutral value
  std::vector<double> q = anatomy.q_open;
  for (int joint = 0; joint < static_cast<int>(anatomy.tree.joints.size()); ++joint) {
    const int finger = finger_of(anatomy, frame, joint);
    if (!hand.is_free_lateral(joint) || finger < 0) continue;
    LateralTable table = build_table(hand, joint, finger, anatomy.q_open, options.steps, false);
    q[joint] = table.neutral;
    if (!table.q.empty()) result.tables.push_back(std::move(table));
  }
  const std::vector<double> q_neutral = hand.wrapped(q);

  // the joint that drives each finger; its table is measured again with the finger's other lateral joints at neutral
  for (int f = 0; f < static_cast<int>(anatomy.fingers.size()); ++f) {
    // a joint that moves its fingertip goes before one that hardly does, then the wider range
    const auto rank = [&](int t) {
      return std::pair(moves_its_tip(hand, result.tables[t].joint, f, q_neutral), azimuth_range(result.tables[t]));
    };
    int driver = -1;
    for (int t = 0; t < static_cast<int>(result.tables.size()); ++t)
      if (finger_of(anatomy, frame, result.tables[t].joint) == f && (driver < 0 || rank(t) > rank(driver))) driver = t;
    if (driver < 0) continue;
    LateralTable table = build_table(hand, result.tables[driver].joint, f, q, options.steps, true);
    if (table.q.empty()) continue;
    q[table.joint] = table.neutral;

    // a finger that can go to one side only is worth a word
    const double narrow = std::min(-table.delta_theta_lower, table.delta_theta_upper);
    const double wide = std::max(-table.delta_theta_lower, table.delta_theta_upper);
    constexpr double lopsided = 0.2;
    if (narrow < lopsided * wide)
      result.warnings.push_back("finger " + frame.names[f] + ": joint '" + anatomy.tree.joints[table.joint].name +
                                "' leaves little room for delta theta on one side of neutral");
    result.tables[driver] = std::move(table);
    result.table_of_finger[f] = driver;
  }
  result.q_sphere = hand.wrapped(q);
  return result;
}

}  // namespace uhas
