// Self-collision, judged without FCL: triangle by triangle, every pair of links that does not hold
// together (docs/method.md#self-collision).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "support/mesh_contact.hpp"
#include "support/random_action.hpp"
#include "support/real_profile.hpp"
#include "uhas/collision/collision_free_solver.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kPrecision = 1e-9;  // m
constexpr int kActions = 60, kPosesMeasured = 3, kPosesTouching = 20;

const HandGeometry& geometry() {
  static const HandGeometry result = hand_geometry(real_profile(), real_stages().model, real_hand().urdf.string());
  return result;
}

const SelfCollision& collision() {
  static const SelfCollision result(real_profile(), geometry());
  return result;
}

/// The links of the hand at `q`; null for one without geometry.
std::vector<std::unique_ptr<PlacedMesh>> place_links(const std::vector<double>& q) {
  const HandProfile& profile = real_profile();
  const std::vector<RigidTransformd> T_palm_link = link_poses(profile.tree, profile.links, q);
  std::vector<std::unique_ptr<PlacedMesh>> result(profile.links.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    if (const TriangleMesh& mesh = geometry().links[i]; !mesh.triangles.empty())
      result[i] = std::make_unique<PlacedMesh>(mesh, T_palm_link[i]);
  return result;
}

/// Names of two links that meet, of any pair not left out; empty when there are none.
std::string meeting_links(const std::vector<double>& q) {
  const auto links = place_links(q);
  for (const LinkPair& pair : collision().pairs())
    if (pair.use != LinkPairUse::adjacent && pair.use != LinkPairUse::touching &&
        meshes_cross(*links[pair.first], *links[pair.second]))
      return real_profile().links[pair.first].name + " and " + real_profile().links[pair.second].name;
  return {};
}

std::vector<double> undeformed_pose() {
  std::vector<double> q;
  for (const JointTraits& traits : real_profile().joint_traits) q.push_back(traits.q_sphere);
  return q;
}

std::vector<double> random_pose(std::mt19937_64& random) {
  std::vector<double> q;
  for (const Joint& joint : real_profile().tree.joints)
    q.push_back(std::uniform_real_distribution<double>(joint.lower, joint.upper)(random));
  apply_mimics(real_profile().tree, q);
  return q;
}

}  // namespace

TEST_CASE("what is left out as touching is in contact nearly always") {
  if (std::ranges::none_of(collision().pairs(), [](const LinkPair& pair) { return pair.use == LinkPairUse::touching; }))
    return;
  std::mt19937_64 random(5);
  std::vector<int> contacts(collision().pairs().size());
  for (int i = 0; i < kPosesTouching; ++i) {
    const auto links = place_links(random_pose(random));
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const LinkPair& pair = collision().pairs()[k];
      if (pair.use == LinkPairUse::touching) contacts[k] += meshes_cross(*links[pair.first], *links[pair.second]);
    }
  }
  for (std::size_t k = 0; k < contacts.size(); ++k)
    if (collision().pairs()[k].use == LinkPairUse::touching) CHECK(contacts[k] >= 0.75 * kPosesTouching);
}

TEST_CASE(
    "avoiding leaves no self-collision wherever the undeformed hand has none; the nearest links are the nearest") {
  const HandProfile& profile = real_profile();
  const std::string undeformed = meeting_links(undeformed_pose());
  CHECK(collision().collides(undeformed_pose()) == !undeformed.empty());

  CollisionFreeSolver solver(profile, {}, collision());
  CascadeSolver<double> plain(profile);
  std::mt19937_64 random(6);
  int colliding = 0, measured = 0;
  double least_scale = 1;
  for (int i = 0; i < kActions; ++i) {
    CAPTURE(i);
    const std::vector<double> action = random_action(random, 1, 2);
    std::vector<double> wanted(profile.tree.joints.size()), q(wanted.size());
    REQUIRE(plain.solve({.values = action}, wanted) == Status::ok);
    SolveReport report;
    const CollisionFreeSolution solution = solver.solve({.values = action}, q, report);
    REQUIRE(solution.status == Status::ok);

    const std::string meeting = meeting_links(wanted);
    colliding += !meeting.empty();
    if (!meeting.empty() && !undeformed.empty()) {
      CHECK_FALSE(solution.scale);
      CHECK(q == wanted);
      continue;
    }
    REQUIRE(solution.scale);
    least_scale = std::min(least_scale, *solution.scale);
    CHECK((*solution.scale == 1) == meeting.empty());
    CHECK(meeting_links(q) == "");

    if (measured++ >= kPosesMeasured) continue;
    const NearestLinks nearest = collision().nearest(q);
    CHECK_FALSE(nearest.colliding);
    const auto links = place_links(q);
    double least = nearest.distance + 1e-3;
    for (const LinkPair& pair : collision().pairs())
      if (pair.use == LinkPairUse::checked) least = mesh_distance(*links[pair.first], *links[pair.second], least);
    CHECK(std::abs(nearest.distance - least) < kPrecision);
    CHECK(std::abs(mesh_distance(*links[nearest.first], *links[nearest.second], 1) - nearest.distance) < kPrecision);
  }
  CHECK(colliding > 0);
  std::cout << real_hand().name << ": " << colliding << " of " << kActions << " actions collide"
            << (undeformed.empty() ? ", least scale " + std::to_string(least_scale) : ", undeformed too: " + undeformed)
            << '\n';
}
