#include "input/joint_order.hpp"

#include <algorithm>
#include <numeric>

#include "text/words.hpp"
#include "uhas/base/errors.hpp"

namespace uhas::tools {

JointOrder::JointOrder(const HandProfile& profile)
    : row_size_(profile.tree.joints.size()), column_(profile.tree.joints.size()) {
  std::iota(column_.begin(), column_.end(), 0);
}

JointOrder::JointOrder(const HandProfile& profile, const std::vector<std::string>& names, const std::string& place)
    : row_size_(names.size()) {
  const auto refuse_if_any = [&](const std::vector<std::string>& found, const std::string& problem,
                                 const std::string& remedy) {
    if (!found.empty()) throw Error(ErrorCode::syntax, place, "joint_names " + problem + join(found, ", "), remedy);
  };
  std::vector<std::string> missing, twice, strange;
  for (const Joint& joint : profile.tree.joints) {
    const auto found = std::ranges::find(names, joint.name);
    column_.push_back(found == names.end() ? -1 : static_cast<int>(found - names.begin()));
    if (column_.back() < 0 && joint.mimic_master < 0) missing.push_back(joint.name);
  }
  for (const std::string& name : names) {
    const bool has_joint = std::ranges::find(profile.tree.joints, name, &Joint::name) != profile.tree.joints.end() ||
                           std::ranges::find(profile.other_joints, name) != profile.other_joints.end();
    if (!has_joint) strange.push_back(name);
    if (std::ranges::count(names, name) > 1 && std::ranges::find(twice, name) == twice.end()) twice.push_back(name);
  }
  refuse_if_any(twice, "has twice: ", "name each joint once");
  refuse_if_any(strange, "has what is no joint of " + profile.hand + ": ",
                "give the profile of the hand that was recorded");
  refuse_if_any(missing, "lacks joints of " + profile.hand + ": ",
                "add them; only joints that mimic others may be left out");
}

void JointOrder::reorder(std::span<const double> row, std::span<double> q) const {
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = column_[i] < 0 ? 0 : row[column_[i]];
}

}  // namespace uhas::tools
