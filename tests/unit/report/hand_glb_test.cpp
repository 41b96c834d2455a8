// The file is read back with assimp: what a viewer would find in it.
#include "uhas/report/hand_glb.hpp"

#include <assimp/scene.h>
#include <doctest/doctest.h>

#include <assimp/Importer.hpp>
#include <map>

#include "support/mirrored_profile.hpp"
#include "support/small_profile.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/runtime/joint_groups.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kTolerance = 1e-6;  // m; the file holds floats

/// A tetrahedron on every link but the first.
HandGeometry some_geometry(const HandProfile& profile) {
  HandGeometry geometry;
  geometry.links.resize(profile.links.size());
  for (std::size_t i = 1; i < geometry.links.size(); ++i)
    geometry.links[i] = {{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01 * static_cast<double>(i)}},
                         {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  return geometry;
}

struct Part {
  const aiMesh* mesh;
  aiMatrix4x4 T_viewer_part;

  Vector3d point(unsigned i) const {
    const aiVector3D p = T_viewer_part * mesh->mVertices[i];
    return {p.x, p.y, p.z};
  }
};

/// The parts of a scene by the names of their nodes.
std::map<std::string, Part> parts_of(const aiScene& scene) {
  std::map<std::string, Part> parts;
  const aiNode& root = *scene.mRootNode;
  for (unsigned i = 0; i < root.mNumChildren; ++i) {
    const aiNode& node = *root.mChildren[i];
    REQUIRE(node.mNumMeshes == 1);
    parts[node.mName.C_Str()] = {scene.mMeshes[node.mMeshes[0]], root.mTransformation * node.mTransformation};
  }
  return parts;
}

/// A point of S as a viewer shows it: x up, z to the front.
Vector3d shown(Vector3d p) { return {-p.y, p.x, p.z}; }

void check_near(Vector3d a, Vector3d b) { CHECK(norm(a - b) < kTolerance); }

}  // namespace

TEST_CASE("a GLB file has the posed links, the points, the axes and the sphere") {
  for (const HandProfile& profile : {small_profile(), mirror_image(small_profile())}) {
    const HandGeometry geometry = some_geometry(profile);
    const std::vector<std::byte> bytes = hand_glb(profile, geometry, reference_posture(profile));
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
    REQUIRE_MESSAGE(scene, importer.GetErrorString());
    CHECK(scene->mRootNode->mName.C_Str() == profile.hand);
    const auto parts = parts_of(*scene);
    REQUIRE(parts.size() == profile.links.size() - 1 + 3);

    for (std::size_t i = 1; i < profile.links.size(); ++i) {
      CAPTURE(profile.links[i].name);
      const Part& part = parts.at(profile.links[i].name);
      CHECK(part.mesh->mNumVertices == geometry.links[i].vertices.size());
      CHECK(part.mesh->mNumFaces == geometry.links[i].triangles.size());
    }

    const Part& points = parts.at("correspondences");
    CHECK(points.mesh->mPrimitiveTypes == aiPrimitiveType_POINT);
    REQUIRE(points.mesh->mNumVertices == profile.correspondences.size());
    for (unsigned i = 0; i < points.mesh->mNumVertices; ++i) {
      const Correspondence& c = profile.correspondences[i];
      const double azimuth = profile.mirrored ? -c.theta : c.theta;
      check_near(points.point(i), shown(from_spherical<double>({azimuth, c.phi, c.rho * profile.radius})));
      if (c.link == 0) continue;  // a link's node carries its points to the same place
      const aiVector3D p(static_cast<float>(c.p_link.x), static_cast<float>(c.p_link.y),
                         static_cast<float>(c.p_link.z));
      const aiVector3D carried = parts.at(profile.links[c.link].name).T_viewer_part * p;
      check_near(points.point(i), {carried.x, carried.y, carried.z});
    }

    const Part& axes = parts.at("sphere_axes");
    CHECK(axes.mesh->mPrimitiveTypes == aiPrimitiveType_LINE);
    CHECK(axes.mesh->mNumFaces == 3);
    const Part& sphere = parts.at("sphere");
    CHECK(sphere.mesh->mNumFaces == 2 * 48 * 23);
    for (unsigned i = 0; i < sphere.mesh->mNumVertices; ++i)
      CHECK(norm(sphere.point(i)) == doctest::Approx(profile.radius).epsilon(1e-5));
  }
}

TEST_CASE("without meshes there are the points, the axes and the sphere") {
  const HandProfile profile = small_profile();
  const std::vector<std::byte> bytes = hand_glb(profile, {}, reference_posture(profile));
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, "glb");
  REQUIRE_MESSAGE(scene, importer.GetErrorString());
  CHECK(parts_of(*scene).size() == 3);
  CHECK(bytes == hand_glb(profile, {}, reference_posture(profile)));
}
