#include "uhas/anatomy/config_names.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "uhas/anatomy/nearest_name.hpp"
#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

constexpr const char* kNoFinger = "no finger has a joint";

std::string limits_text(double lower, double upper) {
  std::ostringstream text;
  text << '[' << lower << ", " << upper << ']';
  return text.str();
}

}  // namespace

std::string count_joints(std::size_t count) { return std::to_string(count) + (count == 1 ? " joint" : " joints"); }

Vector3d unit_direction(Vector3d direction) {
  constexpr double rounding = 1e-14;
  return std::abs(norm(direction) - 1) <= rounding ? direction : normalized(direction);
}

void refuse_config(const HandConfig& config, const std::string& key, const std::string& problem,
                   const std::string& remedy) {
  throw Error(ErrorCode::invalid_config, config.file, key + ": " + problem, remedy);
}

int find_joint(const KinematicTree& tree, const std::string& name, const HandConfig& config, const std::string& key,
               const std::string& lack) {
  const auto joint = std::ranges::find(tree.joints, name, &Joint::name);
  if (joint != tree.joints.end()) return static_cast<int>(joint - tree.joints.begin());
  std::vector<std::string_view> known;
  for (const Joint& candidate : tree.joints) known.push_back(candidate.name);
  refuse_config(config, key, lack + " \"" + name + "\"", did_you_mean(name, known));
}

std::vector<std::optional<double>> resolve_joint_values(const KinematicTree& tree,
                                                        const std::map<std::string, double>& stated,
                                                        const HandConfig& config, const std::string& key) {
  std::vector<std::optional<double>> values(tree.joints.size());
  for (const auto& [name, value] : stated) {
    const int index = find_joint(tree, name, config, key, kNoFinger);
    const Joint& joint = tree.joints[index];
    if (joint.mimic_master >= 0)
      refuse_config(config, key, "joint \"" + name + "\" mimics \"" + tree.joints[joint.mimic_master].name + "\"",
                    "set that joint");
    if (value < joint.lower || value > joint.upper) {
      std::ostringstream problem;
      problem << value << " is outside the limits of \"" << name << "\"";
      refuse_config(config, key, problem.str(), "stay within " + limits_text(joint.lower, joint.upper));
    }
    values[index] = value;
  }
  return values;
}

void narrow_joint_limits(KinematicTree& tree, const HandConfig& config) {
  for (const auto& [name, limits] : config.joint_limits) {
    Joint& joint = tree.joints[find_joint(tree, name, config, "joint_limits", kNoFinger)];
    const bool widens = limits.lower < joint.lower || limits.upper > joint.upper;
    if (widens && joint.kind != JointKind::continuous)
      refuse_config(config, "joint_limits",
                    limits_text(limits.lower, limits.upper) + " is wider than the limits of \"" + name + "\"",
                    "they can only be narrowed, within " + limits_text(joint.lower, joint.upper));
    joint.lower = limits.lower;
    joint.upper = limits.upper;
  }
}

}  // namespace uhas
