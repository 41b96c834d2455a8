// The working half of an encoder: the state of one encoding and the steps of its descent.
#pragma once

#include <span>
#include <vector>

#include "uhas/runtime/encoder.hpp"
#include "uhas/runtime/encoding/encoder_model.hpp"

namespace uhas {

/// Levenberg's method with the solver itself, a group of fingers at a time but all groups in step: they do
/// not touch each other, so that one solve of the hand serves every group. Everything is sized once; running
/// it allocates nothing.
template <class Real>
class Encoding {
 public:
  /// @param relaxed_solver  solves the hand `with_wider_limits`
  Encoding(const EncoderModel& model, const CascadeSolver<Real>& solver, const CascadeSolver<Real>& relaxed_solver);

  /// Finds the action for `q` [joint].
  void run(const EncoderModel& model, std::span<const Real> q) noexcept;

  /// The action found. `action`: [5 + 5 V].
  void write_action(const EncoderModel& model, std::span<Real> action) const noexcept {
    model.write_action(best_.actions, action);
  }

  /// How far its solve stays from the posture that was asked for.
  EncodeReport report(const EncoderModel& model) const noexcept;

 private:
  /// An action and what a solver makes of it.
  struct Attempt {
    std::vector<FingerAction> actions;  // [finger]
    std::vector<Real> q;                // [joint]
    std::vector<double> cost;           // [group] sum of squared errors
  };
  enum class Freedom { displacements, all };  // which unknowns a descent moves

  void set_target(const EncoderModel& model, std::span<const Real> q) noexcept;
  void begin(const EncoderModel& model, double odd_shift, double even_shift) noexcept;
  void descend(const EncoderModel& model, CascadeSolver<Real>& solver, Freedom freedom, int steps) noexcept;
  void solve(const EncoderModel& model, CascadeSolver<Real>& solver, Attempt& attempt) noexcept;
  void differentiate(const EncoderModel& model, CascadeSolver<Real>& solver, Freedom freedom) noexcept;
  void step(const EncoderModel& model, Freedom freedom) noexcept;
  void keep_better(const EncoderModel& model) noexcept;
  bool has_ended() const noexcept;
  void copy_group(const FingerGroup& group, std::size_t index, const Attempt& from, Attempt& to) const noexcept;
  double error(const EncoderModel& model, const Attempt& attempt, int joint) const noexcept;

  static int unknown_count(const FingerGroup& group, Freedom freedom) noexcept;
  static bool is_settled(double cost) noexcept;

  CascadeSolver<Real> solver_, relaxed_solver_;
  std::vector<double> asked_;                  // [joint] the posture to encode; continuous joints within their range
  std::vector<double> target_;                 // [joint] the same within limits, followers where their masters put them
  std::vector<FingerAction> start_;            // [finger] the linear start
  std::vector<RigidTransformd> T_palm_joint_;  // [joint]
  std::vector<Real> values_;                   // [5 + 5 V] the action being solved
  Attempt best_, now_, trial_;                 // of all starts; of this descent; of this step
  std::vector<double> damping_;                // [group]
  std::vector<std::vector<double>> derivatives_;  // [unknown of a group][joint] radii or rad a unit
};

extern template class Encoding<float>;
extern template class Encoding<double>;

}  // namespace uhas
