#include "uhas/profile/hand_profile.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <set>
#include <span>

#include "uhas/base/errors.hpp"
#include "uhas/profile/utf8.hpp"

namespace uhas {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double unit_tolerance = 1e-6;     // of unit vectors, rotation matrices and uniform steps
constexpr double posture_tolerance = 1e-9;  // of joint values that must agree
constexpr double largest = 1e6;  // no number of a hand comes near; keeps sums of products finite, in float too
constexpr double smallest_positive = 1e-6;  // of what the runtime divides by

/// A dataset of the file format and a row of it, spelt out only when the row is refused.
struct Field {
  const char* dataset;
  std::ptrdiff_t row = -1;
};

bool is_bounded(double value) { return std::abs(value) <= largest; }
bool is_bounded(Vector3d a) { return is_bounded(a.x) && is_bounded(a.y) && is_bounded(a.z); }
bool is_non_negative(double value) { return value >= 0 && value <= largest; }
bool is_positive(double value) { return value >= smallest_positive && value <= largest; }

bool is_rigid(const RigidTransformd& T) {
  const Rotationd& R = T.rotation;
  const Vector3d x = R.column(0), y = R.column(1), z = R.column(2);
  const Rotationd gram = R.transposed() * R;
  for (int i = 0; i < 9; ++i)
    if (!(std::abs(gram.m[i] - (i % 4 == 0)) <= unit_tolerance)) return false;
  return dot(cross(x, y), z) > 0 && is_bounded(T.translation);
}

bool is_unit(Vector3d a) { return std::abs(norm(a) - 1) <= unit_tolerance; }
bool is_azimuth(double angle) { return angle > -pi && angle <= pi; }
bool is_polar_angle(double angle) { return angle >= 0 && angle <= pi; }
bool is_index(int index, std::size_t count) { return index >= 0 && static_cast<std::size_t>(index) < count; }
bool is_index_or_none(int index, std::size_t count) { return index == -1 || is_index(index, count); }
bool all_within(std::span<const double> values, double lower, double upper) {
  return std::all_of(values.begin(), values.end(), [=](double value) { return value >= lower && value <= upper; });
}
bool is_sha256(const std::string& hex) {
  return hex.size() == 64 && hex.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// What a rule that does not hold is reported with: the file, the dataset and the row.
class Rules {
 public:
  explicit Rules(const std::string& file) : file_(file) {}

  void require(bool holds, Field field, const char* rule) const {
    if (holds) return;
    std::string place = field.dataset;
    if (field.row >= 0) place += "[" + std::to_string(field.row) + "]";
    throw Error(ErrorCode::invalid_profile, file_, place + " " + rule, "rebuild it with uhas-build-profile");
  }

  void require_text(const std::string& text, Field field) const {
    require(text.find('\0') == std::string::npos && is_utf8(text), field, "is not UTF-8 text without NUL characters");
  }
  void require_name(const std::string& name, Field field) const {
    require(!name.empty(), field, "is empty");
    require_text(name, field);
  }
  template <class Row>
  void require_distinct_names(const std::vector<Row>& rows, const char* dataset) const {
    std::set<std::string> seen;
    for (std::ptrdiff_t i = 0; i < std::ssize(rows); ++i) {
      require_name(rows[i].name, {dataset, i});
      require(seen.insert(rows[i].name).second, {dataset, i}, "is the name of an earlier row");
    }
  }
  void require_texts(const std::vector<std::string>& texts, const char* dataset) const {
    for (std::ptrdiff_t i = 0; i < std::ssize(texts); ++i) require_text(texts[i], {dataset, i});
  }

 private:
  const std::string& file_;
};

void validate_hand(const HandProfile& profile, const Rules& rules) {
  rules.require_name(profile.hand, {"hand/name"});
  rules.require_name(profile.palm_link, {"hand/palm_link"});
  rules.require_name(profile.root_link, {"hand/root_link"});
  rules.require(profile.handedness >= Handedness::none && profile.handedness <= Handedness::left, {"hand/handedness"},
                "is not 0, 1 or 2");
  rules.require(is_rigid(profile.T_root_palm), {"hand/T_root_palm"}, "is not a rigid transform");
  rules.require_texts(profile.other_joints, "hand/other_joints");
  rules.require_texts(profile.warnings, "hand/warnings");
  rules.require_text(profile.settings_json, {"hand/settings_json"});
}

void validate_sphere(const HandProfile& profile, const Rules& rules) {
  rules.require(is_rigid(profile.T_palm_sphere), {"sphere/T_palm_sphere"}, "is not a rigid transform");
  rules.require(is_positive(profile.radius), {"sphere/radius"}, "is outside [1e-6, 1e6]");
  rules.require(is_positive(profile.radius_scale), {"sphere/radius_scale"}, "is outside [1e-6, 1e6]");
  rules.require(is_positive(profile.mean_tip_distance), {"sphere/mean_tip_distance"}, "is outside [1e-6, 1e6]");
  rules.require(is_bounded(profile.palm_center_palm), {"sphere/palm_center_palm"}, "is outside [-1e6, 1e6]");
  rules.require(is_non_negative(profile.palm_plane_rms), {"sphere/palm_plane_rms"}, "is outside [0, 1e6]");
}

void validate_joints(const HandProfile& profile, const Rules& rules) {
  const std::vector<Joint>& joints = profile.tree.joints;
  rules.require(!joints.empty(), {"joints/name"}, "has no row");
  rules.require_distinct_names(joints, "joints/name");
  for (std::ptrdiff_t i = 0; i < std::ssize(joints); ++i) {
    const Joint& joint = joints[i];
    rules.require(joint.kind >= JointKind::revolute && joint.kind <= JointKind::prismatic, {"joints/kind", i},
                  "is not 0, 1 or 2");
    rules.require(joint.parent >= -1 && joint.parent < i, {"joints/parent", i}, "is neither -1 nor an earlier joint");
    rules.require(is_rigid(joint.T_parent_joint), {"joints/T_parent_joint", i}, "is not a rigid transform");
    rules.require(is_unit(joint.axis), {"joints/axis", i}, "is not a unit vector");
    rules.require(is_bounded(joint.lower), {"joints/lower", i}, "is outside [-1e6, 1e6]");
    rules.require(is_bounded(joint.upper), {"joints/upper", i}, "is outside [-1e6, 1e6]");
    rules.require(joint.lower <= joint.upper, {"joints/upper", i}, "is below joints/lower");
    rules.require(is_non_negative(joint.velocity_limit), {"joints/velocity_limit", i}, "is outside [0, 1e6]");
    rules.require(is_index_or_none(joint.mimic_master, joints.size()) && joint.mimic_master != i,
                  {"joints/mimic_master", i}, "is neither -1 nor another joint");
    rules.require(joint.mimic_master < 0 || joints[joint.mimic_master].mimic_master < 0, {"joints/mimic_master", i},
                  "is a joint that mimics another");
    rules.require(is_bounded(joint.mimic_multiplier), {"joints/mimic_multiplier", i}, "is outside [-1e6, 1e6]");
    rules.require(is_bounded(joint.mimic_offset), {"joints/mimic_offset", i}, "is outside [-1e6, 1e6]");
  }
}

/// Independent joints stand within their limits; a follower stands where its master puts it, limits or not.
void validate_posture(const HandProfile& profile, const Rules& rules, const char* dataset,
                      double JointTraits::*posture) {
  const std::vector<Joint>& joints = profile.tree.joints;
  for (std::ptrdiff_t i = 0; i < std::ssize(joints); ++i) {
    const double q = profile.joint_traits[i].*posture;
    if (joints[i].mimic_master < 0) {
      rules.require(q >= joints[i].lower && q <= joints[i].upper, {dataset, i}, "is outside the joint's limits");
    } else {
      const double q_master = profile.joint_traits[joints[i].mimic_master].*posture;
      const double followed = joints[i].mimic_multiplier * q_master + joints[i].mimic_offset;
      rules.require(std::abs(q - followed) <= posture_tolerance, {dataset, i}, "does not follow the joint's master");
    }
  }
}

void validate_traits(const HandProfile& profile, const Rules& rules) {
  const std::vector<JointTraits>& traits = profile.joint_traits;
  rules.require(traits.size() == profile.tree.joints.size(), {"joints/class"}, "has not one row a joint");
  for (std::ptrdiff_t i = 0; i < std::ssize(traits); ++i) {
    const JointTraits& trait = traits[i];
    rules.require(trait.joint_class == JointClass::lateral || trait.joint_class == JointClass::encompassing,
                  {"joints/class", i}, "is neither 0 nor 1");
    rules.require(is_non_negative(trait.lateral_motion), {"joints/lateral_motion", i}, "is outside [0, 1e6]");
    rules.require(is_non_negative(trait.encompassing_motion), {"joints/encompassing_motion", i}, "is outside [0, 1e6]");
    rules.require(trait.margin >= 0 && trait.margin <= 1, {"joints/margin", i}, "is outside [0, 1]");
  }
  validate_posture(profile, rules, "joints/q_open", &JointTraits::q_open);
  validate_posture(profile, rules, "joints/q_sphere", &JointTraits::q_sphere);
  validate_posture(profile, rules, "joints/q_closed", &JointTraits::q_closed);
}

void validate_links(const HandProfile& profile, const Rules& rules) {
  rules.require_distinct_names(profile.links, "links/name");
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.links); ++i) {
    const ProfileLink& link = profile.links[i];
    rules.require(is_index_or_none(link.joint, profile.tree.joints.size()), {"links/joint", i},
                  "is neither -1 nor a joint");
    rules.require(is_rigid(link.T_joint_link), {"links/T_joint_link", i}, "is not a rigid transform");
  }
}

