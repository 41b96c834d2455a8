#include "uhas/runtime/cascade/solver_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "uhas/runtime/cascade/lead.hpp"
#include "uhas/runtime/cascade/solver_frame.hpp"

namespace uhas {
namespace {

/// Factor on a point's weight for each unknown between it and the joint being solved, in a single
/// pass (docs/method.md#decay).
constexpr double kDecay = 0.5;

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

void check_passes(int passes) {
  constexpr int max_passes = 100;
  if (passes < 1 || passes > max_passes)
    throw Error(ErrorCode::invalid_option, "", "passes is " + std::to_string(passes), "choose a number from 1 to 100");
}

/// The decay rises to 1 over the passes: the last ones descend on the plain weights (docs/method.md#passes).
template <class Real>
std::vector<SolverPass<Real>> compile_passes(const SolveOptions& options) {
  const int count = options.rule == CascadeRule::contact ? 1 : options.passes;
  std::vector<SolverPass<Real>> passes;
  for (int pass = 0; pass < count; ++pass) {
    const double done = count > 1 ? double(pass) / double(count - 1) : 0;
    passes.push_back({.decay = static_cast<Real>(std::pow(kDecay, 1 - done)), .first = pass == 0});
  }
  return passes;
}

/// Profile units of a joint value per solver unit.
double unit_of(const HandProfile& profile, const Joint& joint) {
  return joint.kind == JointKind::prismatic ? profile.radius : 1.0;
}

/// `q` in profile units. Cosine and sine by libm: not in haste.
template <class Real>
JointValue<Real> joint_value(const HandProfile& profile, const Joint& joint, double q) {
  const Real value = static_cast<Real>(q / unit_of(profile, joint));
  if (joint.kind == JointKind::prismatic) return {value, 1, 0};
  return {value, static_cast<Real>(std::cos(q)), static_cast<Real>(std::sin(q))};
}

template <class Real>
SolverJoint<Real> compile_solver_joint(const HandProfile& profile, int index) {
  const Joint& joint = profile.tree.joints[index];
  const JointTraits& traits = profile.joint_traits[index];
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const double unit = unit_of(profile, joint);

  SolverJoint<Real> compiled;
  static_cast<CompiledJoint<Real>&>(compiled) =
      compile_joint(profile.tree, index, profile.T_palm_sphere.inverse(), {profile.radius, profile.radius})
          .cast<Real>();
  compiled.unit = static_cast<Real>(unit);
  compiled.least = static_cast<Real>(compiled.follows ? -unbounded : joint.lower);
  compiled.greatest = static_cast<Real>(compiled.follows ? unbounded : joint.upper);
  compiled.lower = joint_value<Real>(profile, joint, joint.lower);
  compiled.upper = joint_value<Real>(profile, joint, joint.upper);
  compiled.travel = travel_of(joint, traits.q_open, traits.q_closed).in_units_of<Real>(unit);
  return compiled;
}

template <class Real>
std::vector<SolverJoint<Real>> compile_joints(const HandProfile& profile) {
  std::vector<SolverJoint<Real>> joints;
  for (int i = 0; i < static_cast<int>(profile.tree.joints.size()); ++i)
    joints.push_back(compile_solver_joint<Real>(profile, i));
  return joints;
}

/// @param decay  of the first pass
template <class Real>
std::vector<SolverStart<Real>> compile_starts(const HandProfile& profile, CascadeRule rule,
                                              const std::vector<SolverJoint<Real>>& joints, Real decay) {
  const auto start_of = [&](int i) {
    const JointTraits& traits = profile.joint_traits[i];
    const bool from_open = rule == CascadeRule::contact && traits.joint_class == JointClass::encompassing;
    return joint_value<Real>(profile, profile.tree.joints[i], from_open ? traits.q_open : traits.q_sphere);
  };
  std::vector<SolverStart<Real>> starts;
  for (int i = 0; i < static_cast<int>(joints.size()); ++i) {
    const SolverJoint<Real>& joint = joints[i];
    const JointValue<Real> start = joint.follows ? joint.value(joint.motion_at(start_of(joint.source).q)) : start_of(i);
    starts.push_back({start, scaled(joint.moved(joint.T_parent_joint, start), joint.decay_inward(decay))});
  }
  return starts;
}

template <class Real>
std::vector<SolverTip<Real>> compile_tips(const HandProfile& profile) {
  std::vector<SolverTip<Real>> tips;
  for (const ProfileFinger& finger : profile.fingers) {
    const ProfileLink& link = profile.links[finger.tip_link];
    tips.push_back({link.joint, point_in_solver(profile, link, finger.p_tip_link).cast<Real>()});
  }
  return tips;
}

template <class Real>
std::vector<SolverLateral<Real>> compile_laterals(const HandProfile& profile,
                                                  const std::vector<SolverJoint<Real>>& joints) {
  std::vector<SolverLateral<Real>> laterals;
  for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f) {
    if (profile.fingers[f].lateral_table < 0) continue;
    const LateralTable& table = profile.lateral_tables[profile.fingers[f].lateral_table];
    std::vector<Real> inverse_q;
    for (double q : table.inverse_q) inverse_q.push_back(static_cast<Real>(q) / joints[table.joint].unit);
    laterals.push_back({.joint = table.joint,
                        .finger = f,
                        .lower = static_cast<Real>(table.delta_theta_lower),
                        .upper = static_cast<Real>(table.delta_theta_upper),
                        .inverse_q = inverse_q});
  }
  return laterals;
}

/// Pairs of driven turning joints of which the first carries the second.
std::vector<std::pair<int, int>> nested_joints(const CascadeStep& step, const KinematicTree& tree) {
  std::vector<std::pair<int, int>> nested;
  const auto turns = [&](int i) { return tree.joints[i].kind != JointKind::prismatic; };
  for (int outer : step.driven)
    for (int inner = tree.joints[outer].parent; inner >= 0; inner = tree.joints[inner].parent)
      if (turns(inner) && turns(outer) && contains(step.driven, inner)) nested.emplace_back(inner, outer);
  return nested;
}

/// The joints of `step.driven` and all further out, in tree order.
std::vector<ScopedJoint> scope_of(const CascadeStep& step, const KinematicTree& tree) {
  std::vector<bool> inside(tree.joints.size(), false);
  std::vector<ScopedJoint> scope;
  for (int i = 0; i < static_cast<int>(tree.joints.size()); ++i) {
    const int parent = tree.joints[i].parent;
    const bool inner = parent >= 0 && inside[parent];
    inside[i] = inner || contains(step.driven, i);
    if (inside[i]) scope.push_back({i, inner});
  }
  return scope;
}

/// In solving order. Planned in the open pose like the wrap, so that both place the same nodes.
std::vector<SolverStep> compile_steps(const HandProfile& profile) {
  std::vector<std::vector<int>> finger_joints;
  for (const ProfileFinger& finger : profile.fingers) finger_joints.push_back(finger.joints);
  std::vector<JointClass> classes;
  std::vector<double> q_open;
  for (const JointTraits& traits : profile.joint_traits) {
    classes.push_back(traits.joint_class);
    q_open.push_back(traits.q_open);
  }
  std::vector<SolverStep> steps;
  for (const CascadeStep& step : plan_cascade(profile.tree, finger_joints, classes, q_open))
    steps.push_back({step, step.fingers.front(), step.driven.size() == 1 && step.driven.front() == step.joint,
                     nested_joints(step, profile.tree), scope_of(step, profile.tree)});
  return steps;
}

/// [joint] the step whose first joint it is. Steps that move several joints of several fingers are solved before the
/// sweep and stand at no joint.
std::vector<int> steps_by_joint(const std::vector<SolverStep>& steps, std::size_t joint_count) {
  std::vector<int> step_at(joint_count, -1);
  for (int k = 0; k < static_cast<int>(steps.size()); ++k)
    if (steps[k].driven.size() == 1 || steps[k].fingers.size() == 1) step_at[steps[k].driven.front()] = k;
  return step_at;
}

/// [joint] whether some step moves it.
std::vector<bool> moved_joints(const std::vector<SolverStep>& steps, std::size_t joint_count) {
  std::vector<bool> moved(joint_count, false);
  for (const SolverStep& step : steps)
    for (const ScopedJoint& s : step.scope) moved[s.joint] = true;
  return moved;
}

template <class Real>
std::vector<std::vector<int>> patches_by_finger(const std::vector<SolverPatch<Real>>& patches,
                                                const std::vector<bool>& moved, std::size_t finger_count) {
  std::vector<std::vector<int>> patches_of_finger(finger_count);
  for (int k = 0; k < static_cast<int>(patches.size()); ++k)
    if (moved[patches[k].joint]) patches_of_finger[patches[k].finger].push_back(k);
  return patches_of_finger;
}

/// For each joint the least joint that it cannot be solved without: they share a parent, a master or a finger.
std::vector<int> connected_joints(const HandProfile& profile) {
  const std::vector<Joint>& joints = profile.tree.joints;
  std::vector<int> least(joints.size());
  std::iota(least.begin(), least.end(), 0);
  const auto join = [&](int a, int b) {
    const auto [low, high] = std::minmax(least[a], least[b]);
    std::replace(least.begin(), least.end(), high, low);
  };
  for (int i = 0; i < static_cast<int>(joints.size()); ++i) {
    if (joints[i].parent >= 0) join(i, joints[i].parent);
    if (joints[i].mimic_master >= 0) join(i, joints[i].mimic_master);
  }
  for (const ProfileFinger& finger : profile.fingers)
    for (int i : finger.joints) join(i, finger.joints.front());
  return least;
}

template <class Real>
std::vector<SolverPart> compile_parts(const HandProfile& profile, const std::vector<SolverLateral<Real>>& laterals,
                                      const std::vector<SolverStep>& steps, const std::vector<bool>& moved) {
  const std::vector<Joint>& joints = profile.tree.joints;
  const std::vector<int> least = connected_joints(profile);
  std::vector<SolverPart> parts;
  for (int first = 0; first < static_cast<int>(joints.size()); ++first) {
    if (least[first] != first) continue;
    SolverPart part;
    const auto inside = [&](int joint) { return least[joint] == first; };
    for (int i = 0; i < static_cast<int>(joints.size()); ++i)
      if (inside(i)) part.tree.push_back({i, joints[i].parent >= 0 && moved[joints[i].parent]});
    for (int f = 0; f < static_cast<int>(profile.fingers.size()); ++f)
      if (inside(profile.fingers[f].joints.front())) part.fingers.push_back(f);
    for (int k = 0; k < static_cast<int>(laterals.size()); ++k) {
      if (!inside(laterals[k].joint)) continue;
      part.laterals.push_back(k);
      for (const ScopedJoint& s : part.tree)
        if (joints[s.joint].mimic_master == laterals[k].joint) part.lateral_followers.push_back(s.joint);
    }
    for (int k = 0; k < static_cast<int>(steps.size()); ++k)
      if (inside(steps[k].driven.front())) part.steps.push_back(k);
    parts.push_back(part);
  }
  return parts;
}

template <class Real>
std::vector<int> parts_without(const std::vector<AffineBundle<Real>>& lone_fingers, std::size_t part_count) {
  std::vector<bool> is_alone(part_count);
  for (const AffineBundle<Real>& finger : lone_fingers) is_alone[finger.fingers.front().part] = true;
  std::vector<int> others;
  for (std::size_t n = 0; n < part_count; ++n)
    if (!is_alone[n]) others.push_back(static_cast<int>(n));
  return others;
}

}  // namespace

