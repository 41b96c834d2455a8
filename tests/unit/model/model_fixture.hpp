// Small URDFs and meshes for the tests of the hand model.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "support/scratch_folder.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/model/hand_model.hpp"

namespace uhas::test {

inline std::string robot(const std::string& content) { return "<robot name=\"hand\">" + content + "</robot>"; }

inline std::string link(const std::string& name, const std::string& content = "") {
  return "<link name=\"" + name + "\">" + content + "</link>";
}

inline constexpr const char* unit_limit = R"(<limit lower="-1" upper="1" effort="1" velocity="2"/>)";

/// A joint 1 m above its parent that turns about y.
inline std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                         const std::string& content = unit_limit, const std::string& type = "revolute") {
  return "<joint name=\"" + name + "\" type=\"" + type + R"("><origin xyz="0 0 1"/><axis xyz="0 1 0"/><parent link=")" +
         parent + "\"/><child link=\"" + child + "\"/>" + content + "</joint>";
}

inline std::string mimic(const std::string& master, const std::string& rest = "") {
  return unit_limit + ("<mimic joint=\"" + master + "\" " + rest + "/>");
}

/// A palm with one finger link; `palm_content` goes into the palm.
inline std::string one_finger(const std::string& palm_content = "") {
  return robot(link("palm", palm_content) + link("finger") + joint("knuckle", "palm", "finger"));
}

inline std::string visual(const std::string& shape, const std::string& origin = "") {
  return "<visual>" + origin + "<geometry>" + shape + "</geometry></visual>";
}

inline std::string collision(const std::string& shape) {
  return "<collision><geometry>" + shape + "</geometry></collision>";
}

inline std::string mesh(const std::string& file, const std::string& attributes = "") {
  return "<mesh filename=\"" + file + "\" " + attributes + "/>";
}

inline HandModel load(const std::string& urdf, const ModelLoadOptions& options = {}) {
  const ScratchFolder folder;
  return load_hand_model(folder.write("hand.urdf", urdf), options);
}

/// Checks that `call` throws an Error of that code whose message holds every one of `words`.
template <class Call>
void check_error(Call call, ErrorCode code, const std::vector<std::string>& words) {
  try {
    call();
    FAIL_CHECK("no error was thrown");
  } catch (const Error& error) {
    const std::string message = error.what();
    CHECK_MESSAGE(error.code() == code, message);
    for (const std::string& word : words)
      CHECK_MESSAGE(message.find(word) != std::string::npos, word << " in " << message);
  }
}

inline void check_load_error(const std::string& urdf, ErrorCode code, const std::vector<std::string>& words) {
  check_error([&] { load(urdf); }, code, words);
}

/// Six times the volume, positive when the triangles' normals point outward.
inline double signed_volume(const TriangleMesh& m) {
  double volume = 0;
  for (const auto& t : m.triangles) volume += dot(m.vertices[t[0]], cross(m.vertices[t[1]], m.vertices[t[2]])) / 6;
  return volume;
}

struct Bounds {
  Vector3d low, high;
};

inline Bounds bounds(const TriangleMesh& m) {
  REQUIRE_FALSE(m.vertices.empty());
  Bounds b{m.vertices[0], m.vertices[0]};
  for (const Vector3d& p : m.vertices) {
    b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y), std::min(b.low.z, p.z)};
    b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y), std::max(b.high.z, p.z)};
  }
  return b;
}

inline void check_near(Vector3d a, Vector3d b) { CHECK_MESSAGE(norm(a - b) < 1e-6, a.x << " " << a.y << " " << a.z); }

}  // namespace uhas::test
