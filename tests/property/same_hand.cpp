#include "same_hand.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <random>

#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas::test {
namespace {

constexpr int kActions = 50;
constexpr double kSolutionTolerance = 5e-3;  // rad; on the sphere, radii
constexpr double kEqualHits = 0.995;
constexpr int kVectors = 2;

std::vector<std::string> chain_of(const HandProfile& profile, const ProfileFinger& finger) {
  std::vector<std::string> names;
  for (int joint : finger.joints) names.push_back(profile.tree.joints[joint].name);
  return names;
}

/// One action for both hands: a finger gets the same inputs whichever slots it owns.
struct FingerInput {
  double delta_theta = 0;
  std::array<double, kVectors> delta_r{};
};

FingerInput random_input(std::mt19937_64& random) {
  std::uniform_real_distribution<double> theta(-0.5, 0.5), r(-1, 1);
  FingerInput input{theta(random), {}};
  for (double& value : input.delta_r) value = r(random);
  return input;
}

void write_input(const ProfileFinger& finger, const FingerInput& input, double theta_sign,
                 std::vector<double>& action) {
  for (int slot = 0; slot < kSlotCount; ++slot) {
    if (!finger.slots[slot]) continue;
    action[slot] = theta_sign * input.delta_theta;
    for (int j = 0; j < kVectors; ++j) action[kSlotCount + kVectors * slot + j] = input.delta_r[j];
  }
}

/// Fingertip in canonical coordinates of S, sphere radii: what an observation shows.
Vector3d canonical_tip(const HandProfile& profile, const ProfileFinger& finger, const std::vector<double>& q) {
  std::vector<RigidTransformd> T_palm_joint(q.size());
  forward_kinematics(profile.tree, q, T_palm_joint);
  const ProfileLink& link = profile.links[finger.tip_link];
  const Vector3d p = profile.T_palm_sphere.inverse() *
                     (T_palm_joint[link.joint] * (link.T_joint_link * finger.p_tip_link)) / profile.radius;
  return profile.mirrored ? Vector3d{p.x, -p.y, p.z} : p;
}

/// What the rays hit: link and radius. The azimuth and polar angle of a hit are those of its ray.
using Hits = std::map<std::pair<long, long>, std::pair<std::string, double>>;

Hits hits_by_ray(const HandProfile& profile, double theta_sign) {
  constexpr double grain = 1e-6;  // rad; rays are hundreds of times farther apart
  Hits hits;
  for (const Correspondence& point : profile.correspondences)
    hits[{std::lround(theta_sign * point.theta / grain), std::lround(point.phi / grain)}] = {
        profile.links[point.link].name, point.rho};
  return hits;
}

double share_of_equal_hits(const HandProfile& a, const HandProfile& b, double theta_sign) {
  constexpr double same_radius = 1e-3;  // radii
  const Hits hits_a = hits_by_ray(a, theta_sign), hits_b = hits_by_ray(b, 1);
  std::size_t equal = 0;
  for (const auto& [ray, hit] : hits_a) {
    const auto other = hits_b.find(ray);
    if (other != hits_b.end() && hit.first == other->second.first &&
        std::abs(hit.second - other->second.second) < same_radius)
      ++equal;
  }
  return static_cast<double>(equal) / static_cast<double>(std::max(hits_a.size(), hits_b.size()));
}

class Comparison {
 public:
  Comparison(const HandProfile& original, const HandProfile& changed, const Relation& relation)
      : original_(original), changed_(changed), relation_(relation) {
    for (std::size_t i = 0; i < changed.tree.joints.size(); ++i)
      joint_of_name_[changed.tree.joints[i].name] = static_cast<int>(i);
    // In the mirror, azimuths of a hand that is neither right nor left change sign, and with them the order of slots.
    if (relation.mirrored && original.handedness == Handedness::none) theta_sign_ = -1;
  }

  void run(const std::string& what, Extent extent) {
    REQUIRE(changed_.tree.joints.size() == original_.tree.joints.size());
    REQUIRE(changed_.fingers.size() == original_.fingers.size());
    CHECK(changed_.handedness == expected_handedness());
    CHECK(changed_.palm_link == original_.palm_link);
    CHECK(changed_.radius == doctest::Approx(relation_.scale * original_.radius).epsilon(1e-4));
    match_fingers();
    compare_joints();
    std::cout << original_.hand << ", " << what << ": poses differ by " << pose_difference_ << " rad";
    if (extent == Extent::tables) {
      std::cout << '\n';
      return;
    }
    compare_solutions();
    std::cout << ", solutions by " << solution_difference_ << " rad, fingertips by " << tip_difference_ << " radii";
    const double equal_hits = share_of_equal_hits(original_, changed_, theta_sign_);
    std::cout << ", " << 100 * equal_hits << " % of hits equal\n";
    CHECK(equal_hits >= kEqualHits);
  }

 private:
  Handedness expected_handedness() const {
    if (!relation_.mirrored || original_.handedness == Handedness::none) return original_.handedness;
    return original_.handedness == Handedness::right ? Handedness::left : Handedness::right;
  }

  /// The value of `changed`'s joint that means `q` of the original's.
  double translated(const Joint& joint, double q) const {
    const double sign = relation_.flipped.contains(joint.name) ? -1 : 1;
    return sign * q * (joint.kind == JointKind::prismatic ? relation_.scale : 1);
  }

