#include "uhas/runtime/lanes/finger_lanes_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
using Floats = Lanes<float, 8, Here>;
using Doubles = Lanes<double, 4, Here>;
}  // namespace

template <>
FingerLanes<float> finger_lanes_avx2() {
  return FingerLanesOf<Floats, Floats>::functions();
}
template <>
FingerLanes<double> finger_lanes_avx2() {
  return FingerLanesOf<Doubles, Doubles>::functions();
}

}  // namespace uhas