template <class Real>
std::shared_ptr<const SolverModel<Real>> compile_solver_model(const HandProfile& profile, const SolveOptions& options) {
  check_passes(options.passes);
  check_convention(options.convention);
  validate_profile(profile, "");
  const std::size_t joint_count = profile.tree.joints.size(), finger_count = profile.fingers.size();

  const auto passes = compile_passes<Real>(options);
  const auto joints = compile_joints<Real>(profile);
  const auto starts = compile_starts(profile, options.rule, joints, passes.front().decay);
  const auto tips = compile_tips<Real>(profile);
  const auto laterals = compile_laterals(profile, joints);

  const std::vector<SolverStep> steps = compile_steps(profile);
  const std::vector<bool> moved = moved_joints(steps, joint_count);

  const PlaneGroups plane_groups = group_planes(profile);
  const auto points = compile_points<Real>(profile, plane_groups);
  const auto patches = compile_patches(points);

  const FirstPass<Real> first_pass{
      joints, starts, steps, points, passes.front().decay, options.convention.held_toward_pole};
  const auto model = std::make_shared<SolverModel<Real>>(
      SolverModel<Real>{.options = options,
                        .decoder = ActionDecoder<Real>(profile, options.convention),
                        .azimuth_sign = profile.mirrored ? Real(-1) : Real(1),
                        .passes = passes,
                        .joints = joints,
                        .starts = starts,
                        .leads = compile_leads(first_pass, finger_count),
                        .tips = tips,
                        .laterals = laterals,
                        .steps = steps,
                        .step_at = steps_by_joint(steps, joint_count),
                        .plane_groups = plane_groups,
                        .points = points,
                        .patches = patches,
                        .patches_of_finger = patches_by_finger(patches, moved, finger_count),
                        .parts = compile_parts(profile, laterals, steps, moved),
                        .lone_fingers = {},
                        .other_parts = {}});
  model->lone_fingers = bundle_fingers(*model, 1);
  model->other_parts = parts_without(model->lone_fingers, model->parts.size());
  return model;
}

template std::shared_ptr<const SolverModel<float>> compile_solver_model<float>(const HandProfile&, const SolveOptions&);
template std::shared_ptr<const SolverModel<double>> compile_solver_model<double>(const HandProfile&,
                                                                                 const SolveOptions&);

}  // namespace uhas
