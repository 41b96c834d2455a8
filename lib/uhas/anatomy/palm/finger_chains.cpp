#include "uhas/anatomy/palm/finger_chains.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/anatomy/palm/stated_chains.hpp"
#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

/// A branch shorter than this part of the longest beside it is a decoy: a button, a cover, a sensor mount.
constexpr double kShortestFinger = 0.35;
/// A branch that only follows other joints is a linkage leaf unless it is nearly as long as the longest.
constexpr double kShortestFollower = 0.6;
/// A last joint that carries less than this part of its finger's length is no phalanx.
constexpr double kShortestPhalanx = 0.05;
/// Far more than any hand has; the inference compares fingers with each other.
constexpr std::size_t kMaxFingers = 20;

/// Lengths and branching of the model's tree of joints. Every length is independent of the pose.
class Branches {
 public:
  explicit Branches(const HandModel& model) : joints_(model.tree.joints), children_(joints_.size() + 1) {
    // how far links and meshes reach from the joint that carries them
    std::vector<double> extent(joints_.size(), 0.0);
    for (const ModelLink& link : model.links) {
      if (link.joint < 0) continue;
      double& reach = extent[link.joint];
      reach = std::max(reach, norm(link.T_joint_link.translation));
      for (const Vector3d& vertex : link.mesh.vertices) reach = std::max(reach, norm(link.T_joint_link * vertex));
    }

    // and how far all that a joint carries, from the outermost joints inward
    reach_ = extent;
    independent_.assign(joints_.size(), false);
    for (int joint = static_cast<int>(joints_.size()) - 1; joint >= 0; --joint) {
      // a last joint without geometry and frames: its phalanx is taken to be as long as the one before
      if (children(joint).empty() && !(extent[joint] > 0)) reach_[joint] = offset(joint);
      if (joints_[joint].mimic_master < 0) independent_[joint] = true;
      const int parent = joints_[joint].parent;
      children_[parent + 1].insert(children_[parent + 1].begin(), joint);
      if (parent < 0) continue;
      reach_[parent] = std::max(reach_[parent], offset(joint) + reach_[joint]);
      if (independent_[joint]) independent_[parent] = true;
    }
  }

  const std::vector<int>& children(int group) const { return children_[group + 1]; }

  /// Length of the longest path from the joint's origin outward (m).
  double reach(int joint) const { return reach_[joint]; }

  /// True when the joint or one further out is independent.
  bool independent(int joint) const { return independent_[joint]; }

  double longest_child(int group) const {
    double longest = 0;
    for (int child : children(group)) longest = std::max(longest, reach(child));
    return longest;
  }

 private:
  double offset(int joint) const {
    const Joint& j = joints_[joint];
    return norm(j.T_parent_joint.translation) + (j.kind == JointKind::prismatic ? j.upper - j.lower : 0);
  }

  const std::vector<Joint>& joints_;
  std::vector<std::vector<int>> children_;
  std::vector<double> reach_;
  std::vector<bool> independent_;
};

/// The chains of joints on one group that are long enough for fingers, and how clearly they are.
class ChainCollector {
 public:
  ChainCollector(const Branches& branches, int palm_group) : branches_(branches) {
    const double longest = branches.longest_child(palm_group);
    for (int root : branches.children(palm_group)) {
      const double shortest = longest * (branches.independent(root) ? kShortestFinger : kShortestFollower);
      judge(branches.reach(root), shortest);
      if (branches.reach(root) >= shortest) extend({root}, branches.reach(root));
    }
  }

  std::vector<std::vector<int>> chains;
  double margin = 1;  ///< how clear the closest decision was: 1 from half as long again as it takes

 private:
  void extend(std::vector<int> chain, double finger_length) {
    // the longest child goes on with the finger; others make fingers of their own on the joints so far
    std::vector<int> next;
    const double longest = branches_.longest_child(chain.back());
    for (int child : branches_.children(chain.back())) {
      const double reach = branches_.reach(child);
      judge(reach, kShortestPhalanx * finger_length);
      if (reach < kShortestPhalanx * finger_length) continue;
      if (reach >= longest) {
        next.insert(next.begin(), child);
      } else if (branches_.independent(child)) {
        judge(reach, kShortestFollower * longest);
        if (reach >= kShortestFollower * longest) next.push_back(child);
      }
    }
    // of equally long branches that only follow, one is the finger
    if (next.size() > 1)
      std::erase_if(next, [&](int child) { return child != next.front() && !branches_.independent(child); });

    if (next.empty()) return chains.push_back(std::move(chain));
    for (int child : next) {
      std::vector<int> longer = chain;
      longer.push_back(child);
      extend(std::move(longer), finger_length);
    }
  }

