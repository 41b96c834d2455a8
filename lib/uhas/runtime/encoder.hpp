// Encode, the inverse of the cascade: joint angles become the action whose solve comes nearest to them
// (docs/method.md#encode-and-retarget).
//
//   uhas::Encoder<double> encoder(uhas::read_profile("hand.h5"));
//   std::vector<double> action(encoder.action_size());
//   uhas::EncodeReport report;
//   uhas::Status status = encoder.encode(q, action, report);
//
// A finger has three or four joints and V + 1 numbers, so most postures have no action that gives them exactly: the
// report says how far the nearest one found stays away, finger by finger. What a solve gave comes back within 0.01 rad,
// joints at limits or not, for at least 99 of 100 actions anywhere within bounds (V = 2; 98 of other V). Less often by
// the reading `field`, which seeks all fingers at once (93 to 100), and by the closing `hard`, which drops points one by
// one, in steps that no descent sees (84 to 100). Read the report.
//
// Constructing may throw, allocates, and solves some 5,000 actions to start from; encoding does none of these, takes no
// lock and reads no clock.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "uhas/base/export.hpp"
#include "uhas/runtime/cascade_solver.hpp"

namespace uhas {

/// The joint of a finger that stays furthest away, and how far.
struct FingerResidual {
  int joint = -1;       ///< in the profile's order; -1 of a finger that the hand does not have
  double residual = 0;  ///< rad; sphere radii for a sliding joint
};

/// How far solve(action) stays from the posture that was encoded, over the independent joints.
struct EncodeReport {
  double residual_max = 0;                           ///< largest difference (rad; sphere radii for a sliding joint)
  double residual_rms = 0;                           ///< root of the mean square difference (same units)
  std::array<FingerResidual, kSlotCount> fingers{};  ///< [finger] in the profile's order
};

/// Encodes the postures of one hand. Copies share the constant model and have scratch memory of their own: give each
/// thread its copy.
template <class Real>
class UHAS_API Encoder {
 public:
  /// @param options          of the solver whose inverse this is
  /// @param driving_vectors  V, 1 to 4, at their default angles pi j / (V + 1)
  /// Throws Error: as CascadeSolver; invalid_option for V out of range and for an action convention other
  /// than uhas' own.
  explicit Encoder(const HandProfile& profile, const SolveOptions& options = {}, int driving_vectors = 2);
  Encoder(const Encoder& other);
  Encoder& operator=(const Encoder& other);
  Encoder(Encoder&&) noexcept;
  Encoder& operator=(Encoder&&) noexcept;
  ~Encoder();

  int joint_count() const noexcept;  ///< length of q: every joint of the profile, mimic followers included
  int action_size() const noexcept;  ///< 5 + 5 V

  /// @param q       [joint_count()] rad (m for sliding joints), in the profile's joint order. A value beyond the limits
  ///                is encoded as the limit; a continuous joint may be any number of turns away. The elements of mimic
  ///                followers are not read: their masters decide.
  /// @param action  [action_size()] rad and sphere radii, not normalised, within bounds; the slots of a finger hold one
  ///                value
  /// On any status but ok `action` and `report` are untouched.
  Status encode(std::span<const Real> q, std::span<Real> action, EncodeReport& report) noexcept;

  /// The same for N postures, one after the other, on the calling thread: q [N][joint_count()] to actions
  /// [N][action_size()]. Refuses row by row, as `Status` says, the reports too.
  /// @param reports, statuses  [N] or empty
  Status encode_batch(std::span<const Real> q, std::span<Real> actions, std::span<EncodeReport> reports = {},
                      std::span<Status> statuses = {}) noexcept;

 private:
  struct UHAS_PRIVATE Model;
  struct UHAS_PRIVATE Scratch;
  std::shared_ptr<const Model> model_;
  std::unique_ptr<Scratch> scratch_;
};

extern template class Encoder<float>;
extern template class Encoder<double>;

}  // namespace uhas
