#include "uhas/anatomy/palm/stated_chains.hpp"

#include <algorithm>
#include <string_view>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/anatomy/nearest_name.hpp"

namespace uhas {
namespace {

constexpr const char* kKey = "fingers";

std::string quoted(const std::string& name) { return "\"" + name + "\""; }

}  // namespace

int find_stated_palm_link(const HandModel& model, const HandConfig& config) {
  const auto link = std::ranges::find(model.links, *config.palm_link, &ModelLink::name);
  if (link != model.links.end()) return static_cast<int>(link - model.links.begin());
  std::vector<std::string_view> known;
  for (const ModelLink& candidate : model.links) known.push_back(candidate.name);
  refuse_config(config, "palm_link", "the model has no link " + quoted(*config.palm_link),
                did_you_mean(*config.palm_link, known));
}

StatedChains find_stated_chains(const HandModel& model, const HandConfig& config) {
  const std::vector<Joint>& joints = model.tree.joints;
  StatedChains stated;
  for (const std::vector<std::string>& names : config.fingers) {
    std::vector<int>& chain = stated.chains.emplace_back();
    for (const std::string& name : names) {
      const int joint = find_joint(model.tree, name, config, kKey, "the model has no movable joint");
      if (!chain.empty() && joints[joint].parent != chain.back())
        refuse_config(config, kKey, quoted(joints[chain.back()].name) + " does not carry " + quoted(name) + " directly",
                      "list every joint of a finger, root to tip");
      chain.push_back(joint);
    }
  }
  if (stated.chains.size() < 2)
    refuse_config(config, kKey, "a hand has two or more fingers", "list the joints of each");

  const int first = stated.chains.front().front();
  stated.palm_group = joints[first].parent;
  for (const std::vector<int>& chain : stated.chains)
    if (joints[chain.front()].parent != stated.palm_group)
      refuse_config(config, kKey,
                    quoted(joints[first].name) + " and " + quoted(joints[chain.front()].name) +
                        " are not carried by one rigid palm",
                    "begin each finger with the first joint above the palm");

  // fingers may share joints near the palm, but the last joint of each is its own
  for (const std::vector<int>& chain : stated.chains)
    if (std::ranges::count_if(stated.chains, [&](const std::vector<int>& other) {
          return std::ranges::find(other, chain.back()) != other.end();
        }) > 1)
      refuse_config(config, kKey, quoted(joints[chain.back()].name) + " ends a finger and is part of another",
                    "list each finger once, to its last joint");
  return stated;
}

}  // namespace uhas
