// One test for each rule of validate_profile: a good profile with one field broken is refused, and the field is named.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/small_profile.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/profile/utf8.hpp"

using uhas::HandProfile;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

struct BrokenRule {
  const char* message;
  void (*break_it)(HandProfile&);
};

const BrokenRule broken_rules[] = {
    {"hand/name is empty", [](HandProfile& p) { p.hand = ""; }},
    {"hand/name is not UTF-8", [](HandProfile& p) { p.hand = "\xff"; }},
    {"hand/name is not UTF-8", [](HandProfile& p) { p.hand = std::string("a\0b", 3); }},
    {"hand/palm_link is empty", [](HandProfile& p) { p.palm_link = ""; }},
    {"hand/root_link is empty", [](HandProfile& p) { p.root_link = ""; }},
    {"hand/handedness is not", [](HandProfile& p) { p.handedness = static_cast<uhas::Handedness>(3); }},
    {"hand/T_root_palm is not", [](HandProfile& p) { p.T_root_palm.translation.x = nan; }},
    {"hand/other_joints[1] is not UTF-8", [](HandProfile& p) { p.other_joints[1] = "\xc0\x80"; }},
    {"hand/warnings[0] is not UTF-8", [](HandProfile& p) { p.warnings[0] = "\xed\xa0\x80"; }},
    {"hand/settings_json is not UTF-8", [](HandProfile& p) { p.settings_json = "\xf5"; }},

    {"sphere/T_palm_sphere is not", [](HandProfile& p) { p.T_palm_sphere.rotation.m[4] += 1e-5; }},
    {"sphere/radius is outside", [](HandProfile& p) { p.radius = 0; }},
    {"sphere/radius_scale is outside", [](HandProfile& p) { p.radius_scale = -1; }},
    {"sphere/mean_tip_distance is outside", [](HandProfile& p) { p.mean_tip_distance = infinity; }},
    {"sphere/palm_center_palm is outside", [](HandProfile& p) { p.palm_center_palm.z = infinity; }},
    {"sphere/palm_plane_rms is outside", [](HandProfile& p) { p.palm_plane_rms = nan; }},

    {"joints/name has no row", [](HandProfile& p) { p.tree.joints.clear(); }},
    {"joints/name[3] is empty", [](HandProfile& p) { p.tree.joints[3].name = ""; }},
    {"joints/name[1] is the name", [](HandProfile& p) { p.tree.joints[1].name = "index_side"; }},
    {"joints/kind[1] is not", [](HandProfile& p) { p.tree.joints[1].kind = static_cast<uhas::JointKind>(7); }},
    {"joints/parent[1] is neither", [](HandProfile& p) { p.tree.joints[1].parent = 1; }},
    {"joints/parent[0] is neither", [](HandProfile& p) { p.tree.joints[0].parent = -2; }},
    {"joints/T_parent_joint[2] is not",
     [](HandProfile& p) { p.tree.joints[2].T_parent_joint.rotation.m = {-1, 0, 0, 0, 1, 0, 0, 0, 1}; }},
    {"joints/axis[2] is not",
     [](HandProfile& p) {
       p.tree.joints[2].axis = {0, 0, 0};
     }},
    {"joints/lower[0] is outside", [](HandProfile& p) { p.tree.joints[0].lower = -infinity; }},
    {"joints/upper[0] is outside", [](HandProfile& p) { p.tree.joints[0].upper = nan; }},
    {"joints/upper[0] is below", [](HandProfile& p) { p.tree.joints[0].upper = -0.6; }},
    {"joints/velocity_limit[4] is outside", [](HandProfile& p) { p.tree.joints[4].velocity_limit = -1; }},
    {"joints/mimic_master[2] is neither", [](HandProfile& p) { p.tree.joints[2].mimic_master = 5; }},
    {"joints/mimic_master[2] is neither", [](HandProfile& p) { p.tree.joints[2].mimic_master = 2; }},
    {"joints/mimic_master[2] is a joint that mimics", [](HandProfile& p) { p.tree.joints[1].mimic_master = 0; }},
    {"joints/mimic_multiplier[2] is outside", [](HandProfile& p) { p.tree.joints[2].mimic_multiplier = nan; }},
    {"joints/mimic_offset[2] is outside", [](HandProfile& p) { p.tree.joints[2].mimic_offset = infinity; }},

    {"joints/class has not one row", [](HandProfile& p) { p.joint_traits.pop_back(); }},
    {"joints/class[1] is neither",
     [](HandProfile& p) { p.joint_traits[1].joint_class = static_cast<uhas::JointClass>(2); }},
    {"joints/lateral_motion[1] is outside", [](HandProfile& p) { p.joint_traits[1].lateral_motion = -1; }},
    {"joints/encompassing_motion[1] is outside", [](HandProfile& p) { p.joint_traits[1].encompassing_motion = nan; }},
    {"joints/margin[1] is outside", [](HandProfile& p) { p.joint_traits[1].margin = 1.1; }},
    {"joints/q_open[1] is outside", [](HandProfile& p) { p.joint_traits[1].q_open = -0.3; }},
    {"joints/q_sphere[1] is outside", [](HandProfile& p) { p.joint_traits[1].q_sphere = nan; }},
    {"joints/q_closed[1] is outside", [](HandProfile& p) { p.joint_traits[1].q_closed = 1.7; }},
    {"joints/q_open[2] does not follow", [](HandProfile& p) { p.joint_traits[2].q_open = 0; }},
    {"joints/q_sphere[2] does not follow", [](HandProfile& p) { p.joint_traits[2].q_sphere = nan; }},

    {"links/name[1] is the name", [](HandProfile& p) { p.links[1].name = "palm"; }},
    {"links/joint[1] is neither", [](HandProfile& p) { p.links[1].joint = 5; }},
    {"links/T_joint_link[1] is not", [](HandProfile& p) { p.links[1].T_joint_link.rotation.m[0] = nan; }},

    {"fingers/name has no row", [](HandProfile& p) { p.fingers.clear(); }},
    {"fingers/name[1] is the name", [](HandProfile& p) { p.fingers[1].name = "index"; }},
    {"fingers/joints[1] has no joint", [](HandProfile& p) { p.fingers[1].joints.clear(); }},
    {"fingers/joints[1] names a joint",
     [](HandProfile& p) {
       p.fingers[1].joints = {3, 5};
     }},
    {"fingers/joints[0] is not a chain",
     [](HandProfile& p) {
       p.fingers[0].joints = {0, 2};
     }},
    {"fingers/tip_link[0] is not a link", [](HandProfile& p) { p.fingers[0].tip_link = 6; }},
    {"fingers/tip_link[0] is not carried", [](HandProfile& p) { p.fingers[0].tip_link = 2; }},
    {"fingers/p_tip_link[0] is outside", [](HandProfile& p) { p.fingers[0].p_tip_link.y = nan; }},
    {"fingers/pad_normal_link[0] is not", [](HandProfile& p) { p.fingers[0].pad_normal_link.y = 0.5; }},
    {"fingers/tip_distance[0] is outside", [](HandProfile& p) { p.fingers[0].tip_distance = 0; }},
    {"fingers/theta_initial[0] is outside", [](HandProfile& p) { p.fingers[0].theta_initial = -pi; }},
    {"fingers/tip_phi[0] is outside", [](HandProfile& p) { p.fingers[0].tip_phi = 3.2; }},
    {"fingers/lateral_table[1] is neither", [](HandProfile& p) { p.fingers[1].lateral_table = 1; }},
    {"fingers/lateral_table[1] is the table of another", [](HandProfile& p) { p.fingers[1].lateral_table = 0; }},
    {"fingers/slots leaves a slot", [](HandProfile& p) { p.fingers[0].slots[2] = false; }},
    {"fingers/slots[1] owns no slot", [](HandProfile& p) { p.fingers[1].slots[4] = false; }},
    {"fingers/slots[1] begins before", [](HandProfile& p) { std::swap(p.fingers[0], p.fingers[1]); }},

    {"lateral_tables/joint[0] is not a joint", [](HandProfile& p) { p.lateral_tables[0].joint = -1; }},
    {"lateral_tables/joint[0] mimics", [](HandProfile& p) { p.lateral_tables[0].joint = 2; }},
    {"lateral_tables/joint[0] is not a lateral", [](HandProfile& p) { p.lateral_tables[0].joint = 1; }},
    {"lateral_tables/q[0] has fewer", [](HandProfile& p) { p.lateral_tables[0].q = {0.1}; }},
    {"lateral_tables/q[0] leaves", [](HandProfile& p) { p.lateral_tables[0].q[0] = -0.6; }},
    {"lateral_tables/q[0] does not increase",
     [](HandProfile& p) {
       p.lateral_tables[0].q = {0, 0, 0, 0, 0};
     }},
    {"lateral_tables/q[0] does not increase in uniform", [](HandProfile& p) { p.lateral_tables[0].q[2] = 0.01; }},
    {"lateral_tables/theta[0] has not as many", [](HandProfile& p) { p.lateral_tables[0].theta.pop_back(); }},
    {"lateral_tables/theta[0] is outside", [](HandProfile& p) { p.lateral_tables[0].theta[1] = nan; }},
    {"lateral_tables/theta[0] is not strictly",
     [](HandProfile& p) { p.lateral_tables[0].theta[1] = p.lateral_tables[0].theta[2]; }},
    {"lateral_tables/neutral[0] is outside", [](HandProfile& p) { p.lateral_tables[0].neutral = 0.45; }},
    {"lateral_tables/neutral[0] differs", [](HandProfile& p) { p.joint_traits[0].q_sphere = 0.2; }},
    {"lateral_tables/theta_initial[0] is outside", [](HandProfile& p) { p.lateral_tables[0].theta_initial = 1; }},
    {"lateral_tables/delta_theta_lower[0] is outside",
     [](HandProfile& p) { p.lateral_tables[0].delta_theta_lower = 0.1; }},
    {"lateral_tables/delta_theta_upper[0] is outside",
     [](HandProfile& p) { p.lateral_tables[0].delta_theta_upper = infinity; }},
    {"lateral_tables/inverse_q[0] has not an odd", [](HandProfile& p) { p.lateral_tables[0].inverse_q.pop_back(); }},
    {"lateral_tables/inverse_q[0] has not an odd", [](HandProfile& p) { p.lateral_tables[0].inverse_q = {0.1}; }},
    {"lateral_tables/inverse_q[0] leaves", [](HandProfile& p) { p.lateral_tables[0].inverse_q[0] = 0.41; }},
    {"lateral_tables/inverse_q[0] does not hold",
     [](HandProfile& p) { p.lateral_tables[0].inverse_q[3] = std::nextafter(0.1, 1.0); }},
    {"lateral_tables/inverse_q[0] does not run", [](HandProfile& p) { p.lateral_tables[0].inverse_q[1] = 0.15; }},

    {"correspondences/link[11] is not a link", [](HandProfile& p) { p.correspondences[11].link = 6; }},
    {"correspondences/link[1] is not a link", [](HandProfile& p) { p.correspondences[1].link = -1; }},
    {"correspondences/link[4] is below", [](HandProfile& p) { p.correspondences[3].link = 4; }},
    {"correspondences/p_link[4] is outside", [](HandProfile& p) { p.correspondences[4].p_link.x = -infinity; }},
    {"correspondences/normal_link[4] is not", [](HandProfile& p) { p.correspondences[4].normal_link.x = 2; }},
    {"correspondences/theta[4] is outside", [](HandProfile& p) { p.correspondences[4].theta = -pi; }},
    {"correspondences/phi[4] is outside", [](HandProfile& p) { p.correspondences[4].phi = -0.1; }},
    {"correspondences/rho[4] is outside", [](HandProfile& p) { p.correspondences[4].rho = 0; }},
    {"correspondences/weight[4] is outside", [](HandProfile& p) { p.correspondences[4].weight = -1; }},

    {"findings/item[0] is empty", [](HandProfile& p) { p.findings[0].item = ""; }},
    {"findings/value[0] is not UTF-8", [](HandProfile& p) { p.findings[0].value = "\xe2\x82"; }},
    {"findings/reason[0] is not UTF-8", [](HandProfile& p) { p.findings[0].reason = "\x80"; }},
    {"findings/confidence[1] is outside", [](HandProfile& p) { p.findings[1].confidence = nan; }},
    {"sources/name[0] is empty", [](HandProfile& p) { p.sources[0].name = ""; }},
    {"sources/name[0] is an absolute", [](HandProfile& p) { p.sources[0].name = "/home/me/hand.urdf"; }},
    {"sources/sha256[1] is not", [](HandProfile& p) { p.sources[1].sha256[5] = 'A'; }},
};

}  // namespace

