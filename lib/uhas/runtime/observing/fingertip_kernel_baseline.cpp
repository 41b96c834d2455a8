#include "uhas/runtime/observing/fingertip_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
}  // namespace

template <>
FingertipKernel<float> fingertip_kernel_baseline() {
  return FingertipLanes<Lanes<float, 4, Here>>::kernel();
}
template <>
FingertipKernel<double> fingertip_kernel_baseline() {
  return FingertipLanes<Lanes<double, 2, Here>>::kernel();
}

}  // namespace uhas
