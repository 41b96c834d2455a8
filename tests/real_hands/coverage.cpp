// Correspondences of a real hand against oracles that know nothing of Embree: an area sampler and rays in double.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>

#include "support/real_profile.hpp"
#include "support/triangle_bvh.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// The hand at q_sphere: every link in S (m), its triangles, and all of them as an obstacle to rays from the centre.
struct WrappedHand {
  std::vector<RigidTransformd> T_sphere_link;
  std::vector<std::vector<test::Corners>> triangles;
  test::TriangleBvh bvh;
};

WrappedHand wrap_real_hand() {
  const BuildStages& stages = test::real_stages();
  const Anatomy& anatomy = stages.anatomy;
  std::vector<RigidTransformd> T_palm_joint(anatomy.tree.joints.size());
  forward_kinematics(anatomy.tree, stages.lateral_tables.q_sphere, T_palm_joint);
  const RigidTransformd T_sphere_palm = stages.sphere_frame.T_palm_sphere.inverse();

  std::vector<RigidTransformd> T_sphere_link;
  std::vector<std::vector<test::Corners>> triangles;
  std::vector<test::Corners> all;
  for (std::size_t i = 0; i < anatomy.links.size(); ++i) {
    const ProfileLink& link = anatomy.links[i];
    const RigidTransformd T_sphere_joint = link.joint < 0 ? T_sphere_palm : T_sphere_palm * T_palm_joint[link.joint];
    const RigidTransformd T = T_sphere_joint * link.T_joint_link;
    const TriangleMesh& mesh = stages.model.links[anatomy.model_links[i]].mesh;
    T_sphere_link.push_back(T);
    triangles.emplace_back();
    for (const auto& [a, b, c] : mesh.triangles)
      triangles.back().push_back({T * mesh.vertices[a], T * mesh.vertices[b], T * mesh.vertices[c]});
    all.insert(all.end(), triangles.back().begin(), triangles.back().end());
  }
  return {std::move(T_sphere_link), std::move(triangles), test::TriangleBvh(std::move(all))};
}

const WrappedHand& wrapped_hand() {
  static const WrappedHand hand = wrap_real_hand();
  return hand;
}

bool seen_from_centre(const test::TriangleBvh& bvh, Vector3d p) {
  constexpr double just_before = 1 - 1e-6;
  return bvh.first_hit({}, p, just_before) == just_before;
}

