/* uhas.h as a C99 program sees it: every declaration compiles, every initialiser is one, and a solve runs. */
#include "uhas/c/uhas.h"

int solve_from_c(const uhas_profile* profile, double* q, size_t joints);

/* Returns the first status or error that is not UHAS_OK. */
int solve_from_c(const uhas_profile* profile, double* q, size_t joints) {
  const double action[15] = {0.1, 0.1, 0.1, 0.1, 0, -0.2, -0.2, -0.2, -0.2, -0.2, -0.2, -0.2, -0.2, 0.1, 0.1};
  const double angles[2] = {1.0, 2.0};
  uhas_solve_options solve_options = UHAS_SOLVE_OPTIONS_INIT;
  uhas_controller_options controller_options = UHAS_CONTROLLER_OPTIONS_INIT;
  uhas_observation_options observation_options = UHAS_OBSERVATION_OPTIONS_INIT;
  uhas_action_options action_options = UHAS_ACTION_OPTIONS_INIT;
  uhas_solve_report report = UHAS_SOLVE_REPORT_INIT;
  uhas_solver* solver = NULL;
  uhas_controller* controller = NULL;
  uhas_observer* observer = NULL;
  double residual = 0;
  int result;

  solve_options.passes = 2;
  controller_options.solve = &solve_options;
  observation_options.points = 1u;
  action_options.driving_vectors_phi = angles;
  action_options.driving_vectors_size = 2;
  report.residual_rms = &residual;

  result = uhas_controller_create(profile, &controller_options, &controller, NULL, 0);
  if (result == UHAS_OK) result = uhas_observer_create(profile, &observation_options, &observer, NULL, 0);
  if (result == UHAS_OK) result = uhas_solver_create(profile, &solve_options, &solver, NULL, 0);
  if (result == UHAS_OK) result = uhas_solver_solve(solver, action, 15, &action_options, q, joints, &report, NULL);
  if (result == UHAS_OK && !(residual > 0)) result = -1;
  uhas_controller_free(controller);
  uhas_observer_free(observer);
  uhas_solver_free(solver);
  return result;
}
