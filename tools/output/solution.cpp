#include "output/solution.hpp"

#include <algorithm>

#include "command_line/tool.hpp"
#include "input/collision_input.hpp"
#include "text/words.hpp"

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

SolutionMaker::SolutionMaker(Tool& tool, ProfileFile file, const SolveOptions& options, const JointSelection& selection,
                             const CollisionUse& collision, const ModelInput& model)
    : file_(std::move(file)),
      solver_(file_.profile, options),
      collision_use_(collision),
      names_(names_of(file_.profile.tree)),
      selected_(select(file_.profile, names_, selection)),
      q_(names_.size()),
      at_limit_(names_.size()),
      closed_(names_.size()) {
  if (collision.report || collision.avoid) collision_.emplace(load_self_collision(tool, file_, model));
  if (collision.avoid) free_solver_.emplace(file_.profile, options, *collision_);
}

std::vector<std::string> SolutionMaker::joint_names() const {
  std::vector<std::string> names;
  for (const int index : selected_) names.push_back(names_[index]);
  return names;
}

Json SolutionMaker::solve(const Action<double>& action, const std::string& place) {
  SolveReport report{.residual_rms = 0, .at_limit = at_limit_, .closed = closed_};
  CollisionFreeSolution free;
  if (collision_use_.avoid) {
    free = free_solver_->solve(action, q_, report);
    solved_values_ = free.values;
  } else {
    free.status = solver_.solve(action, q_, report);
    solved_values_.assign(action.values.begin(), action.values.end());
  }
  if (free.status != Status::ok) throw Error(ErrorCode::invalid_action, place, to_string(free.status), "");

  Json q = Json::array();
  for (const int index : selected_) q.push_back(q_[index]);
  Json solution = {{"q", q},
                   {"residual_rms", report.residual_rms},
                   {"at_limit", names_where(at_limit_)},
                   {"closed", names_where(closed_)}};
  ++solved_;
  if (collision_use_.avoid) {
    solution["scaled"] = free.scale ? Json(*free.scale) : Json(nullptr);
    scaled_ += free.scale && *free.scale < 1;
    colliding_ += !free.scale;
  }
  if (collision_use_.report) solution["collision"] = nearest_links();
  return solution;
}

std::vector<std::string> SolutionMaker::warnings() const {
  const auto share = [this](std::size_t count) {
    return std::to_string(count) + " of " + std::to_string(solved_) + " actions";
  };
  std::vector<std::string> warnings;
  if (scaled_ > 0) warnings.push_back("scaled back " + share(scaled_) + ": the hand would collide with itself");
  if (colliding_ > 0)
    warnings.push_back("left " + share(colliding_) + " colliding: the hand collides on the undeformed sphere too");
  return warnings;
}

Json SolutionMaker::nearest_links() const {
  const NearestLinks nearest = collision_->nearest(q_);
  const std::vector<ProfileLink>& links = file_.profile.links;
  Json pair = nullptr;
  if (nearest.first >= 0) pair = {links[nearest.first].name, links[nearest.second].name};
  return {{"distance", nearest.distance}, {"pair", pair}, {"colliding", nearest.colliding}};
}

Json SolutionMaker::names_where(const std::vector<std::uint8_t>& flags) const {
  Json names = Json::array();
  for (const int index : selected_)
    if (flags[index] != 0) names.push_back(names_[index]);
  return names;
}

}  // namespace uhas::tools
