// The graph checks by themselves: they do not lean on what urdfdom refuses.
#include "model_fixture.hpp"
#include "uhas/model/link_order_detail.hpp"

using namespace uhas;
using namespace uhas::test;
using detail::Urdf;
using detail::UrdfJoint;

namespace {

UrdfJoint edge(const std::string& name, const std::string& parent, const std::string& child) {
  UrdfJoint result;
  result.joint.name = name;
  result.parent_link = parent;
  result.child_link = child;
  return result;
}

void check_order_error(const std::vector<UrdfJoint>& joints, const std::vector<std::string>& words) {
  const Urdf urdf{"hand", {{"a", {}, {}}, {"b", {}, {}}, {"c", {}, {}}}, joints};
  check_error([&] { detail::order_links(urdf, "hand.urdf"); }, ErrorCode::invalid_model, words);
}

}  // namespace

TEST_CASE("graphs that are no tree") {
  check_order_error({edge("j", "x", "b")}, {"joint 'j' has the unknown parent link 'x'"});
  check_order_error({edge("j", "a", "x")}, {"joint 'j' has the unknown child link 'x'"});
  check_order_error({edge("j", "a", "a")}, {"one link as parent and child"});
  check_order_error({edge("j", "a", "b")}, {"several root links, 'a' and 'c'"});
  check_order_error({edge("j", "a", "b"), edge("k", "b", "c"), edge("l", "c", "a")}, {"form a cycle"});
  check_order_error({edge("j", "b", "c"), edge("k", "c", "b")}, {"'b' hangs on a cycle"});
  check_order_error({edge("j", "a", "c"), edge("k", "b", "c")}, {"'c' has two parents"});
}
