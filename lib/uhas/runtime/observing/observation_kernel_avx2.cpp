#include "uhas/runtime/observing/observation_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
}  // namespace

template <>
ObservationKernel<float> observation_kernel_avx2() {
  return ObservationLanes<Lanes<float, 8, Here>>::kernel();
}
template <>
ObservationKernel<double> observation_kernel_avx2() {
  return ObservationLanes<Lanes<double, 4, Here>>::kernel();
}

}  // namespace uhas
