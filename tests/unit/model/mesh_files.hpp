// The same tetrahedron in every mesh format. Corners: the origin and 1 on each axis; volume 1/6; normals outward.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace uhas::test {

inline constexpr float tetrahedron_vertices[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr int tetrahedron_faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

template <class Value>
void append_bytes(std::string& bytes, Value value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

inline std::string ascii_stl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& face : tetrahedron_faces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : face) {
      text += "vertex";
      for (const float c : tetrahedron_vertices[v]) text += " " + std::to_string(c);
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

inline std::string binary_stl() {
  std::string bytes(80, ' ');
  append_bytes(bytes, std::uint32_t{4});
  for (const auto& face : tetrahedron_faces) {
    bytes.append(12, '\0');
    for (const int v : face)
      for (const float c : tetrahedron_vertices[v]) append_bytes(bytes, c);
    bytes.append(2, '\0');
  }
  return bytes;
}

/// `extra`: lines after the faces.
inline std::string obj(const std::string& extra = "") {
  return "mtllib missing.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" + extra;
}

inline std::string ascii_ply() {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

inline std::string binary_ply() {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const auto& vertex : tetrahedron_vertices)
    for (const float c : vertex) append_bytes(bytes, c);
  for (const auto& face : tetrahedron_faces) {
    append_bytes(bytes, std::uint8_t{3});
    for (const int v : face) append_bytes(bytes, std::int32_t{v});
  }
  return bytes;
}

/// `up_axis`: Y_UP or Z_UP; `meter`: size of the file's unit; `node`: a transform element of the node, for example
/// <translate>1 2 3</translate>.
inline std::string dae(const std::string& up_axis, const std::string& meter = "1", const std::string& node = "") {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter=")" +
         meter + R"("/><up_axis>)" + up_axis +
         R"(</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">)"
         R"(0 0 0 1 0 0 0 1 0 0 0 1</float_array><technique_common><accessor source="#a" count="4" stride="3">)"
         R"(<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>)"
         R"(</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>)"
         R"(<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>)"
         R"(</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">)" +
         node +
         R"(<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// The buffer of `gltf` and `glb`: positions, then 16-bit indices.
inline std::string gltf_buffer() {
  std::string bytes;
  for (const auto& vertex : tetrahedron_vertices)
    for (const float c : vertex) append_bytes(bytes, c);
  for (const auto& face : tetrahedron_faces)
    for (const int v : face) append_bytes(bytes, static_cast<std::uint16_t>(v));
  return bytes;
}

/// `buffer_uri`: a member of the buffer such as "uri":"x.bin", or nothing for GLB; `node`: members of the node;
/// `vertex_count`: what the accessor of positions claims.
inline std::string gltf(const std::string& buffer_uri, const std::string& node = "",
                        const std::string& vertex_count = "4") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" + node +
         (node.empty() ? "" : ",") +
         R"("mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{)" +
         buffer_uri + (buffer_uri.empty() ? "" : ",") +
         R"("byteLength":72}],"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":)" +
         vertex_count +
         R"(,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
}

inline std::string glb(const std::string& node = "", const std::string& vertex_count = "4") {
  std::string json = gltf("", node, vertex_count);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer();
  std::string bytes = "glTF";
  append_bytes(bytes, std::uint32_t{2});
  append_bytes(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
  append_bytes(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_bytes(bytes, static_cast<std::uint32_t>(buffer.size()));
  bytes += std::string("BIN\0", 4) + buffer;
  return bytes;
}

}  // namespace uhas::test
