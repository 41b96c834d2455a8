// Smoothness of a hand: how far a joint goes for a small step of the action, and whether it jumps.
#pragma once

#include <cstdint>
#include <vector>

#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

struct SmoothnessOptions {
  int lines = 400;     ///< random lines, besides those along the axes
  double step = 0.01;  ///< between neighbouring actions of a line: the largest change of an input (radii, or rad)
  std::uint64_t seed = 1;
  int threads = 1;
  SolveOptions solve{};
};

/// The steepest place of one joint along lines of the action space.
struct JointStep {
  int joint = -1;   ///< index into the profile's joints
  double rate = 0;  ///< rad a unit of the input (rad a radius, rad a rad), over one step of a line; sliding joints:
                    ///< radii in place of rad
  double finest_rate = 0;      ///< the greatest rate found there as the step is halved, down to 1/65536
  double jump = 0;             ///< rad left at the end of the halving where that is a jump, 0 where it is a slope
  std::vector<double> action;  ///< [15] where the steepest part begins
  std::vector<double> change;  ///< [15] direction of the line; the largest element has magnitude 1
};

struct SmoothnessScore {
  std::vector<JointStep> radial;   ///< [joint that a radial input moves] in tree order, along changes of radial inputs
  std::vector<JointStep> azimuth;  ///< [joint that an azimuth moves] along changes of one azimuth
};

/// The slots of a finger always agree. Lines of radial inputs run over their bounds: each alone, those of a finger
/// together, with the azimuths at zero and at their bounds; and between two random settings of all inputs, azimuths
/// kept. Lines of azimuths run over the bounds of one finger, the radial inputs at zero and random. Random inputs are
/// uniform between their bounds.
SmoothnessScore measure_smoothness(const HandProfile& profile, const SmoothnessOptions& options);

}  // namespace uhas
