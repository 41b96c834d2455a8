#include "uhas/runtime/observing/observation_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
}  // namespace

template <>
ObservationKernel<float> observation_kernel_baseline() {
  return ObservationLanes<Lanes<float, 4, Here>>::kernel();
}
template <>
ObservationKernel<double> observation_kernel_baseline() {
  return ObservationLanes<Lanes<double, 2, Here>>::kernel();
}

}  // namespace uhas
