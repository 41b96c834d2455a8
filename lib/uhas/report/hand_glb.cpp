#include "uhas/report/hand_glb.hpp"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Exporter.hpp>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>

#include "uhas/base/homogeneous_matrix.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/report/posed_hand.hpp"
#include "uhas/report/sphere_colour.hpp"

namespace uhas {
namespace {

constexpr int kRings = 24;            // of the sphere's mesh, from pole to pole; twice as many steps around
constexpr double kAxisLength = 1.25;  // sphere radii

/// Corners, their colours (as many or none) and the primitives between them, all of one kind.
struct Shape {
  std::string name;
  int corners_of_primitive = 3;  // 1 points, 2 lines, 3 triangles
  std::vector<Vector3d> positions{};
  std::vector<std::array<double, 3>> colours{};  // linear
  std::vector<std::uint32_t> corners{};
  RigidTransformd T_sphere_shape{};
  double opacity = 1;
};

Shape link_shape(const std::string& name, const TriangleMesh& mesh, const RigidTransformd& T_sphere_link) {
  Shape shape{.name = name, .positions = mesh.vertices, .T_sphere_shape = T_sphere_link};
  for (const auto& triangle : mesh.triangles)
    shape.corners.insert(shape.corners.end(), triangle.begin(), triangle.end());
  return shape;
}

Shape sphere_shape(const HandProfile& profile) {
  Shape shape{.name = "sphere", .opacity = 0.25};
  const double sign = profile.mirrored ? -1 : 1;
  for (int ring = 0; ring <= kRings; ++ring) {
    for (int step = 0; step <= 2 * kRings; ++step) {
      const double theta = std::numbers::pi * step / kRings, phi = std::numbers::pi * ring / kRings;
      shape.positions.push_back(from_spherical<double>({theta, phi, profile.radius}));
      shape.colours.push_back(sphere_colour(sign * theta, phi));
    }
  }
  const auto at = [](int ring, int step) { return static_cast<std::uint32_t>(ring * (2 * kRings + 1) + step); };
  for (int ring = 0; ring < kRings; ++ring) {
    for (int step = 0; step < 2 * kRings; ++step) {
      const std::uint32_t a = at(ring, step), b = at(ring + 1, step), c = at(ring + 1, step + 1),
                          d = at(ring, step + 1);
      if (ring < kRings - 1) shape.corners.insert(shape.corners.end(), {a, c, b});
      if (ring > 0) shape.corners.insert(shape.corners.end(), {a, d, c});
    }
  }
  return shape;
}

Shape axes_shape(const HandProfile& profile) {
  const double length = kAxisLength * profile.radius;
  return {.name = "sphere_axes",
          .corners_of_primitive = 2,
          .positions = {{}, {length, 0, 0}, {}, {0, length, 0}, {}, {0, 0, length}},
          .colours = {{1, 0, 0}, {1, 0, 0}, {0, 0.5, 0}, {0, 0.5, 0}, {0, 0, 1}, {0, 0, 1}},
          .corners = {0, 1, 2, 3, 4, 5}};
}

Shape correspondence_shape(const HandProfile& profile, std::span<const RigidTransformd> T_sphere_link) {
  Shape shape{.name = "correspondences", .corners_of_primitive = 1};
  for (const Correspondence& c : profile.correspondences) {
    shape.corners.push_back(static_cast<std::uint32_t>(shape.positions.size()));
    shape.positions.push_back(T_sphere_link[c.link] * c.p_link);
    shape.colours.push_back(sphere_colour(c.theta, c.phi));
  }
  return shape;
}

aiMatrix4x4 to_assimp(const RigidTransformd& T) {
  const auto m = homogeneous_matrix<ai_real>(T);
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9], m[10], m[11], m[12], m[13], m[14], m[15]};
}

// assimp's structures own their arrays and delete them; until they have them, unique_ptr does

