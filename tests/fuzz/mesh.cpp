// A mesh file: its first byte chooses the type, the rest is the content. Triangles that are sound, or an Error.
#include <array>
#include <cmath>

#include "fuzz_file.hpp"
#include "uhas/model/mesh_reader_detail.hpp"

using namespace uhas;
using namespace uhas::test;

// assimp 5.2.5 loses memory when it refuses a file; a tool ends then.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array types{"stl", "obj", "dae", "ply", "glb", "gltf"};
  const std::string name = std::string("mesh.") + types[data[0] % types.size()];
  const std::string path = input_file(name, as_text(data + 1, size - 1));
  LoadOptions options;
  options.max_triangles = 100'000;
  const detail::MeshFolders folders(path, options);
  detail::SourceLog sources(std::filesystem::path(path).parent_path());
  TriangleMesh mesh;
  if (!accepted([&] { mesh = detail::read_mesh(path, name, options, folders, sources); })) return 0;
  require(mesh.triangles.size() <= options.max_triangles);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertices.size());
  for (const Vector3d& p : mesh.vertices) require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  return 0;
}
