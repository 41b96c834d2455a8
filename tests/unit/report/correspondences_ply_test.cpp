#include "uhas/report/correspondences_ply.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "support/small_profile.hpp"
#include "uhas/report/sphere_colour.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("a PLY file has a point for each correspondence, where its sphere coordinates say") {
  HandProfile profile = small_profile();
  profile.hand = "two\nlines";
  std::istringstream file(correspondences_ply(profile));

  std::string line, header;
  std::vector<std::string> properties;
  std::size_t count = 0;
  REQUIRE(std::getline(file, line));
  CHECK(line == "ply");
  while (std::getline(file, line) && line != "end_header") {
    std::istringstream words(line);
    std::string keyword, kind, name;
    words >> keyword >> kind >> name;
    CHECK((keyword == "format" || keyword == "comment" || keyword == "element" || keyword == "property"));
    if (keyword == "element") count = std::stoul(name);
    if (keyword == "property") properties.push_back(name);
  }
  CHECK(properties == std::vector<std::string>{"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "theta", "phi",
                                               "rho", "weight", "link"});
  REQUIRE(count == profile.correspondences.size());

  for (const Correspondence& c : profile.correspondences) {
    Vector3d p, n;
    int red = -1, green = -1, blue = -1, link = -1;
    double theta = 0, phi = 0, rho = 0, weight = 0;
    file >> p.x >> p.y >> p.z >> n.x >> n.y >> n.z >> red >> green >> blue >> theta >> phi >> rho >> weight >> link;
    REQUIRE(file.good());
    const Spherical<double> s = to_spherical(p);
    CHECK((profile.mirrored ? -s.azimuth : s.azimuth) == doctest::Approx(theta).epsilon(1e-5));
    CHECK(s.polar == doctest::Approx(phi).epsilon(1e-5));
    CHECK(s.radius == doctest::Approx(rho * profile.radius).epsilon(1e-5));
    CHECK(norm(n) == doctest::Approx(1).epsilon(1e-4));
    CHECK(theta == doctest::Approx(c.theta).epsilon(1e-6));
    CHECK(weight == doctest::Approx(c.weight).epsilon(1e-6));
    CHECK(link == c.link);
    for (const int value : {red, green, blue}) CHECK((value >= 0 && value <= 255));
  }
  file >> line;
  CHECK(file.eof());
}

TEST_CASE("the sphere's colours tell azimuths and polar angles apart") {
  const auto difference = [](std::array<double, 3> a, std::array<double, 3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::abs(a[i] - b[i]);
    return sum;
  };
  for (int step = 0; step < 12; ++step) {
    const double theta = step * std::numbers::pi / 6, half = std::numbers::pi / 2;
    CHECK(difference(sphere_colour(theta, half), sphere_colour(theta + std::numbers::pi / 6, half)) > 0.05);
    CHECK(difference(sphere_colour(theta, half), sphere_colour(theta, half + 0.5)) > 0.05);
    CHECK(difference(sphere_colour(theta, half), sphere_colour(theta + 2 * std::numbers::pi, half)) < 1e-12);
    CHECK(difference(sphere_colour(0, 0), sphere_colour(theta, 0)) < 1e-12);
  }
}
