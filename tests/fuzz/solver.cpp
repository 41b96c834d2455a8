// Any numbers as an action, in every way of solving: joint angles within their limits, or a status and
// an untouched output.
#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "fuzz_file.hpp"
#include "support/arch_profile.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "within_limits.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

template <class Real>
std::vector<Real> numbers(FuzzedDataProvider& input) {
  std::vector<Real> values(input.ConsumeBool() ? 0 : input.ConsumeIntegralInRange<std::size_t>(0, 26));
  for (Real& value : values) {
    if (input.ConsumeBool())
      value = input.ConsumeFloatingPointInRange<Real>(-3, 4);
    else
      value = input.ConsumeFloatingPoint<Real>();
  }
  return values;
}

/// A hand and a way of solving, of the few dozen there are, each made once.
template <class Real>
std::pair<const HandProfile&, CascadeSolver<Real>&> choose_solver(FuzzedDataProvider& input) {
  static const std::array profiles{small_profile(), arch_profile()};
  static std::map<unsigned, CascadeSolver<Real>> solvers;
  const auto choice = input.ConsumeIntegralInRange<unsigned>(0, 63);
  const HandProfile& profile = profiles[choice & 1];
  SolveOptions options = choice & 2 ? kUhasSim : kUhas;
  options.rule = choice & 4 ? CascadeRule::contact : CascadeRule::correspondence;
  options.closing = choice & 8 ? CascadeClosing::hard : CascadeClosing::fade;
  options.field = choice & 16 ? FieldReading::field : FieldReading::finger;
  options.passes = choice & 32 ? 3 : 1;
  return {profile, solvers.try_emplace(choice, profile, options).first->second};
}

template <class Real>
void solve(FuzzedDataProvider& input) {
  const auto [profile, solver] = choose_solver<Real>(input);
  const auto values = numbers<Real>(input), phi = numbers<Real>(input), offsets = numbers<Real>(input),
             bounds = numbers<Real>(input);
  const Action<Real> action{values, phi, input.ConsumeBool(), offsets, bounds};
  constexpr Real untouched = 123;
  std::vector<Real> q(profile.tree.joints.size(), untouched);
  SolveReport report;
  if (solver.solve(action, q, report) != Status::ok) {
    require(std::ranges::all_of(q, [](Real value) { return value == untouched; }));
    return;
  }
  require(within_limits<Real>(profile, q));
  require(std::isnan(report.residual_rms) || report.residual_rms >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider input(data, size);
  if (input.ConsumeBool())
    solve<float>(input);
  else
    solve<double>(input);
  return 0;
}
