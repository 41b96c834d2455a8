// Observations against KDL, whose Jacobians come from urdfdom's tree and not from the profile
// (docs/method.md#observation).
#include "uhas/runtime/observation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <kdl/treefksolverpos_recursive.hpp>
#include <kdl/treejnttojacsolver.hpp>
#include <limits>
#include <random>
#include <vector>

#include "support/kdl_tree.hpp"
#include "support/mirrored_profile.hpp"
#include "support/real_profile.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr ObservationOptions kEverything{.points = {true, true, true, true, true, true, true}, .pad_directions = true};

KDL::Vector to_kdl(Vector3d a) { return {a.x, a.y, a.z}; }

KDL::Frame to_kdl(const RigidTransformd& T) {
  const auto& m = T.rotation.m;
  return {KDL::Rotation(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]), to_kdl(T.translation)};
}

/// The hand in KDL: frames and velocities of links in the URDF's root.
struct Reference {
  urdf::ModelInterfaceSharedPtr urdf = read_urdf(real_hand().urdf);
  KDL::Tree tree = kdl_tree(*urdf);
  KDL::TreeFkSolverPos_recursive frames{tree};
  KDL::TreeJntToJacSolver jacobians{tree};
  KDL::JntArray q, qd;

  void move_to(const JointValues& values, const JointValues& rates) {
    q = kdl_values(*urdf, tree, values);
    qd = kdl_values(*urdf, tree, rates, true);
  }
  KDL::Frame frame(const std::string& link) {
    KDL::Frame T;
    REQUIRE(frames.JntToCart(q, T, link) >= 0);
    return T;
  }
  /// Velocity of the link, referred to the point `p_root`.
  KDL::Twist velocity(const std::string& link, const KDL::Vector& p_root) {
    KDL::Jacobian jacobian(tree.getNrOfJoints());
    REQUIRE(jacobians.JntToJac(q, jacobian, link) >= 0);
    KDL::Twist twist;
    KDL::MultiplyJacobian(jacobian, qd, twist);
    return twist.RefPoint(p_root - frame(link).p);
  }
};

/// Any link that the joint carries.
const ProfileLink& link_of(const HandProfile& profile, int joint) {
  return *std::ranges::find(profile.links, joint, &ProfileLink::joint);
}

std::vector<const ProfileFinger*> owners_of_slots(const HandProfile& profile) {
  std::vector<const ProfileFinger*> owners;
  for (int slot = 0; slot < kSlotCount; ++slot)
    owners.push_back(&*std::ranges::find_if(profile.fingers, [=](const auto& f) { return f.slots[slot]; }));
  return owners;
}

struct Draw {
  JointValues values, rates;  // every independent joint of the URDF, wrists included
  std::vector<double> q, qd;  // the profile's joints
};

Draw random_draw(const HandProfile& profile, const Reference& reference, std::mt19937_64& random) {
  Draw draw;
  for (const auto& [name, joint] : reference.urdf->joints_) {
    if (joint->type == urdf::Joint::FIXED || joint->mimic) continue;
    const bool unlimited = joint->type == urdf::Joint::CONTINUOUS;
    const double lower = unlimited ? -3.0 : joint->limits->lower, upper = unlimited ? 3.0 : joint->limits->upper;
    draw.values[name] = std::uniform_real_distribution(lower, upper)(random);
    draw.rates[name] = std::uniform_real_distribution(-5.0, 5.0)(random);
  }
  for (const Joint& joint : profile.tree.joints) {
    draw.q.push_back(value_of(*reference.urdf, joint.name, draw.values));
    draw.qd.push_back(value_of(*reference.urdf, joint.name, draw.rates, true));
  }
  return draw;
}

template <class Real = double>
std::vector<Real> observe(const HandProfile& profile, const Draw& draw) {
  Observer<Real> observer(profile, kEverything);
  const std::vector<Real> q(draw.q.begin(), draw.q.end()), qd(draw.qd.begin(), draw.qd.end());
  std::vector<Real> observation(observer.size());
  REQUIRE(observer.observe(q, qd, observation) == Status::ok);
  return observation;
}

/// Largest difference of three numbers of the observation from `expected`, relative to a length above 1.
double error_at(const std::vector<double>& observation, std::size_t at, const KDL::Vector& expected) {
  const KDL::Vector found(observation[at], observation[at + 1], observation[at + 2]);
  return (found - expected).Norm() / std::max(1.0, expected.Norm());
}

}  // namespace

