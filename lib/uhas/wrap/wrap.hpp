// Wrapping the hand on the undeformed sphere: q_sphere (docs/method.md#wrap).
#pragma once

#include <span>
#include <vector>

#include "uhas/classification/joint_classes.hpp"
#include "uhas/kinematics/cascade_plan.hpp"

namespace uhas {

/// Wraps the fingers of one hand on the unit sphere, as often as asked: each encompassing joint, root to tip, turns
/// from open toward closed until its node lies on the sphere. Lateral joints keep the value they have in `q`; the
/// others are overwritten, mimic followers included. Refers to what it is made of. `q`: one value a joint of the tree,
/// in and out.
class SphereWrapper {
 public:
  SphereWrapper(const Anatomy& anatomy, const SphereFrame& frame, std::span<const JointClassification> classes,
                std::span<const double> q_closed);
  SphereWrapper(const SphereWrapper&) = delete;
  SphereWrapper& operator=(const SphereWrapper&) = delete;

  void wrap(std::span<double> q);

  /// Nothing but what the fingertip of `finger` depends on; encompassing joints elsewhere are left open. The finger's
  /// joints get the same values as from `wrap`, bit for bit.
  void wrap_finger(int finger, std::span<double> q);

 private:
  /// Steps of the cascade and the joints whose frames they look at.
  struct Scope {
    std::vector<const CascadeStep*> steps;
    std::vector<int> joints;  // increasing; each with its parents
  };

  Scope scope_of(std::span<const int> fingers) const;
  void wrap(const Scope& scope, std::span<double> q);
  double wrapped_value(const Scope& scope, const CascadeStep& step, std::span<double> q);
  void place(const Scope& scope, std::span<const double> q);
  Vector3d point(const ContactNode& node) const;

  const Anatomy& anatomy_;
  const SphereFrame& frame_;
  std::span<const double> q_closed_;
  std::vector<int> encompassing_;
  std::vector<CascadeStep> steps_;
  Scope whole_hand_;
  std::vector<Scope> of_finger_;  // [finger]
  RigidTransformd T_sphere_palm_;
  std::vector<RigidTransformd> T_palm_joint_;  // [joint] of the joints of the scope at work
};

/// `SphereWrapper::wrap`, once.
void wrap_on_sphere(const Anatomy& anatomy, const SphereFrame& frame, std::span<const JointClassification> classes,
                    std::span<const double> q_closed, std::span<double> q);

}  // namespace uhas
