#include "uhas/collision/surfaces/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

namespace uhas {
namespace {

/// Sets of vertices, each a tree whose root stands for it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t root(std::uint32_t element) {
    while (parent_[element] != element) element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace

std::vector<PieceExtremes> find_pieces(const TriangleMesh& mesh) {
  const auto place = [&mesh](std::uint32_t vertex) {
    const Vector3d& p = mesh.vertices[vertex];
    return std::tuple(p.x, p.y, p.z);
  };
  std::vector<std::uint32_t> by_place(mesh.vertices.size());
  std::iota(by_place.begin(), by_place.end(), 0u);
  std::ranges::sort(by_place, {}, place);

  DisjointSets sets(mesh.vertices.size());
  for (std::size_t i = 1; i < by_place.size(); ++i)
    if (place(by_place[i - 1]) == place(by_place[i])) sets.join(by_place[i - 1], by_place[i]);
  for (const auto& [a, b, c] : mesh.triangles) {
    sets.join(a, b);
    sets.join(b, c);
  }

  std::map<std::uint32_t, PieceExtremes> piece_of;  // root of its set
  for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    const Vector3d& p = mesh.vertices[vertex];
    PieceExtremes& extremes = piece_of.try_emplace(sets.root(vertex), PieceExtremes{p, p, p, p, p, p}).first->second;
    if (p.x < extremes[0].x) extremes[0] = p;
    if (p.x > extremes[1].x) extremes[1] = p;
    if (p.y < extremes[2].y) extremes[2] = p;
    if (p.y > extremes[3].y) extremes[3] = p;
    if (p.z < extremes[4].z) extremes[4] = p;
    if (p.z > extremes[5].z) extremes[5] = p;
  }
  std::vector<PieceExtremes> pieces;
  for (const auto& [root, extremes] : piece_of) pieces.push_back(extremes);
  return pieces;
}

double winding_number(const TriangleMesh& mesh, Vector3d p) {
  double half_angles = 0;
  for (const auto& triangle : mesh.triangles) {
    const Vector3d a = mesh.vertices[triangle[0]] - p, b = mesh.vertices[triangle[1]] - p,
                   c = mesh.vertices[triangle[2]] - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    // tan of half the solid angle (van Oosterom and Strackee, 1983)
    half_angles += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return half_angles / (2 * std::numbers::pi);
}

}  // namespace uhas
