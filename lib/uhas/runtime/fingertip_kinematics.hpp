// Where the fingertips are: forward kinematics of nothing but the fingertip points, for loops that ask often.
//
//   uhas::FingertipKinematics<float> kinematics(uhas::read_profile("hand.h5"));
//   std::vector<float> tips(3 * kinematics.finger_count());
//   uhas::Status status = kinematics.fingertips(q, tips);
//
// Frames of all joints, in double: uhas/kinematics/forward_kinematics.hpp. Constructing may throw and allocates; the
// rest does neither, takes no lock, reads no clock and keeps no state: one object serves any number of threads.
#pragma once

#include <memory>
#include <span>

#include "uhas/base/errors.hpp"
#include "uhas/base/export.hpp"
#include "uhas/profile/hand_profile.hpp"
#include "uhas/runtime/instruction_set.hpp"

namespace uhas {

/// Forward kinematics of one hand's fingertips. Copies share the constant model.
template <class Real>
class UHAS_API FingertipKinematics {
 public:
  /// Throws Error(invalid_profile) for a profile that `validate_profile` refuses.
  /// @param set  what batches use; when it is not available, the widest that is
  explicit FingertipKinematics(const HandProfile& profile, InstructionSet set = widest_instruction_set());

  int joint_count() const noexcept;  ///< length of q: every joint of the profile, mimic followers included
  int finger_count() const noexcept;

  /// @param q           [joint_count()] rad, m for prismatic joints, in the profile's joint order. The elements of
  ///                    mimic followers are not read: their masters decide. Values beyond limits are taken as they are.
  /// @param fingertips  [finger_count()][3] caller-owned: x y z (m) in the palm frame, fingers as in the profile;
  ///                    untouched on any status but ok
  Status fingertips(std::span<const Real> q, std::span<Real> fingertips) const noexcept;

  /// The same for N hands of this kind, on the calling thread: q [N][joint_count()] to fingertips
  /// [N][finger_count()][3]. Refuses row by row, as `Status` says; `statuses`: [N] or empty. A row's result does not
  /// depend on the others; it is that of a single call to within rounding.
  Status fingertips_batch(std::span<const Real> q, std::span<Real> fingertips,
                          std::span<Status> statuses = {}) const noexcept;

 private:
  struct UHAS_PRIVATE Model;
  std::shared_ptr<const Model> model_;
};

extern template class FingertipKinematics<float>;
extern template class FingertipKinematics<double>;

}  // namespace uhas
