// The deformation of the whole sphere, interpolated between the driving planes (paper, section 3.3;
// docs/method.md#the-interpolated-field): what drawings of the deformed sphere show.
#pragma once

#include <memory>
#include <span>

#include "uhas/base/errors.hpp"
#include "uhas/base/export.hpp"
#include "uhas/base/spherical.hpp"
#include "uhas/runtime/action.hpp"

namespace uhas {

/// The field of one hand. It has scratch memory of its own: give each thread its object.
class UHAS_API DeformationField {
 public:
  /// Throws Error: invalid_profile for a profile that `validate_profile` refuses, invalid_option for numbers of the
  /// convention out of range.
  explicit DeformationField(const HandProfile& profile, const ActionConvention& convention = {});
  DeformationField(DeformationField&&) noexcept;
  DeformationField& operator=(DeformationField&&) noexcept;
  ~DeformationField();

  /// Moves material points to where `action` takes them: azimuth by delta theta, radius by delta r; the polar angle
  /// stays. On any status but ok the points are untouched. Does not allocate.
  /// @param points  canonical azimuth (any finite angle; the result is not wrapped), polar angle in [0, pi], radius in
  ///                sphere radii: 1 on the sphere, rho of a correspondence. A negative result lies beyond the centre.
  Status deform(const Action<double>& action, std::span<Spherical<double>> points) noexcept;

 private:
  struct UHAS_PRIVATE State;
  std::unique_ptr<State> state_;
};

}  // namespace uhas
