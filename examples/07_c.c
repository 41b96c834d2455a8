/* 7. The same from C: load, solve, release. Every other language can call this way; 08_policy_loop.py does.
 *
 *   ./07_c hand.h5
 */
#include <stdio.h>
#include <stdlib.h>

#include "uhas/c/uhas.h"

int main(int argc, char** argv) {
  char message[256];
  uhas_profile* profile;
  uhas_solver* solver;
  double action[15] = {0};
  double* q;
  size_t joint, joints;
  int status;

  if (argc != 2) {
    fprintf(stderr, "usage: 07_c hand.h5\n");
    return 2;
  }
  if (uhas_profile_load(argv[1], &profile, message, sizeof message) != UHAS_OK ||
      uhas_solver_create(profile, NULL, &solver, message, sizeof message) != UHAS_OK) {
    fprintf(stderr, "07_c: error: %s\n", message);
    return 1;
  }

  joints = uhas_profile_joint_count(profile);
  q = malloc(joints * sizeof *q);
  action[3] = 0.2;                /* turn the plane of the index finger by 0.2 rad */
  action[11] = action[12] = -0.3; /* draw the sphere in under it by 0.3 radii */

  status = uhas_solver_solve(solver, action, 15, NULL, q, joints, NULL, NULL);
  if (status == UHAS_OK)
    for (joint = 0; joint < joints; ++joint) printf("%s %.17g\n", uhas_profile_joint_name(profile, joint), q[joint]);
  else
    fprintf(stderr, "07_c: error: %s\n", uhas_status_text(status));

  free(q);
  uhas_solver_free(solver);
  uhas_profile_free(profile);
  return status == UHAS_OK ? 0 : 1;
}
