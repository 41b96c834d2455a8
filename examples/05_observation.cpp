// 5. Observe a hand: joint angles and velocities become the numbers that mean the same on every hand.
//
//   ./05_observation hand.h5
#include <iostream>
#include <vector>

#include "uhas/profile_io/read_profile.hpp"
#include "uhas/runtime/joint_groups.hpp"
#include "uhas/runtime/observation.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: 05_observation hand.h5\n", 2;
  try {
    const uhas::HandProfile profile = uhas::read_profile(argv[1]);
    uhas::Observer<double> observer(profile);

    // the reference posture, closing at 1 rad/s
    const std::vector<double> q = uhas::reference_posture(profile);
    std::vector<double> qd(q.size(), 0.0);
    for (int joint : uhas::encompassing_joints(profile)) qd[joint] = 1;

    std::vector<double> observation(observer.size());
    if (const uhas::Status status = observer.observe(q, qd, observation); status != uhas::Status::ok) {
      std::cerr << "05_observation: error: " << uhas::to_string(status) << '\n';
      return 1;
    }

    // [5 slots][2 points][9 numbers]; the second point is the fingertip, its first three numbers its position in radii
    const char* names[] = {"pinky", "ring", "middle", "index", "thumb"};
    for (int slot = 0; slot < uhas::kSlotCount; ++slot) {
      const double* tip = &observation[(2 * slot + 1) * uhas::kPointNumbers];
      std::cout << names[slot] << " tip at " << tip[0] << ' ' << tip[1] << ' ' << tip[2] << ", moving at " << tip[3]
                << ' ' << tip[4] << ' ' << tip[5] << " radii a second\n";
    }
  } catch (const uhas::Error& error) {
    std::cerr << "05_observation: error: " << error.what() << '\n';
    return 1;
  }
}
