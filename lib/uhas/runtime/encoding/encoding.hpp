// The working half of an encoder: the state of one encoding and the steps of its descents.
#pragma once

#include <span>
#include <vector>

#include "uhas/runtime/encoder.hpp"
#include "uhas/runtime/encoding/encoder_model.hpp"

namespace uhas {

/// Levenberg's method with the solver itself, on one group of fingers beside the other: they do not touch each other, so
/// that one solve of the hand takes each group a step on its own way. Everything is sized once; running it allocates
/// nothing.
class Encoding {
 public:
  Encoding(const EncoderModel& model, const CascadeSolver<double>& solver);

  /// Finds the action for `q` [joint].
  template <class Real>
  void run(const EncoderModel& model, std::span<const Real> q) noexcept;

  /// The action found. `action`: [5 + 5 V].
  template <class Real>
  void write_action(const EncoderModel& model, std::span<Real> action) const noexcept {
    model.write_action(best_.actions, action);
  }

  /// How far its solve stays from the posture that was asked for.
  EncodeReport report(const EncoderModel& model) const noexcept;

 private:
  /// An action and what the solver makes of it.
  struct Attempt {
    std::vector<FingerAction> actions;  // [finger]
    std::vector<double> q;              // [joint]
    std::vector<double> cost;           // [group] sum of squared errors
  };

  /// What the next solve is to a group.
  enum class Next { look, difference, step, nothing };

  /// Where a group is on its way.
  struct Descent {
    Next next;
    int start;     // number of the sample that it has come from
    bool is_far;   // from every sample
    bool is_last;  // from the best that was found
    int steps_left;
    int unknowns;  // that it moves
    int unknown;   // whose derivatives the next solve tells
    double damping;
  };

  static constexpr int kStarts = 12;

  void set_target(const EncoderModel& model) noexcept;
  void begin_at_sample(const EncoderModel& model, std::size_t g) noexcept;
  void begin_at_best(const EncoderModel& model, std::size_t g) noexcept;
  static void begin(Descent& descent, int steps, int unknowns) noexcept;
  void proceed(const EncoderModel& model, std::size_t g) noexcept;
  void end(const EncoderModel& model, std::size_t g) noexcept;
  void difference(const EncoderModel& model, std::size_t g) noexcept;
  void update_derivatives(const EncoderModel& model, std::size_t g) noexcept;
  void step(const EncoderModel& model, std::size_t g) noexcept;
  void solve(const EncoderModel& model) noexcept;
  double error(const EncoderModel& model, const Attempt& attempt, int joint) const noexcept;
  static void copy_group(const FingerGroup& group, std::size_t index, const Attempt& from, Attempt& to) noexcept;

  CascadeSolver<double> solver_;
  std::vector<double> asked_;                              // [joint] the posture to encode, as it was given
  std::vector<double> target_;                             // [joint] what a solve can give of it
  std::vector<std::array<FingerAction, kStarts>> starts_;  // [finger]
  std::vector<float> distances_;                           // [sample]
  std::vector<double> values_;                             // [5 + 5 V] the action being solved
  Attempt best_, now_, trial_;                             // of all descents; of this one; of the next solve
  std::vector<Descent> descents_;                          // [group]
  std::vector<std::vector<double>> derivatives_;           // [unknown of a group][joint] radii or rad a unit
};

}  // namespace uhas
