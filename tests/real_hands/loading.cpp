// Real hands load whole: every link that has geometry in the URDF has triangles, and they are where they belong.
#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include "support/real_hand.hpp"
#include "uhas/files/sha256.hpp"
#include "uhas/model/hand_model.hpp"

using namespace uhas;

namespace {

struct Box {
  Vector3d low, high;
  Vector3d size() const { return high - low; }
};

Box bounds(const TriangleMesh& mesh) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Vector3d& p : mesh.vertices) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

std::string read(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

// Names of the links whose element holds <geometry>, found by the letters of the file.
std::set<std::string> links_with_geometry(const std::string& urdf) {
  std::set<std::string> names;
  const std::regex link("<link\\s+name=\"([^\"]*)\"\\s*>([^]*?)</link>");
  for (std::sregex_iterator found(urdf.begin(), urdf.end(), link), end; found != end; ++found)
    if ((*found)[2].str().find("<geometry") != std::string::npos) names.insert((*found)[1]);
  return names;
}

HandModel load(GeometrySource geometry) {
  ModelLoadOptions options;
  options.geometry = geometry;
  return load_hand_model(test::real_hand().urdf, options);
}

}  // namespace

TEST_CASE("every link with geometry in the URDF has triangles, no other link has") {
  const HandModel model = load(GeometrySource::visual);
  const std::set<std::string> expected = links_with_geometry(read(test::real_hand().urdf));
  REQUIRE(expected.size() > 10);
  std::size_t triangles = 0;
  for (const ModelLink& link : model.links) {
    CHECK_MESSAGE(link.mesh.triangles.empty() == !expected.contains(link.name), link.name);
    triangles += link.mesh.triangles.size();
  }
  MESSAGE(test::real_hand().name << ": " << triangles << " triangles");
  CHECK(model.warnings.empty());
}

TEST_CASE("meshes keep their promises: indices in range, no degenerate triangle, no unused vertex") {
  for (const ModelLink& link : load(GeometrySource::both).links) {
    std::vector<bool> used(link.mesh.vertices.size());
    for (const auto& t : link.mesh.triangles) {
      for (const std::uint32_t v : t) used.at(v) = true;
      const auto& p = link.mesh.vertices;
      CHECK(norm(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) > 0);
    }
    CHECK(std::ranges::count(used, false) == 0);
  }
}

TEST_CASE("links are as large as parts of a hand, and visual and collision geometry are in one place") {
  const HandModel visual = load(GeometrySource::visual), collision = load(GeometrySource::collision);
  for (std::size_t i = 0; i < visual.links.size(); ++i) {
    const ModelLink& link = visual.links[i];
    if (link.mesh.vertices.empty()) continue;
    INFO(link.name);
    const Box seen = bounds(link.mesh), touched = bounds(collision.links[i].mesh);
    CHECK(norm(seen.size()) > 0.001);  // Shadow's thbase is a box of 1 mm
    CHECK(norm(seen.size()) < 0.5);
    // a box that was turned by a wrong up axis, or scaled, misses the other by its own size
    const double apart = std::max(norm(seen.low - touched.low), norm(seen.high - touched.high));
    CHECK(apart < 0.5 * std::max(norm(seen.size()), norm(touched.size())));
  }
}

TEST_CASE("the sources are the files read, by relative names") {
  const auto& hand = test::real_hand();
  const HandModel model = load(GeometrySource::visual);
  REQUIRE(model.sources.size() > 1);
  CHECK(model.sources[0].name == hand.urdf.filename());
  const std::string urdf = read(hand.urdf);
  CHECK(model.sources[0].sha256 == sha256_hex(std::as_bytes(std::span(urdf))));
  for (const SourceFile& source : model.sources) CHECK_FALSE(std::filesystem::path(source.name).is_absolute());
}

TEST_CASE("loading twice gives the same model") {
  const HandModel a = load(GeometrySource::visual), b = load(GeometrySource::visual);
  for (std::size_t i = 0; i < a.links.size(); ++i) {
    CHECK(a.links[i].name == b.links[i].name);
    CHECK(a.links[i].mesh.vertices == b.links[i].mesh.vertices);
    CHECK(a.links[i].mesh.triangles == b.links[i].mesh.triangles);
  }
}