/// Root to tip: each joint after the first is carried by the one before it.
void validate_chain(const HandProfile& profile, const Rules& rules, const std::vector<int>& chain, Field field) {
  rules.require(!chain.empty(), field, "has no joint");
  for (std::size_t k = 0; k < chain.size(); ++k) {
    rules.require(is_index(chain[k], profile.tree.joints.size()), field, "names a joint that does not exist");
    rules.require(k == 0 || profile.tree.joints[chain[k]].parent == chain[k - 1], field,
                  "is not a chain from root to tip");
  }
}

void validate_fingers(const HandProfile& profile, const Rules& rules) {
  rules.require(!profile.fingers.empty(), {"fingers/name"}, "has no row");
  rules.require_distinct_names(profile.fingers, "fingers/name");
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.fingers); ++i) {
    const ProfileFinger& finger = profile.fingers[i];
    validate_chain(profile, rules, finger.joints, {"fingers/joints", i});
    rules.require(is_index(finger.tip_link, profile.links.size()), {"fingers/tip_link", i}, "is not a link");
    rules.require(profile.links[finger.tip_link].joint == finger.joints.back(), {"fingers/tip_link", i},
                  "is not carried by the finger's last joint");
    rules.require(is_bounded(finger.p_tip_link), {"fingers/p_tip_link", i}, "is outside [-1e6, 1e6]");
    rules.require(is_unit(finger.pad_normal_link), {"fingers/pad_normal_link", i}, "is not a unit vector");
    rules.require(is_positive(finger.tip_distance), {"fingers/tip_distance", i}, "is outside [1e-6, 1e6]");
    rules.require(is_azimuth(finger.theta_initial), {"fingers/theta_initial", i}, "is outside (-pi, pi]");
    rules.require(is_polar_angle(finger.tip_phi), {"fingers/tip_phi", i}, "is outside [0, pi]");
    rules.require(is_index_or_none(finger.lateral_table, profile.lateral_tables.size()), {"fingers/lateral_table", i},
                  "is neither -1 nor a lateral table");
  }
}

