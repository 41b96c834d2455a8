// 6. Retarget: the posture of one hand on another, by way of the action that both understand.
//
//   ./06_retarget from.h5 to.h5
#include <iostream>
#include <vector>

#include "uhas/profile_io/read_profile.hpp"
#include "uhas/runtime/retarget.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "usage: 06_retarget from.h5 to.h5\n", 2;
  try {
    const uhas::HandProfile from = uhas::read_profile(argv[1]), to = uhas::read_profile(argv[2]);
    uhas::Retargeter<double> retargeter(from, to);

    // halfway between the open and the closed hand
    std::vector<double> q_from;
    for (const uhas::JointTraits& joint : from.joint_traits) q_from.push_back((joint.q_open + joint.q_closed) / 2);

    std::vector<double> q_to(retargeter.joint_count_to());
    uhas::EncodeReport report;
    if (const uhas::Status status = retargeter.retarget(q_from, q_to, report); status != uhas::Status::ok) {
      std::cerr << "06_retarget: error: " << uhas::to_string(status) << '\n';
      return 1;
    }
    for (std::size_t i = 0; i < q_to.size(); ++i) std::cout << to.tree.joints[i].name << ' ' << q_to[i] << '\n';

    // 15 numbers cannot say every posture: this much was lost before the second hand saw it
    std::cout << "the nearest action is " << report.residual_max << " rad off at its worst joint\n";
  } catch (const uhas::Error& error) {
    std::cerr << "06_retarget: error: " << error.what() << '\n';
    return 1;
  }
}
