// The layout of the file: every dataset, said once. The writer and the reader both walk through it, so they cannot
// disagree; schemas/hand-profile-v1.md is its description for people.
#pragma once

#include <functional>

#include "uhas/profile/hand_profile.hpp"
#include "uhas/profile_io/layout/element.hpp"

namespace uhas {

// clang-format off
/// Shows `archive` every dataset of `profile` in turn: `value` holds one field, `table` one row an element of a vector,
/// with a dataset for each column. `Profile` is HandProfile, constant for a writer. In one piece: it is the list of datasets.
template <class Archive, class Profile>
void visit_layout(Archive& archive, Profile& p) {
  archive.value("hand", Column{"name", "", &HandProfile::hand}, p);
  archive.value("hand", Column{"handedness", "", &HandProfile::handedness}, p);
  archive.value("hand", Column{"mirrored", "", &HandProfile::mirrored}, p);
  archive.value("hand", Column{"palm_link", "", &HandProfile::palm_link}, p);
  archive.value("hand", Column{"root_link", "", &HandProfile::root_link}, p);
  archive.value("hand", Column{"T_root_palm", "m", &HandProfile::T_root_palm}, p);
  archive.value("hand", Column{"settings_json", "", &HandProfile::settings_json}, p);
  archive.table("hand", p.other_joints, Column{"other_joints", "", std::identity{}});
  archive.table("hand", p.warnings, Column{"warnings", "", std::identity{}});

  archive.value("sphere", Column{"T_palm_sphere", "m", &HandProfile::T_palm_sphere}, p);
  archive.value("sphere", Column{"radius", "m", &HandProfile::radius}, p);
  archive.value("sphere", Column{"radius_scale", "1", &HandProfile::radius_scale}, p);
  archive.value("sphere", Column{"mean_tip_distance", "m", &HandProfile::mean_tip_distance}, p);
  archive.value("sphere", Column{"palm_center_palm", "m", &HandProfile::palm_center_palm}, p);
  archive.value("sphere", Column{"palm_plane_rms", "m", &HandProfile::palm_plane_rms}, p);

  archive.table("joints", p.tree.joints,
                Column{"name", "", &Joint::name},
                Column{"kind", "", &Joint::kind},
                Column{"parent", "", &Joint::parent},
                Column{"T_parent_joint", "m", &Joint::T_parent_joint},
                Column{"axis", "1", &Joint::axis},
                Column{"lower", "rad or m", &Joint::lower},
                Column{"upper", "rad or m", &Joint::upper},
                Column{"velocity_limit", "rad/s or m/s", &Joint::velocity_limit},
                Column{"mimic_master", "", &Joint::mimic_master},
                Column{"mimic_multiplier", "1", &Joint::mimic_multiplier},
                Column{"mimic_offset", "rad or m", &Joint::mimic_offset});

  archive.table("joints", p.joint_traits,
                Column{"class", "", &JointTraits::joint_class},
                Column{"lateral_motion", "m", &JointTraits::lateral_motion},
                Column{"encompassing_motion", "m", &JointTraits::encompassing_motion},
                Column{"margin", "1", &JointTraits::margin},
                Column{"flexed_probe", "", &JointTraits::flexed_probe},
                Column{"q_open", "rad or m", &JointTraits::q_open},
                Column{"q_sphere", "rad or m", &JointTraits::q_sphere},
                Column{"q_closed", "rad or m", &JointTraits::q_closed});

  archive.table("links", p.links,
                Column{"name", "", &ProfileLink::name},
                Column{"joint", "", &ProfileLink::joint},
                Column{"T_joint_link", "m", &ProfileLink::T_joint_link});

  archive.table("fingers", p.fingers,
                Column{"name", "", &ProfileFinger::name},
                Column{"slots", "", &ProfileFinger::slots},
                Column{"joints", "", &ProfileFinger::joints},
                Column{"tip_link", "", &ProfileFinger::tip_link},
                Column{"p_tip_link", "m", &ProfileFinger::p_tip_link},
                Column{"pad_normal_link", "1", &ProfileFinger::pad_normal_link},
                Column{"tip_distance", "m", &ProfileFinger::tip_distance},
                Column{"theta_initial", "rad", &ProfileFinger::theta_initial},
                Column{"tip_phi", "rad", &ProfileFinger::tip_phi},
                Column{"lateral_table", "", &ProfileFinger::lateral_table});

  archive.table("lateral_tables", p.lateral_tables,
                Column{"joint", "", &LateralTable::joint},
                Column{"neutral", "rad or m", &LateralTable::neutral},
                Column{"theta_initial", "rad", &LateralTable::theta_initial},
                Column{"q", "rad or m", &LateralTable::q},
                Column{"theta", "rad", &LateralTable::theta},
                Column{"delta_theta_lower", "rad", &LateralTable::delta_theta_lower},
                Column{"delta_theta_upper", "rad", &LateralTable::delta_theta_upper},
                Column{"inverse_q", "rad or m", &LateralTable::inverse_q});

  archive.table("correspondences", p.correspondences,
                Column{"link", "", &Correspondence::link},
                Column{"p_link", "m", &Correspondence::p_link},
                Column{"normal_link", "1", &Correspondence::normal_link},
                Column{"theta", "rad", &Correspondence::theta},
                Column{"phi", "rad", &Correspondence::phi},
                Column{"rho", "1", &Correspondence::rho},
                Column{"weight", "1", &Correspondence::weight});

  archive.table("findings", p.findings,
                Column{"item", "", &HandFinding::item},
                Column{"value", "", &HandFinding::value},
                Column{"reason", "", &HandFinding::reason},
                Column{"confidence", "1", &HandFinding::confidence});

  archive.table("sources", p.sources,
                Column{"name", "", &SourceFile::name},
                Column{"sha256", "", &SourceFile::sha256});
}
// clang-format on

}  // namespace uhas
