// A finger's sideways range does not change when a joint's limit is opened beyond use: on every hand.
#include "opened_limits.hpp"

#include <iostream>

#include "support/real_profile.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("sideways ranges do not depend on limits that the wrap does not reach") {
  const int opened = check_opened_limits(real_stages(), LateralTableOptions{}.steps, real_hand().name);
  std::cout << real_hand().name << ": " << opened << " joints opened\n";
  CHECK(opened > 0);
}