TEST_CASE("the small profile is valid") {
  CHECK_NOTHROW(uhas::validate_profile(uhas::test::small_profile(), "hand.h5"));
}

TEST_CASE("two fingers may share a slot") {
  HandProfile profile = uhas::test::small_profile();
  profile.fingers[1].slots[3] = true;
  CHECK_NOTHROW(uhas::validate_profile(profile, "hand.h5"));
}

TEST_CASE("a profile with one broken field is refused by the name of the field") {
  for (const BrokenRule& rule : broken_rules) {
    CAPTURE(rule.message);
    HandProfile profile = uhas::test::small_profile();
    rule.break_it(profile);
    try {
      uhas::validate_profile(profile, "hand.h5");
      FAIL_CHECK("accepted");
    } catch (const uhas::Error& error) {
      const std::string what = error.what();
      CHECK(error.code() == uhas::ErrorCode::invalid_profile);
      CHECK_MESSAGE(what.starts_with(std::string("hand.h5: ") + rule.message), what);
      CHECK(what.ends_with("; rebuild it with uhas-build-profile"));
    }
  }
}

TEST_CASE("UTF-8 is told from other bytes") {
  for (const char* text : {"", "hand", "\xc3\xbc", "\xe2\x82\xac", "\xf0\x9f\xa4\x96", "\xf4\x8f\xbf\xbf"})
    CHECK_MESSAGE(uhas::is_utf8(text), text);
  for (const char* text : {"\x80", "\xc3", "\xc0\xaf", "\xc3z", "\xe0\x80\xaf", "\xe2\x82", "\xed\xbf\xbf",
                           "\xf0\x80\x80\xaf", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xff"})
    CHECK_FALSE(uhas::is_utf8(text));
}