void validate_slots(const HandProfile& profile, const Rules& rules) {
  std::array<int, kSlotCount> owners{};
  int previous_first_slot = -1;
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.fingers); ++i) {
    const auto& slots = profile.fingers[i].slots;
    for (int slot = 0; slot < kSlotCount; ++slot) owners[slot] += slots[slot];
    const auto first_slot = static_cast<int>(std::find(slots.begin(), slots.end(), true) - slots.begin());
    rules.require(first_slot < kSlotCount, {"fingers/slots", i}, "owns no slot");
    rules.require(first_slot >= previous_first_slot, {"fingers/slots", i}, "begins before the row above it");
    previous_first_slot = first_slot;
  }
  for (const int owner_count : owners)
    rules.require(owner_count > 0, {"fingers/slots"}, "leaves a slot without a finger");
}

void validate_forward_table(const HandProfile& profile, const Rules& rules, const LateralTable& table,
                            std::ptrdiff_t i) {
  const Joint& joint = profile.tree.joints[table.joint];
  const std::size_t n = table.q.size();
  rules.require(n >= 2, {"lateral_tables/q", i}, "has fewer than two values");
  rules.require(table.theta.size() == n, {"lateral_tables/theta", i}, "has not as many values as lateral_tables/q");
  rules.require(all_within(table.q, joint.lower, joint.upper), {"lateral_tables/q", i}, "leaves the joint's limits");
  rules.require(all_within(table.theta, -largest, largest), {"lateral_tables/theta", i}, "is outside [-1e6, 1e6]");
  const double step = (table.q.back() - table.q.front()) / static_cast<double>(n - 1);
  rules.require(step > 0, {"lateral_tables/q", i}, "does not increase");
  const bool rises = table.theta.back() > table.theta.front();
  for (std::size_t k = 1; k < n; ++k) {
    rules.require(std::abs(table.q[k] - table.q[k - 1] - step) <= unit_tolerance * step, {"lateral_tables/q", i},
                  "does not increase in uniform steps");
    rules.require(rises ? table.theta[k] > table.theta[k - 1] : table.theta[k] < table.theta[k - 1],
                  {"lateral_tables/theta", i}, "is not strictly monotone");
  }
  rules.require(table.neutral >= table.q.front() && table.neutral <= table.q.back(), {"lateral_tables/neutral", i},
                "is outside lateral_tables/q");
  const auto [lowest, highest] = std::minmax(table.theta.front(), table.theta.back());
  rules.require(table.theta_initial >= lowest && table.theta_initial <= highest, {"lateral_tables/theta_initial", i},
                "is outside lateral_tables/theta");
}

