#include "common/solution.hpp"

#include <algorithm>

#include "common/table.hpp"
#include "common/tool.hpp"

namespace uhas::tools {
namespace {

std::vector<int> select(const HandProfile& profile, const std::vector<std::string>& names,
                        const JointSelection& selection) {
  std::vector<int> selected;
  for (const std::string& name : selection.order.empty() ? names : selection.order) {
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
      throw Tool::wrong_usage("--joint-order", "no joint is called " + name + ", the joints are " + join(names, ","));
    const int index = static_cast<int>(found - names.begin());
    if (std::ranges::find(selected, index) != selected.end())
      throw Tool::wrong_usage("--joint-order", name + " is named twice");
    selected.push_back(index);
  }
  if (selection.actuated_only)
    std::erase_if(selected, [&](int index) { return profile.tree.joints[index].mimic_master >= 0; });
  return selected;
}

std::vector<std::string> names_of(const KinematicTree& tree) {
  std::vector<std::string> names;
  for (const Joint& joint : tree.joints) names.push_back(joint.name);
  return names;
}

}  // namespace

SolutionMaker::SolutionMaker(const HandProfile& profile, const SolveOptions& options, const JointSelection& selection)
    : solver_(profile, options),
      names_(names_of(profile.tree)),
      selected_(select(profile, names_, selection)),
      q_(names_.size()),
      at_limit_(names_.size()),
      closed_(names_.size()) {}

std::vector<std::string> SolutionMaker::joint_names() const {
  std::vector<std::string> names;
  for (const int index : selected_) names.push_back(names_[index]);
  return names;
}

Json SolutionMaker::solve(const Action<double>& action, const std::string& place) {
  SolveReport report{.residual_rms = 0, .at_limit = at_limit_, .closed = closed_};
  if (const Status status = solver_.solve(action, q_, report); status != Status::ok)
    throw Error(ErrorCode::invalid_action, place, to_string(status), "");

  Json q = Json::array();
  for (const int index : selected_) q.push_back(q_[index]);
  return {{"q", q},
          {"residual_rms", report.residual_rms},
          {"at_limit", names_where(at_limit_)},
          {"closed", names_where(closed_)}};
}

Json SolutionMaker::names_where(const std::vector<std::uint8_t>& flags) const {
  Json names = Json::array();
  for (const int index : selected_)
    if (flags[index] != 0) names.push_back(names_[index]);
  return names;
}

}  // namespace uhas::tools
