// The sphere frame S and its radius (paper, section 3.1; docs/method.md#the-sphere).
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "uhas/anatomy/anatomy.hpp"
#include "uhas/sphere_frame/sphere_frame_options.hpp"

namespace uhas {

struct SphereFrame {
  RigidTransformd T_palm_sphere;  ///< S in P; lengths stay metres
  double radius = 0;              ///< r (m)
  double radius_scale = 1;
  double mean_tip_distance = 0;  ///< l (m)
  Vector3d palm_center_palm;     ///< mean of the finger roots, in P (m)
  double palm_plane_rms = 0;     ///< rms distance of the finger roots from the plane through the palm centre (m)
  bool mirrored = false;         ///< a left hand: canonical azimuth = -azimuth

  /// One element a finger of the anatomy:
  std::vector<double> tip_distance;                 ///< palm centre to fingertip at the open pose (m)
  std::vector<double> open_azimuth;                 ///< canonical azimuth of the open fingertip
  std::vector<std::array<bool, kSlotCount>> slots;  ///< the action slots it owns
  std::vector<int> own_slot;                        ///< the one of these that no finger shares but on request
  std::vector<std::string> names;  ///< pinky ... thumb on hands of 4 and 5 fingers with a thumb, else finger1 ...

  std::vector<std::string> warnings;
};

/// Throws Error(invalid_hand) for more than five fingers, fewer than two, or a hand without extent.
SphereFrame compute_sphere_frame(const Anatomy& anatomy, const SphereFrameOptions& options = {});

/// Fingertip of `finger` in S (m), for joint values `q` of the whole tree.
Vector3d fingertip_in_sphere(const Anatomy& anatomy, const SphereFrame& frame, int finger, std::span<const double> q);

}  // namespace uhas
