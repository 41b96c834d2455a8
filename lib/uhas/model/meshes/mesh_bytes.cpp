#include "uhas/model/meshes/mesh_bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

/// A list is its length, then its elements; both processes are one program, so these are in its own representation.
template <class List>
void append(std::vector<std::byte>& bytes, const List& list) {
  static_assert(std::is_trivially_copyable_v<typename List::value_type>);
  const std::uint64_t count = list.size();
  const auto count_bytes = std::as_bytes(std::span(&count, 1)), list_bytes = std::as_bytes(std::span(list));
  bytes.insert(bytes.end(), count_bytes.begin(), count_bytes.end());
  bytes.insert(bytes.end(), list_bytes.begin(), list_bytes.end());
}

class ByteReader {
 public:
  ByteReader(std::span<const std::byte> bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  bool at_end() const { return bytes_.empty(); }

  template <class List>
  List list() {
    using Element = typename List::value_type;
    std::uint64_t count = 0;
    take(&count, sizeof count);
    if (count > bytes_.size() / sizeof(Element)) fail();
    List list(count, Element{});
    take(list.data(), count * sizeof(Element));
    return list;
  }

 private:
  void take(void* target, std::size_t size) {
    if (size > bytes_.size()) fail();
    if (size > 0) std::memcpy(target, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
  }
  [[noreturn]] void fail() const {
    throw Error(ErrorCode::invalid_mesh, file_, "the process that read it handed over no mesh",
                "do not trust the file");
  }

  std::span<const std::byte> bytes_;
  const std::string& file_;
};

}  // namespace

std::vector<std::byte> to_bytes(const ReadMesh& read) {
  std::vector<std::byte> bytes;
  append(bytes, read.mesh.vertices);
  append(bytes, read.mesh.triangles);
  for (const auto& [source, path] : read.sources) {
    append(bytes, source.name);
    append(bytes, source.sha256);
    append(bytes, path);
  }
  return bytes;
}

ReadMesh read_mesh_from_bytes(std::span<const std::byte> bytes, const std::string& file) {
  ByteReader reader(bytes, file);
  ReadMesh read;
  read.mesh.vertices = reader.list<std::vector<Vector3d>>();
  read.mesh.triangles = reader.list<std::vector<std::array<std::uint32_t, 3>>>();
  while (!reader.at_end()) {
    auto& [source, path] = read.sources.emplace_back();
    source.name = reader.list<std::string>();
    source.sha256 = reader.list<std::string>();
    path = reader.list<std::string>();
  }
  return read;
}

}  // namespace uhas
