// Links, joints, limits and mimic couplings of loaded models.
#include <cmath>
#include <limits>
#include <numbers>

#include "model_fixture.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

std::vector<std::string> link_names(const HandModel& model) {
  std::vector<std::string> names;
  for (const ModelLink& l : model.links) names.push_back(l.name);
  return names;
}

const Joint& find_joint(const HandModel& model, const std::string& name) {
  const auto found = std::ranges::find(model.tree.joints, name, &Joint::name);
  REQUIRE(found != model.tree.joints.end());
  return *found;
}

}  // namespace

TEST_CASE("links are ordered depth first, siblings by name, whatever the order in the file") {
  const std::string links = link("a_tip") + link("b") + link("a") + link("palm") + link("c");
  const std::string joints =
      joint("j3", "palm", "c") + joint("j1", "a", "a_tip") + joint("j0", "palm", "b") + joint("j2", "palm", "a");
  for (const std::string& urdf : {robot(links + joints), robot(joints + links)}) {
    const HandModel model = load(urdf);
    CHECK(link_names(model) == std::vector<std::string>{"palm", "a", "a_tip", "b", "c"});
    std::vector<std::string> joint_names;
    for (const Joint& j : model.tree.joints) joint_names.push_back(j.name);
    CHECK(joint_names == std::vector<std::string>{"j2", "j1", "j0", "j3"});
    CHECK(model.links[2].parent_link == 1);
    CHECK(model.links[2].joint == 1);
    CHECK(model.tree.joints[1].parent == 0);
    CHECK(model.name == "hand");
  }
}

TEST_CASE("fixed joints are folded into joints and links") {
  const HandModel model = load(robot(link("base") + link("palm") + link("finger") + link("tip") +
                                     joint("mount", "base", "palm", "", "fixed") + joint("knuckle", "palm", "finger") +
                                     joint("tip_mount", "finger", "tip", "", "fixed")));
  REQUIRE(model.tree.joints.size() == 1);
  CHECK(model.tree.joints[0].parent == -1);
  check_near(model.tree.joints[0].T_parent_joint.translation, {0, 0, 2});
  CHECK(model.links[1].joint == -1);
  check_near(model.links[1].T_joint_link.translation, {0, 0, 1});
  CHECK(model.links[3].joint == 0);
  check_near(model.links[3].T_joint_link.translation, {0, 0, 1});
}

TEST_CASE("an origin's rpy turns about the fixed x, then y, then z axis") {
  const HandModel model = load(robot(
      link("palm") + link("finger") +
      R"(<joint name="j" type="continuous"><origin rpy="1.5707963267948966 0 1.5707963267948966"/><axis xyz="1 0 0"/>)"
      R"(<parent link="palm"/><child link="finger"/></joint>)"));
  check_near(model.tree.joints[0].T_parent_joint.rotation * Vector3d{0, 1, 0}, {0, 0, 1});
  check_near(model.tree.joints[0].T_parent_joint.rotation * Vector3d{1, 0, 0}, {0, 1, 0});
}

TEST_CASE("revolute, continuous and prismatic joints keep their kinds and limits") {
  const HandModel model =
      load(robot(link("palm") + link("a") + link("b") + link("c") + joint("r", "palm", "a") +
                 joint("k", "palm", "b", "", "continuous") + joint("p", "palm", "c", unit_limit, "prismatic")));
  const Joint& revolute = find_joint(model, "r");
  CHECK(revolute.kind == JointKind::revolute);
  CHECK(revolute.lower == -1);
  CHECK(revolute.upper == 1);
  CHECK(revolute.velocity_limit == 2);
  const Joint& continuous = find_joint(model, "k");
  CHECK(continuous.kind == JointKind::continuous);
  CHECK(continuous.lower == -std::numeric_limits<double>::infinity());
  CHECK(continuous.upper == std::numeric_limits<double>::infinity());
  CHECK(find_joint(model, "p").kind == JointKind::prismatic);
}

TEST_CASE("an axis that is not of unit length is normalised; a missing one is x") {
  const HandModel model = load(
      robot(link("palm") + link("a") + link("b") +
            R"(<joint name="long" type="continuous"><axis xyz="0 3 4"/><parent link="palm"/><child link="a"/></joint>)"
            R"(<joint name="none" type="continuous"><parent link="palm"/><child link="b"/></joint>)"));
  check_near(find_joint(model, "long").axis, {0, 0.6, 0.8});
  check_near(find_joint(model, "none").axis, {1, 0, 0});
}

TEST_CASE("zero may lie outside a joint's limits") {
  const HandModel model =
      load(robot(link("palm") + link("a") +
                 joint("j", "palm", "a", R"(<limit lower="0.3" upper="1.4" effort="1" velocity="1"/>)")));
  CHECK(model.tree.joints[0].lower == 0.3);
  CHECK(model.warnings.empty());
}

TEST_CASE("a limit may leave out effort and velocity") {
  const HandModel model =
      load(robot(link("palm") + link("a") + joint("j", "palm", "a", R"(<limit lower="0" upper="1"/>)")));
  CHECK(model.tree.joints[0].upper == 1);
  CHECK(model.tree.joints[0].velocity_limit == 0);
}

TEST_CASE("a joint whose limits are equal is a warning") {
  const HandModel model =
      load(robot(link("palm") + link("a") + joint("stuck", "palm", "a", R"(<limit effort="1" velocity="1"/>)")));
  REQUIRE(model.warnings.size() == 1);
  CHECK(model.warnings[0].find("joint 'stuck' cannot move") != std::string::npos);
}

TEST_CASE("a joint and a link may have one name") {
  const HandModel model = load(robot(link("palm") + link("thumb") + joint("thumb", "palm", "thumb")));
  CHECK(model.links[1].name == "thumb");
  CHECK(model.tree.joints[0].name == "thumb");
}

TEST_CASE("chains of mimics are flattened, also when the master comes later in the order") {
  const HandModel model = load(robot(link("palm") + link("a") + link("b") + link("z") +
                                     joint("first", "palm", "a", mimic("second", R"(multiplier="2" offset="0.5")")) +
                                     joint("second", "palm", "b", mimic("master", R"(multiplier="-3" offset="0.1")")) +
                                     joint("master", "palm", "z")));
  const Joint& first = find_joint(model, "first");
  REQUIRE(first.mimic_master == 2);
  CHECK(model.tree.joints[2].name == "master");
  CHECK(first.mimic_multiplier == doctest::Approx(-6));
  CHECK(first.mimic_offset == doctest::Approx(2 * 0.1 + 0.5));
  CHECK(first.lower == -1);
  CHECK(find_joint(model, "second").mimic_multiplier == -3);
  CHECK(find_joint(model, "master").mimic_master == -1);
}

TEST_CASE("a mimic without multiplier and offset follows one to one") {
  const HandModel model =
      load(robot(link("palm") + link("a") + link("b") + joint("m", "palm", "a") + joint("f", "palm", "b", mimic("m"))));
  CHECK(find_joint(model, "f").mimic_multiplier == 1);
  CHECK(find_joint(model, "f").mimic_offset == 0);
}

TEST_CASE("without load_meshes no mesh file is needed") {
  ModelLoadOptions options;
  options.load_meshes = false;
  const HandModel model = load(one_finger(visual(mesh("missing.stl"))), options);
  CHECK(model.links[0].mesh.triangles.empty());
  CHECK(model.sources.size() == 1);
}
