#include "uhas/runtime/observing/fingertip_kernel.hpp"

namespace uhas {
namespace {
struct Here {};
}  // namespace

template <>
FingertipKernel<float> fingertip_kernel_avx2() {
  return FingertipLanes<Lanes<float, 8, Here>>::kernel();
}
template <>
FingertipKernel<double> fingertip_kernel_avx2() {
  return FingertipLanes<Lanes<double, 4, Here>>::kernel();
}

}  // namespace uhas
