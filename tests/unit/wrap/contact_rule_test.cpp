// The runtime's contact rule on an undeformed sphere is the wrap again: both must place the same nodes in
// the same order.
#include <doctest/doctest.h>

#include <cmath>

#include "support/sphere_hand.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/lateral_tables/lateral_tables.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// A profile without surface points; the first finger owns all slots but the thumb's.
HandProfile profile_of(const SphereHand& hand, const std::vector<JointClassification>& classes,
                       const std::vector<double>& q_closed, const LateralTables& tables) {
  HandProfile p;
  p.hand = hand.anatomy.hand;
  p.palm_link = p.root_link = "palm";
  p.T_palm_sphere = hand.frame.T_palm_sphere;
  p.radius = hand.frame.radius;
  p.mean_tip_distance = 1;
  p.tree = hand.anatomy.tree;
  p.links = hand.anatomy.links;
  p.lateral_tables = tables.tables;
  for (std::size_t i = 0; i < p.tree.joints.size(); ++i) {
    JointTraits traits;
    traits.joint_class = classes[i].joint_class;
    traits.q_open = hand.anatomy.q_open[i];
    traits.q_sphere = tables.q_sphere[i];
    traits.q_closed = q_closed[i];
    p.joint_traits.push_back(traits);
  }
  for (std::size_t f = 0; f < hand.anatomy.fingers.size(); ++f) {
    const FingerAnatomy& anatomy = hand.anatomy.fingers[f];
    ProfileFinger finger;
    finger.name = hand.frame.names[f];
    finger.slots.fill(f == 0);
    finger.slots[4] = f + 1 == hand.anatomy.fingers.size();
    finger.joints = anatomy.joints;
    finger.tip_link = anatomy.tip_link;
    finger.p_tip_link = anatomy.p_tip_link;
    finger.pad_normal_link = {0, 0, 1};
    finger.tip_distance = 1;
    finger.lateral_table = tables.table_of_finger[f];
    finger.theta_initial = to_spherical(hand.tip(static_cast<int>(f), tables.q_sphere)).azimuth;
    p.fingers.push_back(finger);
  }
  return p;
}

/// A finger with a side joint, a node that starts inside the sphere, and a coupled last pair; a thumb that slides.
SphereHand mixed_hand() {
  SphereHand hand;
  const Vector3d flexion{0, -1, 0};
  const int side = add_hinge(hand.tree(), -1, {0.1, 0.05, -1}, {0, 0, 1}, -0.3, 0.5);
  const int base = add_hinge(hand.tree(), side, {0.6, 0.05, -1}, flexion, -0.9, 1.8);
  const int master = add_hinge(hand.tree(), base, {0.8, 0.05, -1}, flexion, -0.9, 1.8);
  const int follower = add_follower(hand.tree(), master, {1.2, 0.05, -1}, flexion, master, 0.8);
  hand.add_finger({side, base, master, follower}, {1.5, 0.05, -1});
  const int slide = add_slide(hand.tree(), -1, {-1.5, 0, -0.6}, {1, 0, 0}, 0, 1);
  hand.add_finger({slide}, {-1.5, 0, -0.6});
  return hand;
}

}  // namespace

TEST_CASE("the contact rule wraps an undeformed sphere as the wrap does, for every turn of the lateral joint") {
  for (const double scale : {1.0, 0.08}) {
    const SphereHand hand = scaled(mixed_hand(), scale);
    const int side = 0;
    const std::vector<JointClassification> classes = classes_with(hand, {side});
    std::vector<double> q_closed;
    for (const Joint& joint : hand.anatomy.tree.joints) q_closed.push_back(joint.upper);
    apply_mimics(hand.anatomy.tree, q_closed);
    const LateralTables tables = build_lateral_tables(hand.anatomy, hand.frame, classes, q_closed);
    REQUIRE(tables.table_of_finger == std::vector<int>{0, -1});
    CascadeSolver<double> solver(profile_of(hand, classes, q_closed, tables), {.rule = CascadeRule::contact});

    for (const double delta_theta : {0.0, -0.2, 0.15}) {
      std::vector<double> action(15, 0.0), q(q_closed.size());
      std::fill_n(action.begin(), kSlotCount, delta_theta);
      action[4] = 0;
      REQUIRE(solver.solve({.values = action, .driving_vectors_phi = {}}, q) == Status::ok);
      CHECK((q[side] == tables.q_sphere[side]) == (delta_theta == 0));

      std::vector<double> wrapped = tables.q_sphere;
      wrapped[side] = q[side];
      wrap_on_sphere(hand.anatomy, hand.frame, classes, q_closed, wrapped);
      CAPTURE(delta_theta);
      for (std::size_t i = 0; i < q.size(); ++i) CHECK(std::abs(q[i] - wrapped[i]) <= 1e-9);
      for (int finger = 0; finger < 2; ++finger)
        CHECK(norm(hand.tip(finger, q)) == doctest::Approx(scale).epsilon(1e-9));
    }
  }
}
