// From a URDF to joint angles in one program, linked against both installed libraries.
#include <iostream>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/profile_builder/build_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

int main(int, char** argv) {
  const uhas::HandProfile profile = uhas::build_profile(argv[1]);
  uhas::CascadeSolver<double> solver(profile);
  std::vector<double> q(solver.joint_count());
  const std::vector<double> action(15, 0.0);
  if (solver.solve({.values = action}, q) != uhas::Status::ok) return 1;
  std::cout << q.size() << " joints\n";

  try {
    uhas::build_profile("no_such_hand.urdf");
  } catch (const uhas::Error& error) {  // what one library throws is the type of the other
    return error.code() == uhas::ErrorCode::file_unreadable ? 0 : 1;
  }
  return 1;
}
