// What an observer keeps of a hand: joints and points ready to be moved.
#pragma once

#include <vector>

#include "uhas/kinematics/compiled_joint.hpp"
#include "uhas/runtime/observation.hpp"

namespace uhas {

/// A profile in one number type and sphere radii, every joint's frame turned so that its axis is z.
template <class Real>
struct ObservationModel {
  struct CarriedVector {
    int joint;
    Vector3<Real> v;  ///< a point (radii) or a direction in the joint's frame
  };

  std::vector<CompiledJoint<Real>> joints;  ///< the base is S; q in rad and m
  std::vector<CarriedVector> points;        ///< [slot][point]
  std::vector<CarriedVector> pads;          ///< [slot], or empty
  Real mirror;                              ///< factor of y of positions, and of x and z of angular velocities
  int size;                                 ///< numbers of an observation
};

template <class Real>
ObservationModel<Real> compile_observation(const HandProfile& profile, const ObservationOptions& options);

extern template ObservationModel<float> compile_observation(const HandProfile&, const ObservationOptions&);
extern template ObservationModel<double> compile_observation(const HandProfile&, const ObservationOptions&);

}  // namespace uhas
