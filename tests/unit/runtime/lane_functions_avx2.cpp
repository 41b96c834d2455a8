#include "unit/runtime/lane_functions_kernel.hpp"

namespace uhas::test {
namespace {
struct Here {};
}  // namespace

template <>
LaneFunctions<float> lane_functions_avx2() {
  return LaneLoops<Lanes<float, 8, Here>>::functions();
}
template <>
LaneFunctions<double> lane_functions_avx2() {
  return LaneLoops<Lanes<double, 4, Here>>::functions();
}

}  // namespace uhas::test