  void match_fingers() {
    for (const ProfileFinger& finger : original_.fingers) {
      const std::vector<std::string> chain = chain_of(original_, finger);
      CAPTURE(chain.front());
      const auto same = std::find_if(changed_.fingers.begin(), changed_.fingers.end(),
                                     [&](const ProfileFinger& f) { return chain_of(changed_, f) == chain; });
      REQUIRE(same != changed_.fingers.end());
      finger_pairs_.emplace_back(&finger, &*same);
      if (theta_sign_ > 0) {
        CHECK(same->slots == finger.slots);
        CHECK(same->name == finger.name);
      }
      CHECK(std::abs(wrap_angle(same->theta_initial - theta_sign_ * finger.theta_initial)) < kSolutionTolerance);
      CHECK(std::abs(same->tip_phi - finger.tip_phi) < kSolutionTolerance);
      REQUIRE((same->lateral_table < 0) == (finger.lateral_table < 0));
      if (finger.lateral_table < 0) continue;
      const LateralTable& a = original_.lateral_tables[finger.lateral_table];
      const LateralTable& b = changed_.lateral_tables[same->lateral_table];
      const double lower = theta_sign_ > 0 ? a.delta_theta_lower : -a.delta_theta_upper;
      const double upper = theta_sign_ > 0 ? a.delta_theta_upper : -a.delta_theta_lower;
      CHECK(changed_.tree.joints[b.joint].name == original_.tree.joints[a.joint].name);
      CHECK(std::abs(b.delta_theta_lower - lower) < kSolutionTolerance);
      CHECK(std::abs(b.delta_theta_upper - upper) < kSolutionTolerance);
    }
  }

  void compare_joints() {
    for (std::size_t i = 0; i < original_.tree.joints.size(); ++i) {
      const Joint& joint = original_.tree.joints[i];
      CAPTURE(joint.name);
      REQUIRE(joint_of_name_.contains(joint.name));
      const JointTraits& a = original_.joint_traits[i];
      const JointTraits& b = changed_.joint_traits[joint_of_name_[joint.name]];
      CHECK(a.joint_class == b.joint_class);
      CHECK(a.flexed_probe == b.flexed_probe);
      CHECK(std::abs(a.margin - b.margin) < 0.01);
      compare_pose("q_open", joint, a.q_open, b.q_open);
      compare_pose("q_sphere", joint, a.q_sphere, b.q_sphere);
      // A side joint that closes to neither side has its closed end by convention, on a hand that is neither right nor
      // left the other end in the mirror: no rule can do without, for such a hand may be its own mirror image.
      if (theta_sign_ > 0 || a.joint_class == JointClass::encompassing)
        compare_pose("q_closed", joint, a.q_closed, b.q_closed);
    }
  }

  void compare_pose(const std::string& pose, const Joint& joint, double q_a, double q_b) {
    CAPTURE(pose);
    const double difference = std::abs(translated(joint, q_a) - q_b);
    pose_difference_ = std::max(pose_difference_, difference);
    CAPTURE(q_a);
    CAPTURE(q_b);
    CHECK(difference < kSolutionTolerance);
  }

  void compare_solutions() {
    CascadeSolver<double> solver_a(original_), solver_b(changed_);
    std::vector<double> q_a(original_.tree.joints.size()), q_b(q_a.size());
    std::mt19937_64 random(50);
    for (int n = 0; n < kActions; ++n) {
      std::vector<double> action_a(kSlotCount * (1 + kVectors)), action_b(action_a.size());
      for (const auto& [a, b] : finger_pairs_) {
        const FingerInput input = random_input(random);
        write_input(*a, input, 1, action_a);
        write_input(*b, input, theta_sign_, action_b);
      }
      REQUIRE(solver_a.solve({.values = action_a, .driving_vectors_phi = {}}, q_a) == Status::ok);
      REQUIRE(solver_b.solve({.values = action_b, .driving_vectors_phi = {}}, q_b) == Status::ok);
      for (std::size_t i = 0; i < q_a.size(); ++i) {
        const Joint& joint = original_.tree.joints[i];
        const double difference = std::abs(translated(joint, q_a[i]) - q_b[joint_of_name_[joint.name]]);
        solution_difference_ = std::max(solution_difference_, difference);
      }
      for (const auto& [a, b] : finger_pairs_) {
        Vector3d tip_a = canonical_tip(original_, *a, q_a);
        tip_a.y *= theta_sign_;
        tip_difference_ = std::max(tip_difference_, norm(tip_a - canonical_tip(changed_, *b, q_b)));
      }
    }
    CHECK(solution_difference_ < kSolutionTolerance);
    CHECK(tip_difference_ < kSolutionTolerance);
  }

  const HandProfile& original_;
  const HandProfile& changed_;
  const Relation& relation_;
  double theta_sign_ = 1;
  std::map<std::string, int> joint_of_name_;  ///< of `changed_`
  std::vector<std::pair<const ProfileFinger*, const ProfileFinger*>> finger_pairs_;
  double pose_difference_ = 0, solution_difference_ = 0, tip_difference_ = 0;
};

}  // namespace

void check_same_hand(const HandProfile& original, const HandProfile& changed, const Relation& relation,
                     const std::string& what, Extent extent) {
  CAPTURE(what);
  Comparison(original, changed, relation).run(what, extent);
}

}  // namespace uhas::test
