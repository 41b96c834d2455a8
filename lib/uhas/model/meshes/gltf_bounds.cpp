#include "uhas/model/meshes/gltf_bounds.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int max_nesting = 64;

// Plain files have at most one element a byte, compressed ones (Draco) a few.
constexpr std::uint64_t max_elements_per_byte = 16;

/// The JSON of a glTF file: all of a .gltf, the first chunk of a .glb.
std::string_view json_text(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return bytes;
  constexpr std::size_t header = 20;  // magic, version, length; length and type of the first chunk
  if (bytes.size() < header) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return bytes.substr(header, length);
}

std::uint64_t count_of(const json& accessors, const json& index) {
  return accessors.at(index.get<std::size_t>()).at("count").get<std::uint64_t>();
}

std::uint64_t elements_used(const json& document) {
  constexpr std::uint64_t saturated = std::uint64_t{1} << 40;  // sums below cannot overflow
  const json none = json::array();
  const json& accessors = document.contains("accessors") ? document.at("accessors") : none;
  std::uint64_t total = 0;
  const auto add = [&](const json& index) {
    total = std::min(saturated, total + std::min(saturated, count_of(accessors, index)));
  };
  for (const json& mesh : document.value("meshes", none))
    for (const json& primitive : mesh.at("primitives")) {
      for (const json& accessor : primitive.at("attributes")) add(accessor);
      if (primitive.contains("indices")) add(primitive.at("indices"));
    }
  return total;
}

// Bytes of the buffer files beside a .gltf; data: URIs are bytes of the file itself.
std::uint64_t buffer_file_bytes(const json& document, const fs::path& folder) {
  std::uint64_t total = 0;
  for (const json& buffer : document.value("buffers", json::array())) {
    const std::string uri = buffer.value("uri", "");
    std::error_code failure;
    const std::uintmax_t size = uri.empty() || uri.starts_with("data:") ? 0 : fs::file_size(folder / uri, failure);
    if (!failure) total += size;
  }
  return total;
}

/// assimp makes a node anew for each way that leads to it, which from twenty nodes can be a million; glTF itself
/// demands that nodes form trees.
void check_node_trees(const json& document, const fs::path& path) {
  const json none = json::array();
  const json& nodes = document.contains("nodes") ? document.at("nodes") : none;
  const json& scenes = document.contains("scenes") ? document.at("scenes") : none;
  constexpr std::size_t nobody = 0, a_node = 1, first_scene = 2;
  std::vector<std::size_t> named_by(nodes.size(), nobody);  // what leads to each node
  const auto name = [&](const json& index, std::size_t by) {
    std::size_t& before = named_by.at(index.get<std::size_t>());
    if (before == a_node || before == by)
      throw Error(ErrorCode::invalid_mesh, path, "two ways lead to one node, so the nodes form no tree",
                  "export the mesh again");
    before = by;
  };
  for (const json& node : nodes)
    for (const json& child : node.value("children", none)) name(child, a_node);
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (const json& root : scenes.at(i).value("nodes", none)) name(root, first_scene + i);
}

}  // namespace

void check_gltf_bounds(std::string_view bytes, const fs::path& path) {
  try {
    const std::string_view text = json_text(bytes);
    const json document = json::parse(text, [&](int depth, json::parse_event_t, json&) {
      if (depth > max_nesting)
        throw Error(ErrorCode::limit_exceeded, path, "the JSON of the mesh is nested too deep",
                    "export the mesh again");
      return true;
    });
    const std::uint64_t available = bytes.size() + buffer_file_bytes(document, path.parent_path());
    if (elements_used(document) > max_elements_per_byte * available)
      throw Error(ErrorCode::limit_exceeded, path, "the mesh claims far more vertices or indices than it has bytes",
                  "export the mesh again");
    check_node_trees(document, path);
  } catch (const std::out_of_range&) {
    throw Error(ErrorCode::invalid_mesh, path, "it names a node that does not exist", "export the mesh again");
  } catch (const json::exception& error) {
    throw Error(ErrorCode::invalid_mesh, path, std::string("this is no well-formed glTF (") + error.what() + ")",
                "export the mesh again");
  }
}

}  // namespace uhas
