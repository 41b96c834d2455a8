// A mesh file: its first byte chooses the type, the rest is the content. Triangles that are sound, or an Error. A child
// process reads it first, as in the tools: what brings assimp down ends there. The rest is read here too, where the
// fuzzer sees what it reaches.
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "fuzz_file.hpp"
#include "uhas/model/meshes/mesh_reader.hpp"

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
  ModelLoadOptions here, in_child;
  here.max_triangles = in_child.max_triangles = 100'000;
  in_child.in_child = {.max_memory_bytes = 1u << 30, .max_seconds = 10};
  TriangleMesh mesh;
  const auto read = [&](const ModelLoadOptions& options) {
    const MeshFolders folders(path, options);
    SourceLog sources(std::filesystem::path(path).parent_path());
    const MeshFile file{path, name};
    mesh = std::move(read_meshes(std::span(&file, 1), options, folders, sources).front());
  };
  bool accepted_there = false;
  try {
    read(in_child);
    accepted_there = true;
  } catch (const Error& error) {
    const std::string_view why = error.what();
    if (why.find("was brought down") != why.npos || why.find("cannot be read within") != why.npos) return 0;
  }
  require(accepted([&] { read(here); }) == accepted_there);
  if (!accepted_there) return 0;
  require(mesh.triangles.size() <= here.max_triangles);
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t vertex : triangle) require(vertex < mesh.vertices.size());
  for (const Vector3d& p : mesh.vertices) require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  return 0;
}
