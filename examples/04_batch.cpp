// 4. Solve many at once: a hand a SIMD lane, on several threads, for a mixed set of hands.
//
//   ./04_batch hand.h5 [another.h5 ...]
#include <algorithm>
#include <iostream>
#include <vector>

#include "uhas/profile_io/read_profile.hpp"
#include "uhas/runtime/batch_solver.hpp"

int main(int argc, char** argv) {
  if (argc < 2) return std::cerr << "usage: 04_batch hand.h5 [another.h5 ...]\n", 2;
  try {
    std::vector<uhas::HandProfile> profiles;
    for (int i = 1; i < argc; ++i) profiles.push_back(uhas::read_profile(argv[i]));
    uhas::BatchSolver<float> solver(profiles, {}, {.threads = 2});

    // rows of 15 numbers, in float as policies have them; row n is for hand n modulo the number of hands
    constexpr std::size_t count = 4096;
    std::vector<float> actions(15 * count);
    std::vector<int> hands(count);
    for (std::size_t n = 0; n < count; ++n) {
      std::fill_n(&actions[15 * n + 5], 10, -0.8f * float(n) / count);  // from wrapped to nearly closed
      hands[n] = static_cast<int>(n % profiles.size());
    }

    // rows of joint angles, as long as the hand with most joints needs; the rest of a row is left alone
    const std::size_t row = solver.widest_joint_count();
    std::vector<float> q(row * count);
    const uhas::Status status = solver.solve({.count = count, .values = actions, .hands = hands}, q);
    if (status != uhas::Status::ok) {  // of the first row that was refused; the others are solved all the same
      std::cerr << "04_batch: error: " << uhas::to_string(status) << '\n';
      return 1;
    }

    std::cout << count << " hands solved, " << solver.lanes() << " at a time on each thread\n";
    for (std::size_t n : {std::size_t(0), count - 1}) {
      const uhas::HandProfile& profile = profiles[hands[n]];
      std::cout << profile.hand << " of row " << n << ':';
      for (std::size_t i = 0; i < profile.tree.joints.size(); ++i) std::cout << ' ' << q[row * n + i];
      std::cout << '\n';
    }
  } catch (const uhas::Error& error) {
    std::cerr << "04_batch: error: " << error.what() << '\n';
    return 1;
  }
}
