// 3. Control a hand: a policy's actions become joint targets that respect the hand's velocity limits.
//
//   ./03_control_loop hand.h5
#include <cmath>
#include <iostream>
#include <vector>

#include "uhas/profile_io/read_profile.hpp"
#include "uhas/runtime/joint_groups.hpp"
#include "uhas/runtime/sphere_controller.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: 03_control_loop hand.h5\n", 2;
  try {
    const uhas::HandProfile profile = uhas::read_profile(argv[1]);
    uhas::SphereControllerOptions options;
    options.velocity_scale = 0.5;  // half of what the URDF allows
    options.range_scale = 0.95;    // off the mechanical stops
    options.time_constant = 0.05;  // s
    uhas::SphereController<double> controller(profile, options);

    // the state is these targets, and yours; on a robot, begin where the joints are
    std::vector<double> targets(controller.joint_count());
    controller.reset(uhas::reference_posture(profile), targets);

    constexpr double dt = 0.01;  // s; the controller reads no clock: tell it how long the period was
    for (int tick = 0; tick < 100; ++tick) {
      std::vector<double> action(15, 0.0);  // your policy: here, the grasp tightens and loosens once
      for (std::size_t i = 5; i < 15; ++i) action[i] = 0.25 * (std::cos(6.28 * tick * dt) - 1);

      const uhas::Status status = controller.update({.values = action}, dt, targets);
      if (status != uhas::Status::ok) std::cerr << uhas::to_string(status) << "; the targets are held\n";

      if (tick % 20 == 0) {  // your robot: send `targets`, in the order of the profile's joints
        std::cout << "t = " << tick * dt << " s:";
        for (double target : targets) std::cout << ' ' << target;
        std::cout << '\n';
      }
    }
  } catch (const uhas::Error& error) {
    std::cerr << "03_control_loop: error: " << error.what() << '\n';
    return 1;
  }
}
