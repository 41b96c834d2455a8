#include "uhas/runtime/differentiable_solver.hpp"

#include <algorithm>

#include "uhas/runtime/cascade/single_hand.hpp"
#include "uhas/runtime/lanes/dual.hpp"
#include "uhas/runtime/lanes/hand_walk.hpp"

namespace uhas {
namespace {

void check_differentiable(const SolveOptions& options) {
  if (options.rule != CascadeRule::correspondence)
    throw Error(ErrorCode::invalid_option, "", "rule is contact, which has no derivatives: its joints jump",
                "choose the rule correspondence");
  if (options.field != FieldReading::finger)
    throw Error(ErrorCode::invalid_option, "", "field is field, whose derivatives are not made",
                "choose the reading finger");
}

}  // namespace

/// The solve once more, on numbers that carry derivatives. What an action says to a finger, delta theta and the V
/// displacements, are the inputs of its joints; a finger that shares joints with others takes its turn among them.
template <class Real>
struct DifferentiableSolver<Real>::Scratch {
  using Num = Dual<Real>;
  /// Inputs of one run: all that an action says to a finger, with up to three driving vectors.
  static constexpr int kInputs = Num::kInputs;

  explicit Scratch(const SolverModel<Real>& solver_model)
      : model(&solver_model), hand(solver_model), cascade(solver_model) {}

  /// @param jacobian  [joint][numbers of the action] out
  void differentiate(const ActionNumbers<Real>& action, std::span<Real> jacobian) noexcept {
    std::fill(jacobian.begin(), jacobian.end(), Real(0));
    for (int first = 0; first < 1 + action.vectors; first += kInputs) {
      for (const AffineBundle<Real>& bundle : model->lone_fingers) walk_finger(bundle, action, first, jacobian);
      for (int n : model->other_parts)
        for (int f : model->parts[n].fingers) run_part(model->parts[n], f, action, first, jacobian);
    }
  }

  /// What the action says to a finger; inputs from number `first` on are those of this run.
  void decode(const ActionNumbers<Real>& action, int finger, int first, bool is_input) noexcept {
    PlaneDeformation<Real> plain;
    model->decoder.decode_finger(action, finger, plain);
    const auto number = [&](Real value, int input) {
      return is_input && input >= first && input < first + kInputs ? Num::input(value, input - first) : Num(value);
    };
    PlaneDeformation<Num>& plane = cascade.planes[finger];
    plane.vectors = plain.vectors;
    plane.common_angles = plain.common_angles;
    plane.delta_theta = number(plain.delta_theta, 0);
    for (int j = 0; j < plain.vectors; ++j) {
      plane.phi[j] = plain.phi[j];
      plane.delta_r[j] = number(plain.delta_r[j], 1 + j);
    }
    plane.complete(model->options.convention.held_toward_pole, action.angles == 0);
  }

  void walk_finger(const AffineBundle<Real>& bundle, const ActionNumbers<Real>& action, int first,
                   std::span<Real> jacobian) noexcept {
    const AffineFinger<Real>& finger = bundle.fingers.front();
    decode(action, finger.finger, first, true);
    const PlaneDeformation<Num>& plane = cascade.planes[finger.finger];
    const WalkInput<Num> in = walk_input(*model, finger, plane);
    const auto place = [&](int joint, const Num& q) { add(action, finger.finger, joint, q, first, jacobian); };
    if (action.angles == 0 && plane.lowest >= Num(finger.lowest))
      walk_whole_finger(bundle, in, place);
    else
      walk_faded_finger(*model, bundle, in, cascade, place);
  }

  void run_part(const SolverPart& part, int input_finger, const ActionNumbers<Real>& action, int first,
                std::span<Real> jacobian) noexcept {
    for (int f : part.fingers) decode(action, f, first, f == input_finger);
    cascade.run(*model, part);
    for (const ScopedJoint& s : part.tree)
      add(action, input_finger, s.joint, model->joints[s.joint].in_profile_units(cascade.q(s.joint)), first, jacobian);
  }

  /// The derivatives of `q`, by the numbers of the action that are behind the finger's.
  void add(const ActionNumbers<Real>& action, int finger, int joint, const Num& q, int first,
           std::span<Real> jacobian) const noexcept {
    Real* const row = jacobian.data() + joint * kSlotCount * (1 + action.vectors);
    model->decoder.each_slope(action, finger, [&](int number, int input, Real slope) {
      if (input >= first && input < first + kInputs) row[number] = q.slope(input - first) * slope;
    });
  }

  const SolverModel<Real>* model;
  SingleHand<Real> hand;
  Cascade<Num, VisitInTurn> cascade;
};

template <class Real>
DifferentiableSolver<Real>::DifferentiableSolver(const HandProfile& profile, const SolveOptions& options)
    : model_(compile_solver_model<Real>(profile, options)) {
  check_differentiable(options);
  scratch_ = std::make_unique<Scratch>(*model_);
}

template <class Real>
DifferentiableSolver<Real>::DifferentiableSolver(const DifferentiableSolver& other)
    : model_(other.model_), scratch_(std::make_unique<Scratch>(*other.scratch_)) {}

template <class Real>
DifferentiableSolver<Real>& DifferentiableSolver<Real>::operator=(const DifferentiableSolver& other) {
  return *this = DifferentiableSolver(other);
}

template <class Real>
DifferentiableSolver<Real>::DifferentiableSolver(DifferentiableSolver&&) noexcept = default;
template <class Real>
DifferentiableSolver<Real>& DifferentiableSolver<Real>::operator=(DifferentiableSolver&&) noexcept = default;
template <class Real>
DifferentiableSolver<Real>::~DifferentiableSolver() = default;

template <class Real>
int DifferentiableSolver<Real>::joint_count() const noexcept {
  return static_cast<int>(model_->joints.size());
}

template <class Real>
Status DifferentiableSolver<Real>::solve_with_jacobian(const Action<Real>& action, std::span<Real> q,
                                                       std::span<Real> jacobian) noexcept {
  if (q.size() != model_->joints.size() || jacobian.size() != q.size() * action.values.size())
    return Status::wrong_size;
  if (const Status status = model_->decoder.check(action); status != Status::ok) return status;
  const ActionNumbers<Real> numbers = model_->decoder.numbers_of(action);
  scratch_->hand.solve(numbers, q);
  scratch_->differentiate(numbers, jacobian);
  return Status::ok;
}

template class DifferentiableSolver<float>;
template class DifferentiableSolver<double>;

}  // namespace uhas
