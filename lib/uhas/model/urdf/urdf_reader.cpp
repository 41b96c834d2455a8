#include "uhas/model/urdf/urdf_reader.hpp"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <cmath>
#include <exception>
#include <limits>
#include <mutex>

#include "uhas/base/errors.hpp"
#include "uhas/model/urdf/urdf_text.hpp"

namespace uhas {
namespace {

// Beyond these a number is a mistake, and squares and products of it begin to lose the hand.
constexpr double max_length = 100;        // m
constexpr double max_joint_value = 1000;  // rad or m
constexpr double max_factor = 1e6;        // mesh scales, mimic multipliers

/// Keeps urdfdom's complaints, which are its only report of what it drops, off the console.
class ComplaintRecorder : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR || ++count_ > 2) return;  // the second names the place
    if (!complaints_.empty()) complaints_ += ", ";
    complaints_ += text.substr(0, text.find_last_not_of(". ") + 1);
  }
  const std::string& complaints() const { return complaints_; }

 private:
  std::string complaints_;
  int count_ = 0;
};

urdf::ModelInterfaceSharedPtr parse_silently(const std::string& text, const std::string& file) {
  static std::mutex console;  // the console's handler is global
  const std::lock_guard lock(console);
  ComplaintRecorder recorder;
  console_bridge::OutputHandler* const previous = console_bridge::getOutputHandler();
  console_bridge::useOutputHandler(&recorder);
  urdf::ModelInterfaceSharedPtr model;
  std::string failure;
  try {
    model = urdf::parseURDF(text);
  } catch (const std::exception& error) {
    failure = error.what();
  }
  console_bridge::useOutputHandler(previous);
  if (failure.empty()) failure = recorder.complaints();
  if (failure.empty() && !model) failure = "urdfdom cannot read the model";
  if (!failure.empty()) throw Error(ErrorCode::invalid_model, file, failure, "correct the URDF");
  return model;
}

class Converter {
 public:
  explicit Converter(const std::string& file) : file_(file) {}

  UrdfLink link(const urdf::Link& link) const {
    UrdfLink result{link.name, {}, {}};
    const std::string place = "link '" + link.name + "'";
    for (const auto& visual : link.visual_array) append_shape(*visual, place, result.visual);
    for (const auto& collision : link.collision_array) append_shape(*collision, place, result.collision);
    return result;
  }

  UrdfJoint joint(const urdf::Joint& joint) const {
    const std::string place = "joint '" + joint.name + "'";
    UrdfJoint result;
    result.parent_link = joint.parent_link_name;
    result.child_link = joint.child_link_name;
    result.joint.name = joint.name;
    result.joint.T_parent_joint = transform(joint.parent_to_joint_origin_transform, place);
    result.fixed = joint.type == urdf::Joint::FIXED;
    if (result.fixed) return result;
    result.joint.kind = kind(joint, place);
    result.joint.axis = axis(joint, place);
    set_limits(joint, place, result.joint);
    if (joint.mimic) {
      check(std::abs(joint.mimic->multiplier) <= max_factor && std::abs(joint.mimic->offset) <= max_joint_value,
            place + " has a mimic multiplier or offset that is not a sensible number", "correct its <mimic>");
      result.mimic = UrdfMimic{joint.mimic->joint_name, joint.mimic->multiplier, joint.mimic->offset};
    }
    return result;
  }

 private:
  // Comparisons are written so that NaN fails them.
  void check(bool holds, const std::string& problem, const std::string& remedy) const {
    if (!holds) throw Error(ErrorCode::invalid_model, file_, problem, remedy);
  }

