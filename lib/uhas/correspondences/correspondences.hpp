// Correspondences: points of the hand's surface and their fixed coordinates on the sphere (paper, section 3.2;
// docs/method.md#correspondences).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "uhas/correspondences/correspondence_options.hpp"
#include "uhas/sphere_frame/sphere_frame.hpp"

namespace uhas {

/// What became of the rays that hit a link.
struct LinkHits {
  int kept = 0;         ///< correspondences
  int too_far = 0;      ///< hits with |rho - 1| above the bound
  int facing_away = 0;  ///< first hits on a surface that does not face the centre
};

struct Correspondences {
  std::vector<Correspondence> points;  ///< sorted by link, then by sample; `link` indexes Anatomy::links
  std::vector<LinkHits> hits;          ///< one a link of the anatomy
  std::vector<std::string> warnings;
};

/// Casts Fibonacci directions (canonical azimuth) from the centre of S through Embree against the hand posed at
/// `q_sphere`. A ray's first hit is a correspondence when the front of a triangle faces the centre and the hit is near
/// the sphere. The front is the side from which the corners run counter-clockwise; a mesh that is inside out as a whole
/// is turned over. Well-spread points of the links that joints carry get weights; a hand's weights sum to 1. Throws
/// Error(invalid_hand) when the hand has no mesh at all, Error(invalid_config) for a number of samples or points below
/// 1 or a bound that is not positive; a finger link without a point is a warning.
Correspondences project_sphere_samples(const HandModel& model, const Anatomy& anatomy, const SphereFrame& frame,
                                       std::span<const double> q_sphere, const CorrespondenceOptions& options = {});

}  // namespace uhas
