// uhas.h: solving and the sphere controller.
#include "uhas/c/call.hpp"
#include "uhas/runtime/action.hpp"
#include "uhas/runtime/sphere_controller.hpp"

using namespace uhas;

struct uhas_solver : c::Both<CascadeSolver> {
  uhas_solver(const HandProfile& profile, const c::SolveSettings& solve)
      : Both(profile, solve.options),
        driving_vectors(solve.driving_vectors),
        bounds(action_bounds(profile, solve.driving_vectors, solve.options.convention)) {}

  int driving_vectors;
  ActionBounds bounds;
};

namespace {

struct ControllerSettings {
  SphereControllerOptions options;
  int driving_vectors;
};

ControllerSettings controller_settings(const uhas_controller_options* given) {
  const uhas_controller_options options = c::read_options(given, UHAS_CONTROLLER_OPTIONS_INIT);
  const c::SolveSettings solve = c::solve_settings(options.solve);
  return {{.velocity_scale = options.velocity_scale,
           .range_scale = options.range_scale,
           .time_constant = options.time_constant,
           .solve = solve.options},
          solve.driving_vectors};
}

}  // namespace

struct uhas_controller : c::Both<SphereController> {
  uhas_controller(const HandProfile& profile, const ControllerSettings& settings)
      : Both(profile, settings.options), driving_vectors(settings.driving_vectors) {}

  int driving_vectors;
};

namespace {

template <class Real>
int solve(uhas_solver* handle, const Real* values, std::size_t actions_size, const uhas_action_options* options,
          Real* q, std::size_t q_size, const uhas_solve_report* given, int* statuses) noexcept {
  if (handle == nullptr || q == nullptr || (given != nullptr && !c::is_known(*given))) return UHAS_WRONG_SIZE;
  CascadeSolver<Real>& solver = handle->in<Real>();
  const std::size_t joints = solver.joint_count();
  const std::ptrdiff_t hands = c::rows_of(q_size, joints);
  if (hands < 0) return UHAS_WRONG_SIZE;
  const c::Actions<Real> actions(values, actions_size, handle->driving_vectors, options, hands);
  if (!actions.fits()) return UHAS_WRONG_SIZE;

  uhas_solve_report out = UHAS_SOLVE_REPORT_INIT;
  c::overwrite(out, given);
  const bool reports =
      out.residual_rms != nullptr || out.at_limit != nullptr || out.closed != nullptr || out.clamped != nullptr;
  return static_cast<int>(each_row(hands, c::statuses_of(statuses, hands), [&](std::size_t n) {
    const std::span<Real> q_out(q + n * joints, joints);
    if (!reports) return solver.solve(actions[n], q_out);
    SolveReport report;
    if (out.at_limit != nullptr) report.at_limit = {out.at_limit + n * joints, joints};
    if (out.closed != nullptr) report.closed = {out.closed + n * joints, joints};
    const Status status = solver.solve(actions[n], q_out, report);
    if (status == Status::ok && out.residual_rms != nullptr) out.residual_rms[n] = report.residual_rms;
    if (status == Status::ok && out.clamped != nullptr) out.clamped[n] = report.clamped;
    return status;
  }));
}

template <class Real>
int reset(uhas_controller* handle, const Real* q, std::size_t q_size, Real* targets, std::size_t targets_size,
          int* statuses) noexcept {
  if (handle == nullptr || q == nullptr || targets == nullptr || q_size != targets_size) return UHAS_WRONG_SIZE;
  const SphereController<Real>& controller = handle->in<Real>();
  const std::size_t joints = controller.joint_count();
  const std::ptrdiff_t hands = c::rows_of(q_size, joints);
  if (hands < 0) return UHAS_WRONG_SIZE;
  return static_cast<int>(each_row(hands, c::statuses_of(statuses, hands), [&](std::size_t n) {
    return controller.reset(std::span(q + n * joints, joints), std::span(targets + n * joints, joints));
  }));
}

template <class Real>
int update(uhas_controller* handle, const Real* values, std::size_t actions_size, const uhas_action_options* options,
           Real dt, Real* targets, std::size_t targets_size, int* statuses) noexcept {
  if (handle == nullptr || targets == nullptr) return UHAS_WRONG_SIZE;
  SphereController<Real>& controller = handle->in<Real>();
  const std::size_t joints = controller.joint_count();
  const std::ptrdiff_t hands = c::rows_of(targets_size, joints);
  if (hands < 0) return UHAS_WRONG_SIZE;
  const c::Actions<Real> actions(values, actions_size, handle->driving_vectors, options, hands);
  if (!actions.fits()) return UHAS_WRONG_SIZE;
  return static_cast<int>(each_row(hands, c::statuses_of(statuses, hands), [&](std::size_t n) {
    return controller.update(actions[n], dt, std::span(targets + n * joints, joints));
  }));
}

template <class Real>
int approach(uhas_controller* handle, const Real* solutions, std::size_t solutions_size, Real dt, Real* targets,
             std::size_t targets_size, int* statuses) noexcept {
  if (handle == nullptr || solutions == nullptr || targets == nullptr || solutions_size != targets_size)
    return UHAS_WRONG_SIZE;
  const SphereController<Real>& controller = handle->in<Real>();
  const std::size_t joints = controller.joint_count();
  const std::ptrdiff_t hands = c::rows_of(targets_size, joints);
  if (hands < 0) return UHAS_WRONG_SIZE;
  return static_cast<int>(each_row(hands, c::statuses_of(statuses, hands), [&](std::size_t n) {
    return controller.approach(std::span(solutions + n * joints, joints), dt, std::span(targets + n * joints, joints));
  }));
}

}  // namespace