Vector3d area_normal(const test::Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Share of the link's area that faces the centre, is near the sphere and that nothing hides.
double visible_share(const WrappedHand& hand, const std::vector<test::Corners>& triangles, std::mt19937_64& generator) {
  std::vector<double> area;
  for (const test::Corners& triangle : triangles) area.push_back(norm(area_normal(triangle)));
  std::discrete_distribution<std::size_t> pick(area.begin(), area.end());
  std::uniform_real_distribution<double> uniform;
  const double radius = test::real_stages().sphere_frame.radius;
  constexpr int samples = 5000;
  int visible = 0;
  for (int i = 0; i < samples; ++i) {
    const test::Corners& t = triangles[pick(generator)];
    const double s = std::sqrt(uniform(generator)), u = uniform(generator);  // uniform on the triangle
    const Vector3d p = (1 - s) * t[0] + s * (1 - u) * t[1] + s * u * t[2];
    const bool faces = dot(area_normal(t), p) < 0;
    const bool near = std::abs(norm(p) / radius - 1) <= CorrespondenceOptions().max_radius_deviation;
    visible += faces && near && seen_from_centre(hand.bvh, p);
  }
  return visible / static_cast<double>(samples);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

TEST_CASE("every finger link of which the centre sees at least 0.5 % has points") {
  const WrappedHand& hand = wrapped_hand();
  std::mt19937_64 generator(20240601);
  int links_with_points = 0;
  for (std::size_t i = 0; i < hand.triangles.size(); ++i) {
    if (test::real_stages().anatomy.links[i].joint < 0 || hand.triangles[i].empty()) continue;
    const double share = visible_share(hand, hand.triangles[i], generator);
    const LinkHits& hits = test::real_stages().correspondences.hits[i];
    INFO(test::real_stages().anatomy.links[i].name, ": seen share ", share, ", kept ", hits.kept, ", too far ",
         hits.too_far, ", facing away ", hits.facing_away);
    if (share >= 0.005) CHECK(hits.kept > 0);
    links_with_points += hits.kept > 0;
  }
  CHECK(links_with_points >= static_cast<int>(2 * test::real_stages().anatomy.fingers.size()));
}

TEST_CASE("the points of each finger's distal link are near the sphere, thumbs apart") {
  const Anatomy& anatomy = test::real_stages().anatomy;
  for (int finger = 0; finger < static_cast<int>(anatomy.fingers.size()); ++finger) {
    if (finger == anatomy.thumb) continue;
    const int tip_link = anatomy.fingers[finger].tip_link;
    const ProfileLink& tip = anatomy.links[tip_link];
    // a fingertip may be a link without surface: the distal link is then whatever else its joint carries
    const bool has_points = test::real_stages().correspondences.hits[tip_link].kept > 0;
    std::vector<double> deviation;
    for (const Correspondence& point : test::real_stages().correspondences.points)
      if (has_points ? point.link == tip_link : anatomy.links[point.link].joint == tip.joint)
        deviation.push_back(std::abs(point.rho - 1));
    INFO("fingertip ", tip.name, ", ", deviation.size(), " points");
    REQUIRE(!deviation.empty());
    // The tip and the last joint lie on the sphere, so a link's surface stands before it by half its thickness
    // and the chord's sagitta. A thick finger whose plane misses the sphere's axis goes a little beyond the
    // bound: it is listed.
    constexpr double bound = 0.15, listed_bound = 0.16;
    if (median(deviation) > bound)
      std::cout << "LISTED: " << test::real_hand().name << ' ' << tip.name << ": median |rho - 1| " << median(deviation)
                << " is above " << bound << '\n';
    CHECK(median(deviation) <= listed_bound);
  }
}

TEST_CASE("correspondences lie on the surface that the centre sees, at the coordinates that they name") {
  const WrappedHand& hand = wrapped_hand();
  const std::vector<Correspondence>& points = test::real_stages().correspondences.points;
  REQUIRE(!points.empty());
  std::mt19937_64 generator(20240602);
  std::uniform_int_distribution<std::size_t> pick(0, points.size() - 1);
  for (int i = 0; i < 500; ++i) {
    const Correspondence& point = points[pick(generator)];
    const RigidTransformd& T_sphere_link = hand.T_sphere_link[point.link];
    const Vector3d p = T_sphere_link * point.p_link;
    INFO(test::real_stages().anatomy.links[point.link].name, " at theta ", point.theta, ", phi ", point.phi);
    CHECK(std::abs(hand.bvh.first_hit({}, p, 2) - 1) < 1e-6);
    CHECK(dot(T_sphere_link.rotation * point.normal_link, p) < 0);
    CHECK(norm(point.normal_link) == doctest::Approx(1).epsilon(1e-12));

    const double azimuth = test::real_stages().sphere_frame.mirrored ? -point.theta : point.theta;
    const Vector3d expected =
        from_spherical<double>({azimuth, point.phi, point.rho * test::real_stages().sphere_frame.radius});
    CHECK(norm(p - expected) < 1e-12);
  }
}

TEST_CASE("at most 32 points of each finger link have weights, no point of the palm has, and they sum to 1") {
  const Anatomy& anatomy = test::real_stages().anatomy;
  std::vector<int> chosen(anatomy.links.size()), kept(anatomy.links.size());
  double sum = 0;
  for (const Correspondence& point : test::real_stages().correspondences.points) {
    ++kept[point.link];
    chosen[point.link] += point.weight > 0;
    sum += point.weight;
  }
  for (std::size_t i = 0; i < anatomy.links.size(); ++i) {
    INFO(anatomy.links[i].name);
    CHECK(kept[i] == test::real_stages().correspondences.hits[i].kept);
    CHECK(chosen[i] == (anatomy.links[i].joint < 0 ? 0 : std::min(kept[i], 32)));
  }
  CHECK(sum == doctest::Approx(1).epsilon(1e-12));
}

}  // namespace uhas
