#include "tables/profile_summary_table.hpp"

#include <algorithm>
#include <ostream>

#include "json/profile_summary_json.hpp"
#include "text/numbers.hpp"
#include "text/table.hpp"
#include "text/terminal.hpp"
#include "text/words.hpp"

namespace uhas::tools {
namespace {

/// A joint value: degrees, or millimetres with their unit.
std::string joint_value(const Joint& joint, double q) {
  return joint.kind == JointKind::prismatic ? millimetres(q) + " mm" : degrees(q);
}

std::string slots_text(const ProfileFinger& finger) {
  std::vector<std::string> numbers;
  for (const int slot : slot_numbers(finger.slots)) numbers.push_back(std::to_string(slot));
  return join(numbers, ",");
}

/// The joint's class, and what keeps it from being driven.
std::string role_text(const HandProfile& profile, const ProfileFinger& finger, int index) {
  const Joint& joint = profile.tree.joints[index];
  const JointClass joint_class = profile.joint_traits[index].joint_class;
  std::string text = to_word(joint_class);
  if (joint.mimic_master >= 0) return text + ", follows " + profile.tree.joints[joint.mimic_master].name;
  const bool driven = finger.lateral_table >= 0 && profile.lateral_tables[finger.lateral_table].joint == index;
  if (joint_class == JointClass::lateral && !driven) text += ", stays at neutral";
  return text;
}

void print_fingers(std::ostream& out, const HandProfile& profile) {
  Table table({{"finger"},
               {"slots"},
               {"tip link"},
               {"tip phi, deg", Align::right},
               {"sideways range, deg", Align::right},
               {"points", Align::right}});
  for (const ProfileFinger& finger : profile.fingers) {
    std::string range = "-";
    if (finger.lateral_table >= 0) {
      const LateralTable& lateral = profile.lateral_tables[finger.lateral_table];
      range = degrees(lateral.delta_theta_lower) + " .. " + degrees(lateral.delta_theta_upper);
    }
    table.add_row({finger.name, slots_text(finger), profile.links[finger.tip_link].name, degrees(finger.tip_phi), range,
                   std::to_string(points_of_finger(profile, finger))});
  }
  table.print(out);
  std::vector<std::string> without;
  for (const ProfileFinger& finger : profile.fingers)
    if (finger.lateral_table < 0) without.push_back(finger.name);
  if (!without.empty())
    out << "Delta theta is ignored, for want of a lateral joint that moves the tip: " << join(without, ", ") << '\n';
}

void print_joints(std::ostream& out, const HandProfile& profile, bool with_poses) {
  std::vector<Table::Column> columns{
      {"finger"}, {"joint"}, {"class"}, {"lower, deg", Align::right}, {"upper, deg", Align::right}};
  if (with_poses)
    for (const char* pose : {"q_open, deg", "q_sphere, deg", "q_closed, deg"}) columns.push_back({pose, Align::right});
  Table table(columns);
  for (const ProfileFinger& finger : profile.fingers)
    for (const int index : finger.joints) {
      const Joint& joint = profile.tree.joints[index];
      const JointTraits& traits = profile.joint_traits[index];
      const Tone tone = traits.joint_class == JointClass::lateral ? Tone::lateral : Tone::encompassing;
      std::vector<Table::Cell> cells{index == finger.joints.front() ? finger.name : "",
                                     joint.name,
                                     {role_text(profile, finger, index), tone},
                                     joint_value(joint, joint.lower),
                                     joint_value(joint, joint.upper)};
      if (with_poses)
        for (const double q : {traits.q_open, traits.q_sphere, traits.q_closed}) cells.push_back(joint_value(joint, q));
      table.add_row(cells);
    }
  table.print(out);
  if (!profile.other_joints.empty()) out << "Not of a finger: " << join(profile.other_joints, ", ") << '\n';
}

}  // namespace

void print_profile(std::ostream& out, const HandProfile& profile, bool in_full) {
  const RigidTransformd T_root_sphere = profile.T_root_palm * profile.T_palm_sphere;
  const Vector3d center = T_root_sphere.translation;
  const Vector3d normal = T_root_sphere.rotation.column(2);
  const auto used =
      std::ranges::count_if(profile.correspondences, [](const Correspondence& p) { return p.weight > 0; });

  const auto label = [&out](const char* word) { return toned(out, word, Tone::heading); };
  out << label("Hand") << "    " << profile.hand;
  if (profile.handedness != Handedness::none) out << ", a " << to_word(profile.handedness) << " hand";
  out << "\n"
      << label("Palm") << "    link " << profile.palm_link << ", normal (" << fixed(normal.x, 3) << ", "
      << fixed(normal.y, 3) << ", " << fixed(normal.z, 3) << ") in " << profile.root_link << '\n'
      << label("Sphere") << "  radius " << millimetres(profile.radius) << " mm, centre (" << millimetres(center.x)
      << ", " << millimetres(center.y) << ", " << millimetres(center.z) << ") mm in " << profile.root_link << '\n'
      << label("Points") << "  " << profile.correspondences.size() << " on the surface, palm included; the solver uses "
      << used << "\n\n";
  print_fingers(out, profile);
  out << '\n';
  print_joints(out, profile, in_full);
}

}  // namespace uhas::tools
