#include "uhas/kinematics/finger_groups.hpp"

#include <doctest/doctest.h>

using namespace uhas;

namespace {

using Lists = std::vector<std::vector<int>>;

}  // namespace

TEST_CASE("fingers that share nothing are groups of their own, in order") {
  CHECK(group_fingers(Lists{{0, 1}, {2}, {3, 4}}) == Lists{{0}, {1}, {2}});
  CHECK(group_fingers(Lists{}) == Lists{});
}

TEST_CASE("a finger without unknowns is a group, too") {
  CHECK(group_fingers(Lists{{}, {1}, {}}) == Lists{{0}, {1}, {2}});
}

TEST_CASE("fingers that share an unknown are one group, the last one first") {
  CHECK(group_fingers(Lists{{0, 1}, {0, 2}, {3}}) == Lists{{1, 0}, {2}});
  CHECK(group_fingers(Lists{{0, 1}, {3}, {2, 1}}) == Lists{{1}, {2, 0}});
}

TEST_CASE("a finger joins groups that shared nothing before") {
  CHECK(group_fingers(Lists{{0}, {1}, {2}, {1, 0}}) == Lists{{2}, {3, 0, 1}});
}

TEST_CASE("of a chain of fingers each shares a joint with the next") {
  CHECK(group_fingers(Lists{{0, 1}, {1, 2}, {2, 3}}) == Lists{{2, 1, 0}});
}
