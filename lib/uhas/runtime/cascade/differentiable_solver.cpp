#include "uhas/runtime/differentiable_solver.hpp"

#include <algorithm>
#include <vector>

#include "uhas/runtime/cascade/affine_walk.hpp"
#include "uhas/runtime/cascade/cascade_kernel.hpp"
#include "uhas/runtime/lanes/dual.hpp"

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
      : model(&solver_model), bundles(bundle_fingers(solver_model, 1)), cascade(solver_model) {
    std::vector<bool> alone(model->parts.size());
    for (const AffineBundle<Real>& bundle : bundles) alone[bundle.fingers.front().part] = true;
    for (int n = 0; n < static_cast<int>(alone.size()); ++n)
      if (!alone[n]) other_parts.push_back(n);
  }

  /// @param jacobian  [joint][numbers of the action] out
  void differentiate(const ActionNumbers<Real>& action, std::span<Real> jacobian) noexcept {
    std::fill(jacobian.begin(), jacobian.end(), Real(0));
    for (int first = 0; first < 1 + action.vectors; first += kInputs) {
      for (const AffineBundle<Real>& bundle : bundles) walk_finger(bundle, action, first, jacobian);
      for (int n : other_parts)
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
    WalkInput<Num> in;
    in.vectors = plane.vectors;
    in.delta_r = plane.delta_r;
    in.leads = plane.lead;
    in.azimuth = Num(model->azimuth_sign) * plane.delta_theta;
    in.lateral = finger.lateral < 0 ? Num(0) : look_up_lateral(model->laterals[finger.lateral], plane.delta_theta);
    const auto place = [&](int step, const Num& q) {
      if (finger.joints[step] >= 0) add(action, finger.finger, finger.joints[step], q, first, jacobian);
    };
    if (action.angles == 0 && plane.lowest >= Num(finger.lowest)) {
      with_affine_sums<true>(bundle, in, [&](auto sums) {
        walk<true>(
            bundle, in, sums, [](int) { return false; }, [&](int step, const Num& q, bool) { place(step, q); });
      });
      return;
    }
    cascade.carry(*model, model->parts[finger.part]);
    Num open_share;
    const auto carried = [&](int step) {
      return finger.joints[step] < 0 ? PointMoments<Num>{} : cascade.carried(finger.joints[step]);
    };
    walk<true>(
        bundle, in, [&](int step) { return turn_sums(carried(step)); },
        [&](int step) {
          const PointMoments<Num> m = carried(step);
          open_share = share_left(m.weight, m.full_weight, model->options.closing);
          return open_share <= Num(0);
        },
        [&](int step, const Num& q, bool) {
          const bool closes = step != bundle.before && finger.joints[step] >= 0;
          place(step, closes ? close_by_share(model->joints[finger.joints[step]], q, open_share) : q);
        });
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
  std::vector<AffineBundle<Real>> bundles;  // of one finger each
  std::vector<int> other_parts;
  Cascade<Num, VisitInTurn> cascade;
};

template <class Real>
DifferentiableSolver<Real>::DifferentiableSolver(const HandProfile& profile, const SolveOptions& options)
    : solver_(profile, options), model_(compile_solver_model<Real>(profile, options)) {
  check_differentiable(options);
  scratch_ = std::make_unique<Scratch>(*model_);
}

template <class Real>
DifferentiableSolver<Real>::DifferentiableSolver(const DifferentiableSolver& other)
    : solver_(other.solver_), model_(other.model_), scratch_(std::make_unique<Scratch>(*other.scratch_)) {}

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
  return solver_.joint_count();
}

template <class Real>
Status DifferentiableSolver<Real>::solve_with_jacobian(const Action<Real>& action, std::span<Real> q,
                                                       std::span<Real> jacobian) noexcept {
  if (jacobian.size() != q.size() * action.values.size()) return Status::wrong_size;
  const Status status = solver_.solve(action, q);
  if (status == Status::ok) scratch_->differentiate(model_->decoder.numbers_of(action), jacobian);
  return status;
}

template class DifferentiableSolver<float>;
template class DifferentiableSolver<double>;

}  // namespace uhas
