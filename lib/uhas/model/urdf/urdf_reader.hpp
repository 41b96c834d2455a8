// The links and joints of a URDF, each checked by itself; how they hang together is checked by link_order.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

/// One <visual> or <collision>.
struct UrdfShape {
  enum class Kind { box, cylinder, capsule, sphere, mesh };
  Kind kind = Kind::box;
  Vector3d box_size;             ///< edge lengths (m)
  double radius = 0;             ///< cylinder, capsule, sphere (m)
  double length = 0;             ///< cylinder; of a capsule the part between its two half spheres (m)
  std::string mesh_reference;    ///< file name as written
  Vector3d mesh_scale{1, 1, 1};  ///< no component zero; a negative one mirrors
  RigidTransformd T_link_shape;
};

struct UrdfLink {
  std::string name;
  std::vector<UrdfShape> visual, collision;
};

struct UrdfMimic {
  std::string master;  ///< name of a joint
  double multiplier = 1, offset = 0;
};

struct UrdfJoint {
  Joint joint;  ///< `parent` and the mimic fields are not set; T_parent_joint is relative to the parent LINK
  bool fixed = false;
  std::string parent_link, child_link;
  std::optional<UrdfMimic> mimic;
};

struct Urdf {
  std::string name;
  std::vector<UrdfLink> links;    ///< by name
  std::vector<UrdfJoint> joints;  ///< by name
};

/// Reads the text of a URDF. `file` names it in errors. Prints nothing.
/// Throws Error: syntax, invalid_model, limit_exceeded.
Urdf read_urdf(const std::string& text, const std::string& file, std::uint64_t max_links);

}  // namespace uhas
