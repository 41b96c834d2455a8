// What a user chooses of the surface points.
#pragma once

namespace uhas {

struct CorrespondenceOptions {
  int samples = 20000;                ///< directions cast from the sphere's centre
  double max_radius_deviation = 0.5;  ///< a hit further than this from the sphere, |rho - 1| in radii, is dropped
  int points_per_link = 32;           ///< at most so many points of a link get a weight
};

}  // namespace uhas