int uhas_solver_create(const uhas_profile* profile, const uhas_solve_options* options, uhas_solver** solver,
                       char* message, size_t message_size) {
  return c::create(solver, {message, message_size},
                   [&] { return new uhas_solver(c::profile_of(profile), c::solve_settings(options)); });
}

void uhas_solver_free(uhas_solver* solver) { delete solver; }

int uhas_solver_action_bounds(const uhas_solver* solver, double* lower, double* upper, size_t size) {
  if (solver == nullptr || lower == nullptr || upper == nullptr || size != solver->bounds.lower.size())
    return UHAS_WRONG_SIZE;
  std::copy_n(solver->bounds.lower.begin(), size, lower);
  std::copy_n(solver->bounds.upper.begin(), size, upper);
  return UHAS_OK;
}

int uhas_solver_solve(uhas_solver* solver, const double* actions, size_t actions_size,
                      const uhas_action_options* options, double* q, size_t q_size, const uhas_solve_report* report,
                      int* statuses) {
  return solve(solver, actions, actions_size, options, q, q_size, report, statuses);
}

int uhas_solver_solve_f(uhas_solver* solver, const float* actions, size_t actions_size,
                        const uhas_action_options* options, float* q, size_t q_size, const uhas_solve_report* report,
                        int* statuses) {
  return solve(solver, actions, actions_size, options, q, q_size, report, statuses);
}

int uhas_controller_create(const uhas_profile* profile, const uhas_controller_options* options,
                           uhas_controller** controller, char* message, size_t message_size) {
  return c::create(controller, {message, message_size},
                   [&] { return new uhas_controller(c::profile_of(profile), controller_settings(options)); });
}

void uhas_controller_free(uhas_controller* controller) { delete controller; }

int uhas_controller_reset(uhas_controller* controller, const double* q, size_t q_size, double* targets,
                          size_t targets_size, int* statuses) {
  return reset(controller, q, q_size, targets, targets_size, statuses);
}

int uhas_controller_reset_f(uhas_controller* controller, const float* q, size_t q_size, float* targets,
                            size_t targets_size, int* statuses) {
  return reset(controller, q, q_size, targets, targets_size, statuses);
}

int uhas_controller_update(uhas_controller* controller, const double* actions, size_t actions_size,
                           const uhas_action_options* options, double dt, double* targets, size_t targets_size,
                           int* statuses) {
  return update(controller, actions, actions_size, options, dt, targets, targets_size, statuses);
}

int uhas_controller_update_f(uhas_controller* controller, const float* actions, size_t actions_size,
                             const uhas_action_options* options, float dt, float* targets, size_t targets_size,
                             int* statuses) {
  return update(controller, actions, actions_size, options, dt, targets, targets_size, statuses);
}

int uhas_controller_approach(uhas_controller* controller, const double* solutions, size_t solutions_size, double dt,
                             double* targets, size_t targets_size, int* statuses) {
  return approach(controller, solutions, solutions_size, dt, targets, targets_size, statuses);
}

int uhas_controller_approach_f(uhas_controller* controller, const float* solutions, size_t solutions_size, float dt,
                               float* targets, size_t targets_size, int* statuses) {
  return approach(controller, solutions, solutions_size, dt, targets, targets_size, statuses);
}
