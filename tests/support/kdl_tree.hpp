// KDL's tree of a URDF, built from urdfdom and not from the hand model: an independent reference for kinematics.
#pragma once

#include <urdf_parser/urdf_parser.h>

#include <filesystem>
#include <fstream>
#include <kdl/tree.hpp>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>

namespace uhas::test {

/// urdfdom's reading of the file. It drops links over an <inertial> without <inertia>; kinematics need none.
inline urdf::ModelInterfaceSharedPtr read_urdf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  const auto urdf = urdf::parseURDF(std::regex_replace(text.str(), std::regex("<inertial>[^]*?</inertial>"), ""));
  if (!urdf) throw std::runtime_error(file.string() + ": urdfdom does not read it");
  return urdf;
}

inline KDL::Frame to_kdl(const urdf::Pose& pose) {
  const auto& r = pose.rotation;
  return {KDL::Rotation::Quaternion(r.x, r.y, r.z, r.w), {pose.position.x, pose.position.y, pose.position.z}};
}

inline KDL::Joint to_kdl(const urdf::Joint& joint) {
  const KDL::Frame origin = to_kdl(joint.parent_to_joint_origin_transform);
  if (joint.type == urdf::Joint::FIXED) return KDL::Joint(joint.name, KDL::Joint::None);
  const KDL::Vector axis = origin.M * KDL::Vector(joint.axis.x, joint.axis.y, joint.axis.z);
  const auto type = joint.type == urdf::Joint::PRISMATIC ? KDL::Joint::TransAxis : KDL::Joint::RotAxis;
  return KDL::Joint(joint.name, origin.p, axis, type);
}

inline void add_children(const urdf::Link& link, KDL::Tree& tree) {
  for (const auto& child : link.child_links) {
    const urdf::Joint& joint = *child->parent_joint;
    const KDL::Segment segment(child->name, to_kdl(joint), to_kdl(joint.parent_to_joint_origin_transform));
    if (!tree.addSegment(segment, link.name)) throw std::runtime_error("KDL does not take the link " + child->name);
    add_children(*child, tree);
  }
}

/// One segment a link, named as the link.
inline KDL::Tree kdl_tree(const urdf::ModelInterface& urdf) {
  KDL::Tree tree(urdf.getRoot()->name);
  add_children(*urdf.getRoot(), tree);
  return tree;
}

using JointValues = std::map<std::string, double>;

/// A joint's value, through its mimics, from the values of the independent joints; of rates, too, without the offsets.
inline double value_of(const urdf::ModelInterface& urdf, const std::string& joint, const JointValues& independent,
                       bool rates = false) {
  const auto mimic = urdf.getJoint(joint)->mimic;
  if (!mimic) return independent.at(joint);
  return mimic->multiplier * value_of(urdf, mimic->joint_name, independent, rates) + (rates ? 0 : mimic->offset);
}

/// One value a movable joint, in the order of KDL's tree.
inline KDL::JntArray kdl_values(const urdf::ModelInterface& urdf, const KDL::Tree& tree, const JointValues& independent,
                                bool rates = false) {
  KDL::JntArray values(tree.getNrOfJoints());
  for (const auto& [name, element] : tree.getSegments()) {
    const KDL::Joint& joint = element.segment.getJoint();
    if (joint.getType() != KDL::Joint::None) values(element.q_nr) = value_of(urdf, joint.getName(), independent, rates);
  }
  return values;
}

}  // namespace uhas::test
