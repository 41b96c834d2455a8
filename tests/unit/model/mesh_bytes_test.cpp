// What a child process hands over of a mesh comes back as it was; bytes that are no mesh are refused.
#include "uhas/model/meshes/mesh_bytes.hpp"

#include "model_fixture.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

ReadMesh two_triangles() {
  ReadMesh read;
  read.mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5}};
  read.mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  read.sources = {{{"hand.urdf", std::string(64, 'a')}, "/hand/hand.urdf"},
                  {{"meshes/palm.stl", std::string(64, 'b')}, "/hand/meshes/palm.stl"}};
  return read;
}

bool same(const ReadMesh& a, const ReadMesh& b) {
  return a.mesh.vertices == b.mesh.vertices && a.mesh.triangles == b.mesh.triangles && a.sources == b.sources;
}

}  // namespace

TEST_CASE("a mesh and its sources come back as they were, an empty one too") {
  for (const ReadMesh& read : {two_triangles(), ReadMesh{}})
    CHECK(same(read_mesh_from_bytes(to_bytes(read), "a.stl"), read));
}

TEST_CASE("bytes that end early are refused, unless they end after a source") {
  const std::vector<std::byte> bytes = to_bytes(two_triangles());
  std::size_t whole = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    try {
      const ReadMesh read = read_mesh_from_bytes(std::span(bytes).first(size), "a.stl");
      CHECK(read.sources.size() < 2);
      ++whole;
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::invalid_mesh);
      CHECK(error.what() == std::string("a.stl: the process that read it handed over no mesh; do not trust the file"));
    }
  }
  CHECK(whole == 2);  // no source, the first source
}

TEST_CASE("a length beyond the bytes is refused before it is allocated") {
  std::vector<std::byte> bytes = to_bytes(two_triangles());
  std::fill_n(bytes.begin(), 8, std::byte{0xff});
  CHECK_THROWS_AS(read_mesh_from_bytes(bytes, "a.stl"), Error);
}
