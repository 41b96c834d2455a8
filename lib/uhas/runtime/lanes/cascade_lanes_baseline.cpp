#include "uhas/runtime/lanes/cascade_lanes_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
using Floats = Lanes<float, 4, Here>;
using Doubles = Lanes<double, 2, Here>;
}  // namespace

template <>
CascadeLanes<float> cascade_lanes_baseline() {
  return CascadeLanesOf<Floats>::functions();
}
template <>
CascadeLanes<double> cascade_lanes_baseline() {
  return CascadeLanesOf<Doubles>::functions();
}

}  // namespace uhas
