// The PLY reader by itself: every type of number, and what is said of each mistake in a file.
#include "uhas/model/meshes/ply_reader.hpp"

#include <algorithm>
#include <span>

#include "mesh_files.hpp"
#include "model_fixture.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr const char* kVertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
constexpr const char* kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
constexpr const char* kCorners = "0 0 0\n1 0 0\n0 1 0\n";

TriangleMesh read(const std::string& text, std::uint64_t max_triangles = 100) {
  return read_ply(std::as_bytes(std::span(text)), "a.ply", max_triangles);
}

std::string ascii(const std::string& elements, const std::string& body = "") {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
}

void check_refused(const std::string& text, const std::string& problem) {
  check_error([&] { read(text); }, ErrorCode::invalid_mesh, {"a.ply: " + problem + "; export the mesh again"});
}

/// The x of a vertex whose x has that type and whose y and z are unsigned bytes.
template <class Number>
double x_read_back(const std::string& type, Number x, bool big_endian) {
  std::string number;
  append_bytes(number, x);
  if (big_endian) std::ranges::reverse(number);  // this machine's order is little-endian
  const TriangleMesh mesh =
      read(std::string("ply\nformat binary_") + (big_endian ? "big" : "little") + "_endian 1.0\nelement vertex 1\n" +
           "property " + type + " x\nproperty uchar y\nproperty uint8 z\nend_header\n" + number + "\x07\x09");
  REQUIRE(mesh.vertices.size() == 1);
  CHECK(mesh.vertices[0].y == 7);
  CHECK(mesh.vertices[0].z == 9);
  return mesh.vertices[0].x;
}

}  // namespace

TEST_CASE("every type of number is read under both of its names, in both byte orders") {
  for (const bool big_endian : {false, true}) {
    CAPTURE(big_endian);
    for (const char* type : {"char", "int8"}) CHECK(x_read_back(type, std::int8_t{-100}, big_endian) == -100);
    for (const char* type : {"uchar", "uint8"}) CHECK(x_read_back(type, std::uint8_t{200}, big_endian) == 200);
    for (const char* type : {"short", "int16"}) CHECK(x_read_back(type, std::int16_t{-30000}, big_endian) == -30000);
    for (const char* type : {"ushort", "uint16"}) CHECK(x_read_back(type, std::uint16_t{60001}, big_endian) == 60001);
    for (const char* type : {"int", "int32"}) CHECK(x_read_back(type, -2'000'000'001, big_endian) == -2'000'000'001);
    for (const char* type : {"uint", "uint32"}) CHECK(x_read_back(type, 4'000'000'001u, big_endian) == 4'000'000'001.);
    for (const char* type : {"float", "float32"}) CHECK(x_read_back(type, 0.15625f, big_endian) == 0.15625);
    for (const char* type : {"double", "float64"}) CHECK(x_read_back(type, 0.1, big_endian) == 0.1);
  }
}

TEST_CASE("a mistake in the header is named") {
  check_refused("", "the PLY header does not end");
  check_refused("ply\nformat ascii 1.0\nend_header", "the PLY header does not end");
  check_refused("plyer\n", "this is not a PLY file");
  check_refused("ply\nformat text 1.0\nend_header\n", "the PLY header names an unknown format");
  check_refused(ascii("element vertex\n"), "the PLY header has an element without name or count");
  check_refused(ascii("element vertex many\n"), "the PLY header has an element without name or count");
  check_refused(ascii("property float x\nelement vertex 1\n"),
                "the PLY header has a property before the first element");
  check_refused(ascii("element vertex 1\n"), "the PLY header has an element without properties");
  check_refused(ascii("element vertex 1\nproperty half x\n"), "the PLY header names an unknown type");
  check_refused(ascii("element face 1\nproperty list real int vertex_indices\n"),
                "the PLY header names an unknown type");
  check_refused(ascii("element vertex 1\nproperty float\n"), "the PLY header has a property without name");
}

TEST_CASE("a mistake in the numbers is named") {
  const std::string elements = std::string(kVertices) + kFaces;
  CHECK(read(ascii(elements, kCorners + std::string("3 0 1 2\n"))).triangles.size() == 1);
  check_refused(ascii(elements, kCorners), "the file ends early or holds something that is no number");
  check_refused(ascii(elements, "0 zero 0\n"), "the file ends early or holds something that is no number");
  check_refused(ascii(elements, "0 inf 0\n"), "the mesh has a vertex that is not finite");
  check_refused(ascii(elements, kCorners + std::string("3 0 1 3\n")), "a face names a vertex that does not exist");
  check_refused(ascii(elements, kCorners + std::string("3 0 1 -2\n")), "a face has an impossible index or count");
  check_refused(ascii(elements, kCorners + std::string("-3 0 1 2\n")), "a face has an impossible index or count");
  const std::string binary = std::string("ply\nformat binary_little_endian 1.0\n") + kVertices + "end_header\n";
  check_refused(binary + std::string(35, '\0'), "the file ends early");
}

TEST_CASE("a bound on the triangles names the option that raises it") {
  const std::string text = ascii(std::string(kVertices) + kFaces, kCorners + std::string("5 0 1 2 1 0\n"));
  CHECK(read(text, 3).triangles.size() == 3);
  check_error(
      [&] { read(text, 2); }, ErrorCode::limit_exceeded,
      {"a.ply: the mesh has more triangles than the bound of 2 for a hand; ", "raise ModelLoadOptions::max_triangles"});
}
