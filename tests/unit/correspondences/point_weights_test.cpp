#include "uhas/correspondences/point_weights.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace uhas {
namespace {

double distance(const Correspondence& a, const Correspondence& b) { return norm(a.p_link - b.p_link); }

std::vector<Correspondence> random_points(int link, int count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> coordinate(-0.02, 0.02);
  std::vector<Correspondence> points(count);
  for (Correspondence& point : points) {
    point.link = link;
    point.p_link = {coordinate(generator), coordinate(generator), coordinate(generator)};
  }
  return points;
}

std::vector<Correspondence> chosen(const std::vector<Correspondence>& points) {
  std::vector<Correspondence> result;
  std::ranges::copy_if(points, std::back_inserter(result),
                       [](const Correspondence& point) { return point.weight > 0; });
  return result;
}

double weight_sum(const std::vector<Correspondence>& points) {
  double sum = 0;
  for (const Correspondence& point : points) sum += point.weight;
  return sum;
}

const std::vector<ProfileLink> kPalmAndTwoLinks{{"palm", -1, {}}, {"proximal", 0, {}}, {"distal", 1, {}}};

}  // namespace

TEST_CASE("chosen points cover the link at least as closely as they are apart") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::vector<Correspondence> points = random_points(1, 500, seed);
    assign_point_weights(points, kPalmAndTwoLinks, 32);
    const std::vector<Correspondence> few = chosen(points);
    REQUIRE(few.size() == 32);
    double packing = 1, covering = 0;
    for (std::size_t i = 0; i < few.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) packing = std::min(packing, distance(few[i], few[j]));
    for (const Correspondence& point : points) {
      double gap = 1;
      for (const Correspondence& other : few) gap = std::min(gap, distance(point, other));
      covering = std::max(covering, gap);
    }
    CHECK(covering <= packing);
  }
}

TEST_CASE("a weight is the share of the hand's points that are nearest to the chosen one") {
  // three points near the left end, one at the right end: two are chosen, and they weigh 3 : 1
  std::vector<Correspondence> points(4);
  for (int i = 0; i < 4; ++i) points[i].link = 1;
  points[0].p_link = {-0.1, 0, 0};
  points[1].p_link = {0, 0, 0};  // nearest to the mean, 0.2
  points[2].p_link = {-0.1, 0.01, 0};
  points[3].p_link = {1, 0, 0};
  assign_point_weights(points, kPalmAndTwoLinks, 2);
  CHECK(points[0].weight == 0);
  CHECK(points[1].weight == 0.75);
  CHECK(points[2].weight == 0);
  CHECK(points[3].weight == 0.25);
}

TEST_CASE("every link that a joint carries is weighed by its own points, the palm not at all") {
  std::vector<Correspondence> points;
  for (const auto& [link, count] : {std::pair{0, 400}, {1, 300}, {2, 10}})
    std::ranges::copy(random_points(link, count, 7), std::back_inserter(points));
  assign_point_weights(points, kPalmAndTwoLinks, 32);
  int of_link[3] = {};
  double weight_of_link[3] = {};
  for (const Correspondence& point : points) {
    of_link[point.link] += point.weight > 0;
    weight_of_link[point.link] += point.weight;
  }
  CHECK(of_link[0] == 0);
  CHECK(of_link[1] == 32);
  CHECK(of_link[2] == 10);
  CHECK(weight_of_link[1] == doctest::Approx(300.0 / 310));
  CHECK(weight_sum(points) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("the choice does not change when the points are mirrored or doubled in size") {
  std::vector<Correspondence> points = random_points(1, 300, 11), image = points;
  for (Correspondence& point : image) point.p_link = 2.0 * Vector3d{point.p_link.x, -point.p_link.y, point.p_link.z};
  assign_point_weights(points, kPalmAndTwoLinks, 16);
  assign_point_weights(image, kPalmAndTwoLinks, 16);
  for (std::size_t i = 0; i < points.size(); ++i) CHECK(points[i].weight == image[i].weight);
}

TEST_CASE("points in one place are one point, and no points are no error") {
  std::vector<Correspondence> points(5);
  for (Correspondence& point : points) point.link = 1;
  assign_point_weights(points, kPalmAndTwoLinks, 32);
  CHECK(points[0].weight == 1);
  CHECK(chosen(points).size() == 1);

  std::vector<Correspondence> none;
  assign_point_weights(none, kPalmAndTwoLinks, 32);
  std::vector<Correspondence> palm_only = random_points(0, 10, 3);
  assign_point_weights(palm_only, kPalmAndTwoLinks, 32);
  CHECK(chosen(palm_only).empty());
}

}  // namespace uhas
