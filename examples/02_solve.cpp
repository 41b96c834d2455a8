// 2. Solve one action: a deformation of the sphere becomes joint angles.
//
//   ./02_solve hand.h5
#include <iostream>
#include <vector>

#include "uhas/profile_io/read_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: 02_solve hand.h5\n", 2;
  try {
    const uhas::HandProfile profile = uhas::read_profile(argv[1]);
    uhas::CascadeSolver<double> solver(profile);  // give each thread its copy; copies share the constant model

    std::vector<double> action(15, 0.0);  // zeros: the undeformed sphere
    action[3] = 0.2;                      // turn the plane of the index finger by 0.2 rad
    action[11] = action[12] = -0.3;       // draw the sphere in under it by 0.3 radii

    // from here on nothing allocates, locks or throws: a status says whether the action was usable
    std::vector<double> q(solver.joint_count());
    uhas::SolveReport report;
    if (const uhas::Status status = solver.solve({.values = action}, q, report); status != uhas::Status::ok) {
      std::cerr << "02_solve: error: " << uhas::to_string(status) << '\n';
      return 1;
    }
    std::cout.precision(17);
    for (std::size_t i = 0; i < q.size(); ++i) std::cout << profile.tree.joints[i].name << ' ' << q[i] << '\n';
    std::cerr << "the surface misses the sphere by " << report.residual_rms << " radii\n";
  } catch (const uhas::Error& error) {
    std::cerr << "02_solve: error: " << error.what() << '\n';
    return 1;
  }
}
