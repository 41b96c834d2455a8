// 1. Load a hand profile and see what it knows of the hand.
//
//   ./01_load hand.h5
#include <iostream>

#include "uhas/profile_io/read_profile.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: 01_load hand.h5\n", 2;
  try {
    const uhas::HandProfile profile = uhas::read_profile(argv[1]);  // the one call that may fail: it reads a file
    std::cout << profile.hand << ": a sphere of radius " << profile.radius << " m, fixed to " << profile.palm_link
              << '\n';

    // every array of joint values, anywhere, has this order
    for (const uhas::Joint& joint : profile.tree.joints)
      std::cout << "  joint " << joint.name << " from " << joint.lower << " to " << joint.upper << '\n';

    // an action has five slots: pinky, ring, middle, index, thumb; a hand with fewer fingers has fingers with several
    for (const uhas::ProfileFinger& finger : profile.fingers) {
      std::cout << "  finger " << finger.name << " follows slots";
      for (int slot = 0; slot < uhas::kSlotCount; ++slot)
        if (finger.slots[slot]) std::cout << ' ' << slot;
      std::cout << '\n';
    }
  } catch (const uhas::Error& error) {  // names the file, what is wrong and what to do
    std::cerr << "01_load: error: " << error.what() << '\n';
    return 1;
  }
}