void validate_inverse_table(const Rules& rules, const LateralTable& table, std::ptrdiff_t i) {
  rules.require(is_bounded(table.delta_theta_lower) && table.delta_theta_lower <= 0,
                {"lateral_tables/delta_theta_lower", i}, "is outside [-1e6, 0]");
  rules.require(is_bounded(table.delta_theta_upper) && table.delta_theta_upper >= 0,
                {"lateral_tables/delta_theta_upper", i}, "is outside [0, 1e6]");
  const std::size_t n = table.inverse_q.size();
  rules.require(n >= 3 && n % 2 == 1, {"lateral_tables/inverse_q", i},
                "has not an odd number of at least three values");
  rules.require(all_within(table.inverse_q, table.q.front(), table.q.back()), {"lateral_tables/inverse_q", i},
                "leaves the range of lateral_tables/q");
  rules.require(std::bit_cast<std::uint64_t>(table.inverse_q[n / 2]) == std::bit_cast<std::uint64_t>(table.neutral),
                {"lateral_tables/inverse_q", i}, "does not hold lateral_tables/neutral in its middle");
  const bool rises = table.theta.back() > table.theta.front();
  rules.require(rises ? std::is_sorted(table.inverse_q.begin(), table.inverse_q.end())
                      : std::is_sorted(table.inverse_q.rbegin(), table.inverse_q.rend()),
                {"lateral_tables/inverse_q", i}, "does not run the way of lateral_tables/theta");
}