  RigidTransformd transform(const urdf::Pose& pose, const std::string& place) const {
    const auto& p = pose.position;
    check(std::abs(p.x) <= max_length && std::abs(p.y) <= max_length && std::abs(p.z) <= max_length,
          place + " has an origin that is not finite or more than 100 m away", "give its <origin> in metres");
    double x, y, z, w;
    pose.rotation.getQuaternion(x, y, z, w);
    check(std::isfinite(x * y * z * w), place + " has an origin whose rotation is not finite", "correct its rpy");
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),  //
              2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),  //
              2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}},
            {p.x, p.y, p.z}};
  }

  JointKind kind(const urdf::Joint& joint, const std::string& place) const {
    switch (joint.type) {
      case urdf::Joint::REVOLUTE: return JointKind::revolute;
      case urdf::Joint::CONTINUOUS: return JointKind::continuous;
      case urdf::Joint::PRISMATIC: return JointKind::prismatic;
      default: break;
    }
    throw Error(ErrorCode::invalid_model, file_, place + " is floating or planar, which no joint of a hand can be",
                "use fixed, revolute, continuous or prismatic joints");
  }

  Vector3d axis(const urdf::Joint& joint, const std::string& place) const {
    const Vector3d axis{joint.axis.x, joint.axis.y, joint.axis.z};
    const double length = norm(axis);
    check(length > 1e-6 && length <= max_factor, place + " has an axis of length zero or without a direction",
          "give its <axis> a direction, for example xyz=\"0 0 1\"");
    // a unit axis stays bit for bit what the file says
    return std::abs(length - 1) <= std::numeric_limits<double>::epsilon() ? axis : axis / length;
  }

  void set_limits(const urdf::Joint& joint, const std::string& place, Joint& result) const {
    if (joint.limits) result.velocity_limit = joint.limits->velocity;
    check(result.velocity_limit >= 0 && std::isfinite(result.velocity_limit),
          place + " has a velocity limit that is negative or not finite", "correct its <limit>");
    if (result.kind == JointKind::continuous) {
      result.lower = -std::numeric_limits<double>::infinity();
      result.upper = std::numeric_limits<double>::infinity();
      return;
    }
    check(joint.limits != nullptr, place + " has no limits", "add <limit lower=\"...\" upper=\"...\"/> (rad or m)");
    result.lower = joint.limits->lower;
    result.upper = joint.limits->upper;
    check(result.lower <= result.upper, place + " has a lower limit above its upper limit", "exchange them");
    check(result.lower >= -max_joint_value && result.upper <= max_joint_value,
          place + " has a limit beyond 1000 rad or m",
          "correct it, or use type=\"continuous\" for a joint without limits");
  }

  // A visual or a collision. A shape of size zero has no surface and is left out.
  template <class Element>
  void append_shape(const Element& element, const std::string& place, std::vector<UrdfShape>& shapes) const {
    using Kind = UrdfShape::Kind;
    UrdfShape shape;
    shape.T_link_shape = transform(element.origin, place);
    switch (element.geometry->type) {
      case urdf::Geometry::BOX: {
        const auto& size = static_cast<const urdf::Box&>(*element.geometry).dim;
        shape.kind = Kind::box;
        shape.box_size = {size.x, size.y, size.z};
        break;
      }
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = static_cast<const urdf::Cylinder&>(*element.geometry);
        shape.kind = element.name == "capsule" ? Kind::capsule : Kind::cylinder;
        shape.radius = cylinder.radius;
        shape.length = cylinder.length;
        break;
      }
      case urdf::Geometry::SPHERE:
        shape.kind = Kind::sphere;
        shape.radius = static_cast<const urdf::Sphere&>(*element.geometry).radius;
        break;
      case urdf::Geometry::MESH: {
        const auto& mesh = static_cast<const urdf::Mesh&>(*element.geometry);
        shape.kind = Kind::mesh;
        shape.mesh_reference = mesh.filename;
        shape.mesh_scale = {mesh.scale.x, mesh.scale.y, mesh.scale.z};
        break;
      }
    }
    for (const double length : {shape.box_size.x, shape.box_size.y, shape.box_size.z, shape.radius, shape.length})
      check(length >= 0 && length <= max_length, place + " has a shape with a size that is negative or above 100 m",
            "give sizes in metres");
    for (const double factor : {shape.mesh_scale.x, shape.mesh_scale.y, shape.mesh_scale.z})
      check(std::abs(factor) >= 1 / max_factor && std::abs(factor) <= max_factor,
            place + " has a mesh scale that is zero or absurd",
            "give three factors, for example scale=\"0.001 0.001 0.001\"");
    shapes.push_back(std::move(shape));
  }

  const std::string& file_;
};

}  // namespace

Urdf read_urdf(const std::string& text, const std::string& file, std::uint64_t max_links) {
  const urdf::ModelInterfaceSharedPtr model = parse_silently(reduce_urdf(text, file, max_links), file);
  const Converter convert(file);
  Urdf result{model->getName(), {}, {}};
  for (const auto& [name, link] : model->links_) result.links.push_back(convert.link(*link));
  for (const auto& [name, joint] : model->joints_) result.joints.push_back(convert.joint(*joint));
  return result;
}

}  // namespace uhas
