#include "uhas/model/meshes/mesh_bounds.hpp"

#include <algorithm>
#include <limits>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

// indices have 32 bits, and the largest number is taken for "no vertex"
constexpr std::uint64_t max_index = std::numeric_limits<std::uint32_t>::max() - 1;

}  // namespace

void require_within_bounds(std::uint64_t triangles, std::uint64_t vertices, std::uint64_t max_triangles,
                           const char* subject, const std::string& file) {
  if (triangles > max_triangles)
    throw Error(
        ErrorCode::limit_exceeded, file,
        std::string(subject) + " more triangles than the bound of " + std::to_string(max_triangles) + " for a hand",
        "simplify the model or raise ModelLoadOptions::max_triangles");
  const std::uint64_t max_vertices = 3 * std::min(max_triangles, max_index / 3);
  if (vertices > max_vertices)
    throw Error(ErrorCode::limit_exceeded, file,
                std::string(subject) + " more vertices than the bound of " + std::to_string(max_vertices) +
                    ", three for each triangle of a hand",
                "leave out unused ones or raise ModelLoadOptions::max_triangles");
}

}  // namespace uhas
