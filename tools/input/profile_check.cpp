#include "input/profile_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "uhas/runtime/cascade_solver.hpp"

namespace uhas::tools {
namespace {

constexpr double kFixedPointTolerance = 1e-9;  // rad or m; design, section 3.8

}  // namespace

std::vector<Check> check_behaviour(const HandProfile& profile) {
  CascadeSolver<double> solver(profile);
  std::vector<double> q(profile.tree.joints.size());
  const std::array<double, 15> zero{};
  const Status status = solver.solve({.values = zero}, q);

  double worst = 0;
  for (std::size_t i = 0; i < q.size(); ++i) worst = std::max(worst, std::abs(q[i] - profile.joint_traits[i].q_sphere));
  const bool returned = status == Status::ok && worst <= kFixedPointTolerance;
  return {{"file", true, "whole, of a version this tool reads, all values in range"},
          {"zero action", returned, returned ? "returns the wrapped pose" : "does not return the wrapped pose"}};
}

std::vector<Check> check_sources(const HandProfile& profile, const HandModel& model) {
  std::vector<SourceFile> before = profile.sources, now = model.sources;
  // the first is the URDF, which may have got another name meanwhile
  if (!before.empty() && !now.empty()) before.front().name = now.front().name;

  std::vector<Check> checks;
  for (const SourceFile& file : before) {
    const auto found = std::ranges::find(now, file.name, &SourceFile::name);
    if (found == now.end())
      checks.push_back({file.name, false, "no longer part of the model"});
    else if (found->sha256 == file.sha256)
      checks.push_back({file.name, true, "unchanged"});
    else
      checks.push_back({file.name, false, "changed"});
  }
  for (const SourceFile& file : now)
    if (std::ranges::find(before, file.name, &SourceFile::name) == before.end())
      checks.push_back({file.name, false, "new in the model"});
  return checks;
}

}  // namespace uhas::tools
