#include "uhas/kinematics/compiled_joint.hpp"

#include "uhas/kinematics/axis_frame.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {

CompiledJoint<double> compile_joint(const KinematicTree& tree, int index, const RigidTransformd& T_base_root,
                                    const LengthUnits& units) {
  const Joint& joint = tree.joints[index];
  CompiledJoint<double> compiled;

  // its motion: what mimics divide by their own unit they multiply by that of their master
  const auto one = [&](int i, double length) { return tree.joints[i].kind == JointKind::prismatic ? length : 1.0; };
  compiled.prismatic = joint.kind == JointKind::prismatic;
  compiled.follows = joint.mimic_master >= 0;
  compiled.source = independent_joint(tree, index);
  const double unit = one(index, units.motion);
  compiled.ratio = (compiled.follows ? joint.mimic_multiplier : 1.0) * one(compiled.source, units.q) / unit;
  compiled.offset = (compiled.follows ? joint.mimic_offset : 0.0) / unit;

  // its frame, between the turned frames of parent and joint
  const RigidTransformd T_base_parent =
      joint.parent < 0 ? T_base_root : RigidTransformd{axis_frame(tree.joints[joint.parent]), {}}.inverse();
  compiled.parent = joint.parent;
  compiled.T_parent_joint = T_base_parent * joint.T_parent_joint * RigidTransformd{axis_frame(joint), {}};
  compiled.T_parent_joint.translation = compiled.T_parent_joint.translation / units.motion;
  return compiled;
}

}  // namespace uhas