TEST_CASE("positions and velocities relative to the palm are KDL's") {
  const HandProfile& profile = real_profile();
  Reference reference;
  std::mt19937_64 random(1);
  const double m = profile.mirrored ? -1 : 1;
  double worst_position = 0, worst_velocity = 0;
  for (int n = 0; n < 200; ++n) {
    const Draw draw = random_draw(profile, reference, random);
    reference.move_to(draw.values, draw.rates);
    const std::vector<double> observation = observe(profile, draw);

    const KDL::Frame T_root_sphere = reference.frame(profile.palm_link) * to_kdl(profile.T_palm_sphere);
    const auto owners = owners_of_slots(profile);
    for (std::size_t slot = 0; slot < owners.size(); ++slot) {
      const auto points = finger_points(profile, static_cast<int>(owners[slot] - profile.fingers.data()));
      for (std::size_t k = 0; k < points.size(); ++k) {
        const ProfileLink& link = link_of(profile, points[k].joint);
        const KDL::Vector p_root = reference.frame(link.name) * to_kdl(link.T_joint_link.inverse() * points[k].p_joint);
        const KDL::Twist relative = T_root_sphere.M.Inverse(reference.velocity(link.name, p_root) -
                                                            reference.velocity(profile.palm_link, p_root));
        const KDL::Vector p = T_root_sphere.Inverse(p_root) / profile.radius, v = relative.vel / profile.radius,
                          w = relative.rot;
        const std::size_t at = kPointNumbers * (kFingerPoints * slot + k);
        worst_position = std::max(worst_position, error_at(observation, at, {p.x(), m * p.y(), p.z()}));
        worst_velocity = std::max(worst_velocity, error_at(observation, at + 3, {v.x(), m * v.y(), v.z()}));
        worst_velocity = std::max(worst_velocity, error_at(observation, at + 6, {m * w.x(), w.y(), m * w.z()}));
      }
      const KDL::Frame T_root_tip = reference.frame(profile.links[owners[slot]->tip_link].name);
      const KDL::Vector pad = T_root_sphere.M.Inverse(T_root_tip.M * to_kdl(owners[slot]->pad_normal_link));
      const std::size_t at = kPointNumbers * kFingerPoints * owners.size() + 3 * slot;
      worst_position = std::max(worst_position, error_at(observation, at, {pad.x(), m * pad.y(), pad.z()}));
    }
  }
  CHECK(worst_position <= 1e-9);
  CHECK(worst_velocity <= 1e-9);
  MESSAGE(profile.hand << ": worst position " << worst_position << ", worst velocity " << worst_velocity);
}

TEST_CASE("in the open pose the points divide KDL's chain from root to tip into equal parts") {
  const HandProfile& profile = real_profile();
  Reference reference;
  JointValues open;
  for (const auto& [name, joint] : reference.urdf->joints_) open[name] = 0;
  for (std::size_t i = 0; i < profile.tree.joints.size(); ++i)
    open[profile.tree.joints[i].name] = profile.joint_traits[i].q_open;
  reference.move_to(open, open);

  for (std::size_t f = 0; f < profile.fingers.size(); ++f) {
    const ProfileFinger& finger = profile.fingers[f];
    std::vector<KDL::Vector> corners;
    for (int joint : finger.joints)
      corners.push_back(reference.frame(reference.urdf->getJoint(profile.tree.joints[joint].name)->child_link_name).p);
    corners.push_back(reference.frame(profile.links[finger.tip_link].name) * to_kdl(finger.p_tip_link));
    double length = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) length += (corners[i] - corners[i - 1]).Norm();

    const auto points = finger_points(profile, static_cast<int>(f));
    for (int k = 0; k < kFingerPoints; ++k) {
      const ProfileLink& link = link_of(profile, points[k].joint);
      const KDL::Vector p = reference.frame(link.name) * to_kdl(link.T_joint_link.inverse() * points[k].p_joint);
      double least_distance = std::numeric_limits<double>::infinity(), way = 0, way_to_nearest = 0;
      for (std::size_t i = 1; i < corners.size(); ++i) {
        const KDL::Vector piece = corners[i] - corners[i - 1];
        const double squared = KDL::dot(piece, piece);
        const double share = squared > 0 ? std::clamp(KDL::dot(p - corners[i - 1], piece) / squared, 0.0, 1.0) : 0.0;
        const double distance = (p - corners[i - 1] - share * piece).Norm();
        if (distance < least_distance) least_distance = distance, way_to_nearest = way + share * piece.Norm();
        way += piece.Norm();
      }
      CAPTURE(finger.name);
      CAPTURE(k);
      CHECK(least_distance < 1e-9);
      CHECK(way_to_nearest == doctest::Approx(length * k / (kFingerPoints - 1)).epsilon(1e-6));
    }
    CHECK(points.back().joint == finger.joints.back());
  }
}

TEST_CASE("the mirror image of a hand is observed alike, and float agrees with double") {
  const HandProfile& profile = real_profile();
  const HandProfile image = mirror_image(profile);
  Reference reference;
  std::mt19937_64 random(2);
  double worst_image = 0, worst_float = 0;
  for (int n = 0; n < 100; ++n) {
    const Draw draw = random_draw(profile, reference, random);
    const std::vector<double> exact = observe(profile, draw), mirrored = observe(image, draw);
    const std::vector<float> rounded = observe<float>(profile, draw);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double size = std::max(1.0, std::abs(exact[i]));
      worst_image = std::max(worst_image, std::abs(mirrored[i] - exact[i]) / size);
      worst_float = std::max(worst_float, std::abs(double(rounded[i]) - exact[i]) / size);
    }
  }
  CHECK(worst_image <= 1e-12);
  CHECK(worst_float <= 1e-5);
  MESSAGE(profile.hand << ": worst mirror image " << worst_image << ", worst float " << worst_float);
}
