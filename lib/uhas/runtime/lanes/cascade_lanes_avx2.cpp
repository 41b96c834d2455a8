#include "uhas/runtime/lanes/cascade_lanes_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
using Floats = Lanes<float, 8, Here>;
using Doubles = Lanes<double, 4, Here>;
}  // namespace

template <>
CascadeLanes<float> cascade_lanes_avx2() {
  return CascadeLanesOf<Floats>::functions();
}
template <>
CascadeLanes<double> cascade_lanes_avx2() {
  return CascadeLanesOf<Doubles>::functions();
}

}  // namespace uhas
