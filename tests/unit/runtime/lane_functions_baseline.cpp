#include "unit/runtime/lane_functions_kernel.hpp"

namespace uhas::test {
namespace {
struct Here {};
}  // namespace

template <>
LaneFunctions<float> lane_functions_baseline() {
  return LaneLoops<Lanes<float, 4, Here>>::functions();
}
template <>
LaneFunctions<double> lane_functions_baseline() {
  return LaneLoops<Lanes<double, 2, Here>>::functions();
}

}  // namespace uhas::test