std::unique_ptr<aiMesh> to_assimp(const Shape& shape, unsigned material) {
  auto mesh = std::make_unique<aiMesh>();
  mesh->mName = shape.name;
  mesh->mMaterialIndex = material;
  mesh->mPrimitiveTypes = shape.corners_of_primitive == 1   ? aiPrimitiveType_POINT
                          : shape.corners_of_primitive == 2 ? aiPrimitiveType_LINE
                                                            : aiPrimitiveType_TRIANGLE;
  mesh->mNumVertices = static_cast<unsigned>(shape.positions.size());
  mesh->mVertices = new aiVector3D[shape.positions.size()];
  std::ranges::transform(shape.positions, mesh->mVertices, [](Vector3d p) {
    return aiVector3D(static_cast<ai_real>(p.x), static_cast<ai_real>(p.y), static_cast<ai_real>(p.z));
  });
  if (!shape.colours.empty()) {
    mesh->mColors[0] = new aiColor4D[shape.colours.size()];
    std::ranges::transform(shape.colours, mesh->mColors[0], [&](const std::array<double, 3>& colour) {
      return aiColor4D(static_cast<ai_real>(colour[0]), static_cast<ai_real>(colour[1]),
                       static_cast<ai_real>(colour[2]), static_cast<ai_real>(shape.opacity));
    });
  }
  const auto n = static_cast<unsigned>(shape.corners_of_primitive);
  mesh->mNumFaces = static_cast<unsigned>(shape.corners.size() / n);
  mesh->mFaces = new aiFace[mesh->mNumFaces];
  for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
    mesh->mFaces[i].mNumIndices = n;
    mesh->mFaces[i].mIndices = new unsigned[n];
    std::copy_n(shape.corners.begin() + i * n, n, mesh->mFaces[i].mIndices);
  }
  return mesh;
}

std::unique_ptr<aiMaterial> material_of(const Shape& shape) {
  auto material = std::make_unique<aiMaterial>();
  const aiString name(shape.name);
  const ai_real grey = shape.colours.empty() ? ai_real(0.55) : ai_real(1);
  const aiColor4D colour(grey, grey, grey, static_cast<ai_real>(shape.opacity));
  const ai_real metallic = 0, roughness = ai_real(0.8);
  const int both_sides = 1;
  material->AddProperty(&name, AI_MATKEY_NAME);
  material->AddProperty(&colour, 1, AI_MATKEY_BASE_COLOR);
  material->AddProperty(&metallic, 1, AI_MATKEY_METALLIC_FACTOR);
  material->AddProperty(&roughness, 1, AI_MATKEY_ROUGHNESS_FACTOR);
  material->AddProperty(&both_sides, 1, AI_MATKEY_TWOSIDED);
  if (shape.opacity < 1) {
    const aiString mode("BLEND");
    material->AddProperty(&mode, AI_MATKEY_GLTF_ALPHAMODE);
  }
  return material;
}

std::unique_ptr<aiScene> to_assimp(const std::string& hand, std::span<const Shape> shapes) {
  const auto count = static_cast<unsigned>(shapes.size());
  auto scene = std::make_unique<aiScene>();
  scene->mMeshes = new aiMesh*[count];
  scene->mMaterials = new aiMaterial*[count];
  scene->mRootNode = new aiNode(hand);
  // x of S, along the fingers, up; z of S, out of the palm, toward the viewer
  scene->mRootNode->mTransformation = to_assimp({Rotationd::from_columns({0, 1, 0}, {-1, 0, 0}, {0, 0, 1}), {}});
  scene->mRootNode->mChildren = new aiNode*[count];
  for (unsigned i = 0; i < count; ++i) {
    scene->mMeshes[i] = to_assimp(shapes[i], i).release();
    scene->mMaterials[i] = material_of(shapes[i]).release();
    scene->mNumMeshes = scene->mNumMaterials = i + 1;
    auto* node = new aiNode(shapes[i].name);
    node->mTransformation = to_assimp(shapes[i].T_sphere_shape);
    node->mParent = scene->mRootNode;
    node->mNumMeshes = 1;
    node->mMeshes = new unsigned[1]{i};
    scene->mRootNode->mChildren[i] = node;
    scene->mRootNode->mNumChildren = i + 1;
  }
  return scene;
}

}  // namespace

std::vector<std::byte> hand_glb(const HandProfile& profile, const HandGeometry& geometry, std::span<const double> q) {
  const std::vector<RigidTransformd> T_sphere_link = link_poses_in_sphere(profile, q);
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < geometry.links.size(); ++i)
    if (!geometry.links[i].triangles.empty())
      shapes.push_back(link_shape(profile.links[i].name, geometry.links[i], T_sphere_link[i]));
  if (!profile.correspondences.empty()) shapes.push_back(correspondence_shape(profile, T_sphere_link));
  shapes.push_back(axes_shape(profile));
  shapes.push_back(sphere_shape(profile));

  const std::unique_ptr<aiScene> scene = to_assimp(profile.hand, shapes);
  Assimp::Exporter exporter;
  const aiExportDataBlob* blob = exporter.ExportToBlob(scene.get(), "glb2");
  if (!blob) throw std::runtime_error(std::string("the scene cannot be written as GLB: ") + exporter.GetErrorString());
  const auto* bytes = static_cast<const std::byte*>(blob->data);
  return {bytes, bytes + blob->size};
}

}  // namespace uhas
