// The driving planes of the interpolated field: the fingers by azimuth, those that stand closer than 5 degrees as
// one (docs/method.md#the-interpolated-field).
#pragma once

#include <vector>

#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/cascade/plane_deformation.hpp"

namespace uhas {

struct PlaneGroups {
  std::vector<std::vector<int>> fingers;  ///< [group] of a plane, by azimuth
  std::vector<double> azimuths;           ///< [group] their mean on the circle, canonical
  std::vector<int> of_finger;             ///< [finger] the group it is in
};

/// `profile`: one that `validate_profile` lets pass.
PlaneGroups group_planes(const HandProfile& profile);

/// A place between the groups on either side of it.
struct BetweenPlanes {
  int before, after;  ///< indices into `PlaneGroups`; the same where there is one group only
  double blend;       ///< 0 at `before`, 1 at `after`
};

/// @param theta  canonical azimuth, any finite angle
BetweenPlanes locate_between_planes(double theta, const std::vector<double>& azimuths);

/// The mean deformation of a group's fingers. `planes`: [finger].
template <class Num>
PlaneDeformation<Num> mean_plane(const std::vector<PlaneDeformation<Num>>& planes, const std::vector<int>& group,
                                 bool held_toward_pole) {
  PlaneDeformation<Num> mean;
  mean.vectors = planes.front().vectors;
  mean.delta_theta = Num(0);
  for (int j = 0; j < mean.vectors; ++j) mean.phi[j] = mean.delta_r[j] = Num(0);
  // angles and displacements, each the mean of its own; all else follows from them
  const Num share(LaneReal<Num>(1) / LaneReal<Num>(group.size()));
  for (int finger : group) {
    mean.delta_theta += share * planes[finger].delta_theta;
    for (int j = 0; j < mean.vectors; ++j) {
      mean.phi[j] += share * planes[finger].phi[j];
      mean.delta_r[j] += share * planes[finger].delta_r[j];
    }
  }
  mean.complete(held_toward_pole, false);
  return mean;
}

/// What a deformation does to a material point.
template <class Num>
struct Displacement {
  Num delta_theta;  ///< rad, canonical
  typename RadialProfile<Num>::At radial;
};

/// Of the material point at polar angle `phi`, `blend` of the way from one plane to the next.
template <class Num>
Displacement<Num> displacement_between(const PlaneDeformation<Num>& before, const PlaneDeformation<Num>& after,
                                       Num blend, Num phi) {
  // both planes are read at the point's angle, and past the first driving vector of what lies between them
  const auto mixed = [&](Num a, Num b) { return a + blend * (b - a); };
  const Num past_first = max(phi, mixed(before.phi[0], after.phi[0]));
  return {mixed(before.delta_theta, after.delta_theta),
          {mixed(before.at(phi).delta_r, after.at(phi).delta_r),
           mixed(before.at(past_first).delta_r, after.at(past_first).delta_r)}};
}

}  // namespace uhas
