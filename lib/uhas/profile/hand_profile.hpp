// The hand profile: all that the runtime knows of a hand. Plain data; `schemas/hand-profile-v1.md` is its file form.
// Units: metres and radians. Frames: P = palm link, S = sphere frame (fixed to P), L = a link, J = a joint's moved
// frame. On a left hand (`mirrored`) every azimuth below is canonical, that is the negative of the azimuth in S.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "uhas/base/export.hpp"
#include "uhas/base/kinematic_tree.hpp"

namespace uhas {

inline constexpr int kProfileVersionMajor = 1;
inline constexpr int kProfileVersionMinor = 0;

/// Canonical driving planes: 0 pinky, 1 ring, 2 middle, 3 index, 4 thumb.
inline constexpr int kSlotCount = 5;
/// Driving vectors in a plane: 1 to 4.
inline constexpr int kMaxDrivingVectors = 4;
/// Bounds of a radial displacement, in sphere radii.
inline constexpr double kRadialBound = 2.0;

enum class Handedness : int { none = 0, right = 1, left = 2 };

/// What a joint mainly does to its fingertip (paper, section 3.4).
enum class JointClass : int { lateral = 0, encompassing = 1 };

/// What the preprocessing found out about the joint of the same index in `HandProfile::tree`.
struct JointTraits {
  JointClass joint_class = JointClass::encompassing;
  double lateral_motion = 0;       ///< fingertip travel across the sphere in the sweep (m)
  double encompassing_motion = 0;  ///< fingertip travel in radius and polar angle in the sweep (m)
  double margin = 0;               ///< |lateral - encompassing| / (lateral + encompassing), 0..1
  bool flexed_probe = false;       ///< the sweep was made with the joints further out flexed
  double q_open = 0;               ///< open pose (rad or m)
  double q_sphere = 0;             ///< pose wrapped on the undeformed sphere: the reference posture
  double q_closed = 0;             ///< the closed end of the range: `lower` or `upper` unless a config says otherwise

  friend bool operator==(const JointTraits&, const JointTraits&) = default;
};

/// A link that is rigidly carried by a joint of the tree, or by the palm.
struct ProfileLink {
  std::string name;
  int joint = -1;                ///< carrying joint; -1 = palm
  RigidTransformd T_joint_link;  ///< link frame in the carrying joint's moved frame (in P for the palm)

  friend bool operator==(const ProfileLink&, const ProfileLink&) = default;
};

/// Lateral look-up table of one lateral joint (paper, section 3.4), on its monotone stretch.
struct LateralTable {
  int joint = -1;                ///< the lateral joint
  double neutral = 0;            ///< joint value at delta theta = 0
  double theta_initial = 0;      ///< canonical azimuth of the fingertip at `neutral`
  std::vector<double> q;         ///< [n] joint values, uniform steps, increasing
  std::vector<double> theta;     ///< [n] canonical fingertip azimuth at q, unwrapped, strictly monotone
  double delta_theta_lower = 0;  ///< <= 0: the lower end of the stretch relative to theta_initial
  double delta_theta_upper = 0;  ///< >= 0
  std::vector<double>
      inverse_q;  ///< [2 m + 1] q at delta theta: m equal steps from `delta_theta_lower` to 0, m from 0 to
                  ///< `delta_theta_upper`; element m is `neutral` bit for bit

  friend bool operator==(const LateralTable&, const LateralTable&) = default;
};

/// One finger, root to tip.
struct ProfileFinger {
  std::string name;
  std::array<bool, kSlotCount> slots{};  ///< the action slots this finger owns; their inputs are averaged
  std::vector<int> joints;               ///< joint indices root to tip, mimic followers included; each carries the next
  int tip_link = -1;                     ///< index into `links`
  Vector3d p_tip_link;                   ///< fingertip point in the tip link's frame (m)
  Vector3d pad_normal_link;              ///< outward normal of the fingertip's pad, unit, tip link's frame
  double tip_distance = 0;               ///< palm centre to fingertip in the open pose: l of this finger (m)
  double theta_initial = 0;  ///< canonical azimuth of the fingertip at q_sphere: where its driving plane stands
  double tip_phi = 0;        ///< polar angle of the fingertip at q_sphere
  int lateral_table = -1;    ///< index into `lateral_tables` of the joint that follows delta theta; -1 = none

  friend bool operator==(const ProfileFinger&, const ProfileFinger&) = default;
};

/// A surface point of the hand and its fixed coordinates on the sphere (paper, section 3.2).
struct Correspondence {
  int link = -1;         ///< index into `links`
  Vector3d p_link;       ///< surface point in the link frame (m)
  Vector3d normal_link;  ///< outward surface normal, unit, link frame
  double theta = 0;      ///< canonical azimuth at q_sphere, (-pi, pi]
  double phi = 0;        ///< polar angle at q_sphere, [0, pi]
  double rho = 0;        ///< rest radius |p| / r at q_sphere
  double weight = 0;     ///< weight in the solver; 0 = not one of the runtime's points

  friend bool operator==(const Correspondence&, const Correspondence&) = default;
};

/// Something the preprocessing inferred.
struct HandFinding {
  std::string item;       ///< for example "palm_link"; also the hand config's key that overrides it
  std::string value;      ///< in words
  std::string reason;     ///< why, in words
  double confidence = 1;  ///< 0..1; 1 when a config said so

  friend bool operator==(const HandFinding&, const HandFinding&) = default;
};

/// SHA-256 of a file the profile was built from.
struct SourceFile {
  std::string name;    ///< path relative to the URDF's folder, or its package:// form; never absolute
  std::string sha256;  ///< 64 lower-case hex digits

  friend bool operator==(const SourceFile&, const SourceFile&) = default;
};

struct HandProfile {
  std::string hand;  ///< the robot's name in the URDF
  Handedness handedness = Handedness::none;
  bool mirrored = false;  ///< canonical azimuth = -azimuth
  std::string palm_link;
  std::string root_link;
  RigidTransformd T_root_palm;    ///< P in the URDF's root, all non-finger joints at zero clipped to limits
  RigidTransformd T_palm_sphere;  ///< S in P
  double radius = 0;              ///< sphere radius r (m)
  double radius_scale = 1;        ///< r = radius_scale * 2 l / pi
  double mean_tip_distance = 0;   ///< l (m)
  Vector3d palm_center_palm;      ///< mean of the finger roots, in P (m)
  double palm_plane_rms = 0;      ///< rms distance of the finger roots from the palm plane (m)

  KinematicTree tree;                     ///< joints of the fingers (and masters they mimic); root frame P
  std::vector<JointTraits> joint_traits;  ///< one for each joint of `tree`
  std::vector<std::string> other_joints;  ///< movable joints of the URDF that no finger has
  std::vector<ProfileLink> links;
  std::vector<ProfileFinger> fingers;  ///< ordered by their first slot
  std::vector<LateralTable> lateral_tables;
  std::vector<Correspondence> correspondences;  ///< sorted by link; the solver's points are those with weight > 0

  std::vector<HandFinding> findings;
  std::vector<std::string> warnings;
  std::string settings_json;  ///< canonical JSON of the build settings; the same settings and model rebuild the profile
  std::vector<SourceFile> sources;

  friend bool operator==(const HandProfile&, const HandProfile&) = default;
};

/// Checks every index, shape, range and finiteness that the runtime relies on; no number may exceed 1e6 in magnitude.
/// Throws Error(invalid_profile) naming `file` and the first field that is wrong, as the file format names it.
UHAS_API void validate_profile(const HandProfile& profile, const std::string& file);

}  // namespace uhas
