#include "uhas/model/meshes/ply_reader.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <sstream>
#include <string_view>

#include "uhas/base/errors.hpp"
#include "uhas/model/meshes/mesh_bounds.hpp"

namespace uhas {
namespace {

enum class Scalar { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Scalar type = Scalar::float32;
  bool is_list = false;
  Scalar count_type = Scalar::uint8;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(std::string_view text, const std::string& file, std::uint64_t max_triangles)
      : text_(text), file_(file), max_triangles_(max_triangles) {}

  TriangleMesh read() {
    read_header();
    for (const Element& element : elements_)
      for (std::uint64_t i = 0; i < element.count; ++i) read_element(element);
    for (const auto& triangle : mesh_.triangles)
      for (const std::uint32_t vertex : triangle)
        if (vertex >= mesh_.vertices.size()) fail("a face names a vertex that does not exist");
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorCode::invalid_mesh, file_, problem, "export the mesh again");
  }

  std::string_view header_line() {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) fail("the PLY header does not end");
    std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  void read_header() {
    if (header_line() != "ply") fail("this is not a PLY file");
    for (std::string_view line = header_line(); line != "end_header"; line = header_line()) {
      std::istringstream words{std::string(line)};
      std::string keyword;
      words >> keyword;
      if (keyword == "format") {
        read_format(words);
      } else if (keyword == "element") {
        Element element;
        if (!(words >> element.name >> element.count)) fail("the PLY header has an element without name or count");
        elements_.push_back(std::move(element));
      } else if (keyword == "property") {
        if (elements_.empty()) fail("the PLY header has a property before the first element");
        elements_.back().properties.push_back(read_property(words));
      }
    }
    for (const Element& element : elements_)  // each element must take bytes, so that the file's size bounds the count
      if (element.properties.empty()) fail("the PLY header has an element without properties");
  }

  void read_format(std::istringstream& words) {
    std::string format;
    words >> format;
    ascii_ = format == "ascii";
    const bool little = format == "binary_little_endian";
    if (!ascii_ && !little && format != "binary_big_endian") fail("the PLY header names an unknown format");
    swap_bytes_ = little != (std::endian::native == std::endian::little);
  }

  Property read_property(std::istringstream& words) const {
    Property property;
    std::string type;
    words >> type;
    property.is_list = type == "list";
    if (property.is_list) {
      words >> type;
      property.count_type = scalar(type);
      words >> type;
    }
    property.type = scalar(type);
    if (!(words >> property.name)) fail("the PLY header has a property without name");
    return property;
  }

  Scalar scalar(std::string_view name) const {
    static constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                           {"uchar", "uint8"},
                                                                           {"short", "int16"},
                                                                           {"ushort", "uint16"},
                                                                           {"int", "int32"},
                                                                           {"uint", "uint32"},
                                                                           {"float", "float32"},
                                                                           {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::ranges::find(names[i], name) != names[i].end()) return static_cast<Scalar>(i);
    fail("the PLY header names an unknown type");
  }

  void read_element(const Element& element) {
    Vector3d vertex;
    for (const Property& property : element.properties) {
      const std::uint64_t count = property.is_list ? read_index(property.count_type) : 1;
      const bool is_face = property.is_list && element.name == "face" && property.name.starts_with("vertex_ind");
      std::array<std::uint32_t, 3> fan{};
      for (std::uint64_t i = 0; i < count; ++i) {
        if (is_face) {
          fan[std::min<std::uint64_t>(i, 2)] = read_index(property.type);
          if (i >= 2) {
            append(fan);
            fan[1] = fan[2];
          }
        } else {
          const double value = read_number(property.type);
          if (property.name == "x") vertex.x = value;
          if (property.name == "y") vertex.y = value;
          if (property.name == "z") vertex.z = value;
        }
      }
    }
    if (element.name != "vertex") return;
    if (!is_finite(vertex)) fail("the mesh has a vertex that is not finite");
    require_within_bounds(mesh_.triangles.size(), mesh_.vertices.size() + 1, max_triangles_, "the mesh has", file_);
    mesh_.vertices.push_back(vertex);
  }

  void append(const std::array<std::uint32_t, 3>& triangle) {
    require_within_bounds(mesh_.triangles.size() + 1, mesh_.vertices.size(), max_triangles_, "the mesh has", file_);
    mesh_.triangles.push_back(triangle);
  }

  std::uint32_t read_index(Scalar type) {
    const double value = read_number(type);
    if (!(value >= 0 && value <= std::numeric_limits<std::uint32_t>::max()))
      fail("a face has an impossible index or count");
    return static_cast<std::uint32_t>(value);
  }

  double read_number(Scalar type) {
    if (ascii_) return read_word();
    switch (type) {
      case Scalar::int8: return read_binary<std::int8_t>();
      case Scalar::uint8: return read_binary<std::uint8_t>();
      case Scalar::int16: return read_binary<std::int16_t>();
      case Scalar::uint16: return read_binary<std::uint16_t>();
      case Scalar::int32: return read_binary<std::int32_t>();
      case Scalar::uint32: return read_binary<std::uint32_t>();
      case Scalar::float32: return static_cast<double>(read_binary<float>());
      case Scalar::float64: break;
    }
    return read_binary<double>();
  }

  double read_word() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size());
    double value = 0;
    const auto [end, failure] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (failure != std::errc{}) fail("the file ends early or holds something that is no number");
    at_ = end - text_.data();
    return value;
  }

  template <class Value>
  Value read_binary() {
    if (text_.size() - at_ < sizeof(Value)) fail("the file ends early");
    std::array<char, sizeof(Value)> raw;
    std::memcpy(raw.data(), text_.data() + at_, sizeof(Value));
    at_ += sizeof(Value);
    if (swap_bytes_) std::ranges::reverse(raw);
    return std::bit_cast<Value>(raw);
  }

  std::string_view text_;
  const std::string& file_;
  std::uint64_t max_triangles_;
  std::size_t at_ = 0;
  bool ascii_ = true;
  bool swap_bytes_ = false;
  std::vector<Element> elements_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh read_ply(std::span<const std::byte> bytes, const std::string& file, std::uint64_t max_triangles) {
  return PlyReader({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file, max_triangles).read();
}

}  // namespace uhas