void validate_lateral_tables(const HandProfile& profile, const Rules& rules) {
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.lateral_tables); ++i) {
    const LateralTable& table = profile.lateral_tables[i];
    rules.require(is_index(table.joint, profile.tree.joints.size()), {"lateral_tables/joint", i}, "is not a joint");
    rules.require(profile.tree.joints[table.joint].mimic_master < 0, {"lateral_tables/joint", i},
                  "mimics another joint");
    rules.require(profile.joint_traits[table.joint].joint_class == JointClass::lateral, {"lateral_tables/joint", i},
                  "is not a lateral joint");
    validate_forward_table(profile, rules, table, i);
    validate_inverse_table(rules, table, i);
  }
}

/// A finger's table drives one of the finger's own joints, and leaves it at q_sphere for a zero action.
void validate_driving_tables(const HandProfile& profile, const Rules& rules) {
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.fingers); ++i) {
    const ProfileFinger& finger = profile.fingers[i];
    if (finger.lateral_table < 0) continue;
    const LateralTable& table = profile.lateral_tables[finger.lateral_table];
    rules.require(std::find(finger.joints.begin(), finger.joints.end(), table.joint) != finger.joints.end(),
                  {"fingers/lateral_table", i}, "is the table of another finger's joint");
    rules.require(std::abs(table.neutral - profile.joint_traits[table.joint].q_sphere) <= posture_tolerance,
                  {"lateral_tables/neutral", finger.lateral_table}, "differs from the joint's joints/q_sphere");
  }
}

void validate_correspondences(const HandProfile& profile, const Rules& rules) {
  int previous_link = 0;
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.correspondences); ++i) {
    const Correspondence& point = profile.correspondences[i];
    rules.require(is_index(point.link, profile.links.size()), {"correspondences/link", i}, "is not a link");
    rules.require(point.link >= previous_link, {"correspondences/link", i},
                  "is below the row above it: not sorted by link");
    rules.require(is_bounded(point.p_link), {"correspondences/p_link", i}, "is outside [-1e6, 1e6]");
    rules.require(is_unit(point.normal_link), {"correspondences/normal_link", i}, "is not a unit vector");
    rules.require(is_azimuth(point.theta), {"correspondences/theta", i}, "is outside (-pi, pi]");
    rules.require(is_polar_angle(point.phi), {"correspondences/phi", i}, "is outside [0, pi]");
    rules.require(is_positive(point.rho), {"correspondences/rho", i}, "is outside [1e-6, 1e6]");
    rules.require(is_non_negative(point.weight), {"correspondences/weight", i}, "is outside [0, 1e6]");
    previous_link = point.link;
  }
}

void validate_provenance(const HandProfile& profile, const Rules& rules) {
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.findings); ++i) {
    const HandFinding& finding = profile.findings[i];
    rules.require_name(finding.item, {"findings/item", i});
    rules.require_text(finding.value, {"findings/value", i});
    rules.require_text(finding.reason, {"findings/reason", i});
    rules.require(finding.confidence >= 0 && finding.confidence <= 1, {"findings/confidence", i}, "is outside [0, 1]");
  }
  for (std::ptrdiff_t i = 0; i < std::ssize(profile.sources); ++i) {
    const SourceFile& source = profile.sources[i];
    rules.require_name(source.name, {"sources/name", i});
    rules.require(source.name.front() != '/', {"sources/name", i}, "is an absolute path");
    rules.require(is_sha256(source.sha256), {"sources/sha256", i}, "is not 64 lower-case hexadecimal digits");
  }
}

}  // namespace

void validate_profile(const HandProfile& profile, const std::string& file) {
  const Rules rules(file);
  for (const auto& validate : {validate_hand, validate_sphere, validate_joints, validate_traits, validate_links,
                               validate_fingers, validate_slots, validate_lateral_tables, validate_driving_tables,
                               validate_correspondences, validate_provenance})
    validate(profile, rules);
}

}  // namespace uhas
