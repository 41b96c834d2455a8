#include "uhas/model/urdf/link_order.hpp"

#include <algorithm>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

/// Index of the element with that name in a list sorted by name, -1 when there is none.
template <class List, class Name>
int find_by_name(const List& list, const std::string& name, Name name_of) {
  const auto found = std::ranges::lower_bound(list, name, {}, name_of);
  return found != list.end() && name_of(*found) == name ? static_cast<int>(found - list.begin()) : -1;
}

int find_link(const Urdf& urdf, const std::string& name) {
  return find_by_name(urdf.links, name, [](const UrdfLink& link) -> const std::string& { return link.name; });
}

int find_joint(const Urdf& urdf, const std::string& name) {
  return find_by_name(urdf.joints, name, [](const UrdfJoint& joint) -> const std::string& { return joint.joint.name; });
}

}  // namespace

std::vector<OrderedLink> order_links(const Urdf& urdf, const std::string& file) {
  const auto fail = [&](const std::string& problem, const std::string& remedy) {
    throw Error(ErrorCode::invalid_model, file, problem, remedy);
  };

  // what joins the links; each has at most one joint above it
  std::vector<int> joint_above(urdf.links.size(), -1);
  std::vector<std::vector<int>> children(urdf.links.size());
  for (std::size_t j = 0; j < urdf.joints.size(); ++j) {
    const UrdfJoint& joint = urdf.joints[j];
    const std::string place = "joint '" + joint.joint.name + "'";
    const int parent = find_link(urdf, joint.parent_link);
    const int child = find_link(urdf, joint.child_link);
    if (parent < 0) fail(place + " has the unknown parent link '" + joint.parent_link + "'", "name a link of the file");
    if (child < 0) fail(place + " has the unknown child link '" + joint.child_link + "'", "name a link of the file");
    if (parent == child) fail(place + " has one link as parent and child", "name two links");
    if (joint_above[child] >= 0)
      fail("link '" + joint.child_link + "' has two parents, through joints '" +
               urdf.joints[joint_above[child]].joint.name + "' and '" + joint.joint.name + "'",
           "remove one of the joints");
    joint_above[child] = static_cast<int>(j);
    children[parent].push_back(child);
  }

  // the one link without a joint above it
  const auto root = std::ranges::find(joint_above, -1);
  if (root == joint_above.end())
    fail("the links form a cycle, so there is no root link", "break it by removing a joint");
  const auto second_root = std::find(root + 1, joint_above.end(), -1);
  if (second_root != joint_above.end())
    fail("there are several root links, '" + urdf.links[root - joint_above.begin()].name + "' and '" +
             urdf.links[second_root - joint_above.begin()].name + "'",
         "connect them by a fixed joint or remove one");

  // depth first from there, with an explicit stack, for a chain may be as long as the file allows
  struct Pending {
    int link, parent;
  };
  std::vector<Pending> stack{{static_cast<int>(root - joint_above.begin()), -1}};
  std::vector<OrderedLink> order;
  std::vector<bool> reached(urdf.links.size());
  while (!stack.empty()) {
    const Pending next = stack.back();
    stack.pop_back();
    const int position = static_cast<int>(order.size());
    order.push_back({next.link, next.parent, joint_above[next.link]});
    reached[next.link] = true;
    std::vector<int>& below = children[next.link];
    std::ranges::sort(below, std::ranges::greater{});  // links are sorted by name, so indices compare as names
    for (const int child : below) stack.push_back({child, position});
  }

  // what was not reached hangs on a cycle
  const auto lost = std::ranges::find(reached, false);
  if (lost != reached.end())
    fail("link '" + urdf.links[lost - reached.begin()].name + "' hangs on a cycle of joints, apart from the root",
         "break the cycle by removing a joint");
  return order;
}

std::vector<FlatMimic> flatten_mimics(const Urdf& urdf, const std::string& file) {
  const auto fail = [&](const std::string& follower, const std::string& problem) {
    throw Error(ErrorCode::invalid_model, file, "joint '" + follower + "' mimics " + problem,
                "let it mimic an independent movable joint");
  };

  std::vector<FlatMimic> result(urdf.joints.size());
  for (std::size_t j = 0; j < urdf.joints.size(); ++j) {
    const std::string& follower = urdf.joints[j].joint.name;
    FlatMimic& flat = result[j];
    // from master to master, until one is independent
    std::size_t links_of_chain = 0;
    for (const UrdfJoint* joint = &urdf.joints[j]; joint->mimic; joint = &urdf.joints[flat.master]) {
      flat.master = find_joint(urdf, joint->mimic->master);
      if (flat.master < 0) fail(follower, "'" + joint->mimic->master + "', which is no joint of the file");
      if (urdf.joints[flat.master].fixed) fail(follower, "the fixed joint '" + joint->mimic->master + "'");
      if (flat.master == static_cast<int>(j))
        fail(follower, links_of_chain == 0 ? "itself" : "itself, through a cycle");
      if (++links_of_chain > urdf.joints.size()) fail(follower, "a cycle of joints");
      flat.offset += flat.multiplier * joint->mimic->offset;
      flat.multiplier *= joint->mimic->multiplier;
    }
  }
  return result;
}

}  // namespace uhas
