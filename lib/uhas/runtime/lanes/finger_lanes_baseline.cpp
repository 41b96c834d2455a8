#include "uhas/runtime/lanes/finger_lanes_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
using Floats = Lanes<float, 4, Here>;
using Doubles = Lanes<double, 2, Here>;
}  // namespace

template <>
FingerLanes<float> finger_lanes_baseline() {
  return FingerLanesOf<Floats, Floats>::functions();
}
template <>
FingerLanes<double> finger_lanes_baseline() {
  return FingerLanesOf<Doubles, Doubles>::functions();
}

}  // namespace uhas