  /// Remembers how far `reach` is from the threshold that decides.
  void judge(double reach, double threshold) {
    if (!(threshold > 0)) return;
    const double ratio = reach / threshold;
    margin = std::min(margin, ratio >= 1 ? (ratio - 1) / 0.5 : (1 - ratio) / 0.35);
  }

  const Branches& branches_;
};

/// The lowest group in which all significant chains meet: walk outward while only one branch matters and
/// it splits later.
int find_palm_group(const Branches& branches, double& margin) {
  int group = -1;
  for (;;) {
    // the branches as long as a finger, the longest and the second
    const double longest = branches.longest_child(group);
    int significant = 0, next = -1;
    double second = 0;
    for (int child : branches.children(group)) {
      if (branches.reach(child) >= kShortestFinger * longest) ++significant;
      if (next < 0 || branches.reach(child) > branches.reach(next)) next = child;
    }
    for (int child : branches.children(group))
      if (child != next) second = std::max(second, branches.reach(child));

    // one alone that carries several fingers is an arm
    if (significant != 1 || ChainCollector(branches, next).chains.size() < 2) return group;
    margin = std::min(margin, 1 - second / longest);
    group = next;
  }
}

/// Of the palm's rigid group, the link that most fingers hang on; then the one with the larger mesh.
int find_palm_link(const HandModel& model, const FingerChains& found) {
  // fingers by the link that carries their first joint
  std::vector<std::size_t> fingers(model.links.size(), 0);
  for (const ModelLink& link : model.links) {
    if (link.parent_link < 0 || model.links[link.parent_link].joint == link.joint) continue;
    for (const std::vector<int>& chain : found.chains)
      if (chain.front() == link.joint) ++fingers[link.parent_link];
  }

  int palm = -1;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (model.links[i].joint != found.palm_group) continue;
    if (palm < 0 || fingers[i] > fingers[palm] ||
        (fingers[i] == fingers[palm] && model.links[i].mesh.vertices.size() > model.links[palm].mesh.vertices.size()))
      palm = static_cast<int>(i);
  }
  return palm;
}

}  // namespace

FingerChains find_finger_chains(const HandModel& model, const HandConfig& config) {
  // what the config states of fingers and palm
  const Branches branches(model);
  FingerChains found;
  if (!config.fingers.empty()) {
    StatedChains stated = find_stated_chains(model, config);
    found.chains = std::move(stated.chains);
    found.palm_group = stated.palm_group;
  }
  if (config.palm_link) {
    found.palm_link = find_stated_palm_link(model, config);
    const int palm_group = model.links[found.palm_link].joint;
    if (!config.fingers.empty() && palm_group != found.palm_group)
      refuse_config(config, "palm_link", "the stated fingers do not begin on \"" + *config.palm_link + "\"",
                    "name the link that carries the first joint of each");
    found.palm_group = palm_group;
  } else if (config.fingers.empty()) {
    found.palm_group = find_palm_group(branches, found.palm_margin);
  }

  // what hangs on the palm
  if (config.fingers.empty()) {
    ChainCollector collector(branches, found.palm_group);
    found.chains = std::move(collector.chains);
    found.chain_margin = std::clamp(collector.margin, 0.0, 1.0);
  }
  if (found.chains.size() < 2)
    throw Error(ErrorCode::invalid_hand, "",
                found.chains.empty() ? "no movable joint carries a finger" : "only one finger was found",
                "a hand needs two or more chains of movable joints on one palm; name the palm with \"palm_link\" in a "
                "hand config");
  if (found.chains.size() > kMaxFingers)
    throw Error(
        ErrorCode::invalid_hand, "",
        std::to_string(found.chains.size()) + " chains of movable joints hang on one palm, too many for fingers",
        "name the joints of each finger by \"fingers\" in a hand config");
  std::sort(found.chains.begin(), found.chains.end());
  if (!config.palm_link) found.palm_link = find_palm_link(model, found);
  return found;
}

}  // namespace uhas
