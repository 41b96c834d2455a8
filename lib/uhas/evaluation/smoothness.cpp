#include "uhas/evaluation/smoothness.hpp"

#include <cmath>
#include <random>

#include "uhas/evaluation/action_space.hpp"
#include "uhas/evaluation/parallel.hpp"

namespace uhas {
namespace {

/// A straight way through the action space: `from` + x `change`, x = 0 .. `length`.
struct Line {
  std::vector<double> from, change;
  double length = 0;
  bool radial = true;  ///< radial inputs change, not an azimuth

  std::vector<double> at(double x) const {
    std::vector<double> action = from;
    for (std::size_t i = 0; i < action.size(); ++i) action[i] += x * change[i];
    return action;
  }
};

/// Between two actions; the largest element of `change` has magnitude 1.
Line line_between(const std::vector<double>& from, const std::vector<double>& to, bool radial) {
  Line line{.from = from, .change = to, .length = 0, .radial = radial};
  for (std::size_t i = 0; i < to.size(); ++i) line.length = std::max(line.length, std::abs(to[i] - from[i]));
  for (std::size_t i = 0; i < to.size(); ++i) line.change[i] = line.length > 0 ? (to[i] - from[i]) / line.length : 0;
  return line;
}

void add_axes(const ActionSpace& space, std::vector<Line>& lines) {
  for (int slot = 0; slot < kSlotCount; ++slot) {
    if (space.first_slot[slot] != slot) continue;
    const int first = ActionSpace::radial(slot, 0), last = first + ActionSpace::kVectors - 1;
    for (const auto& [begin, end] : {std::pair(first, first), std::pair(last, last), std::pair(first, last)})
      for (double share : {0.0, -1.0, 1.0}) {
        std::vector<double> from = space.zero(), to = from;
        for (int s = 0; s < kSlotCount; ++s)
          from[s] = to[s] = share < 0 ? -share * space.lower[s] : share * space.upper[s];
        for (int i = begin; i <= end; ++i) from[i] = space.lower[i], to[i] = space.upper[i];
        lines.push_back(line_between(space.with_fingers_agreed(from), space.with_fingers_agreed(to), true));
      }
  }
}

void add_azimuth(const ActionSpace& space, const std::vector<double>& base, int slot, std::vector<Line>& lines) {
  std::vector<double> from = base, to = base;
  from[slot] = space.lower[slot], to[slot] = space.upper[slot];
  const Line line = line_between(space.with_fingers_agreed(from), space.with_fingers_agreed(to), false);
  if (line.length > 0) lines.push_back(line);
}

std::vector<Line> all_lines(const ActionSpace& space, const SmoothnessOptions& options) {
  std::vector<Line> lines;
  add_axes(space, lines);
  for (int slot = 0; slot < kSlotCount; ++slot) add_azimuth(space, space.zero(), slot, lines);
  std::mt19937_64 random(options.seed);
  for (int n = 0; n < options.lines; ++n) {
    const std::vector<double> from = space.with_fingers_agreed(space.random(random));
    std::vector<double> to = space.with_fingers_agreed(space.random(random));
    std::copy_n(from.begin(), kSlotCount, to.begin());
    lines.push_back(line_between(from, to, true));
    if (n % 8 == 0) add_azimuth(space, from, n / 8 % kSlotCount, lines);
  }
  return lines;
}

/// Joint values along a line.
class LineSolver {
 public:
  LineSolver(const HandProfile& profile, const CascadeSolver<double>& solver) : solver_(solver), profile_(profile) {}

  std::vector<double> at(const Line& line, double x) {
    std::vector<double> q(profile_.tree.joints.size());
    solver_.solve({.values = line.at(x)}, q);
    for (std::size_t i = 0; i < q.size(); ++i)
      if (profile_.tree.joints[i].kind == JointKind::prismatic) q[i] /= profile_.radius;
    return q;
  }

 private:
  CascadeSolver<double> solver_;
  const HandProfile& profile_;
};

/// The steepest step of each joint along one line.
struct Steepest {
  double rate = 0, x = 0;
};

std::vector<Steepest> walk(LineSolver& solver, const Line& line, double step) {
  const int steps = std::max(1, static_cast<int>(std::ceil(line.length / step)));
  const double each = line.length / steps;
  std::vector<double> before = solver.at(line, 0);
  std::vector<Steepest> steepest(before.size());
  for (int k = 0; k < steps; ++k) {
    std::vector<double> after = solver.at(line, (k + 1) * each);
    for (std::size_t i = 0; i < after.size(); ++i) {
      const double rate = std::abs(after[i] - before[i]) / each;
      if (rate > steepest[i].rate) steepest[i] = {rate, k * each};
    }
    before.swap(after);
  }
  return steepest;
}

/// Halves the step again and again, keeping the half in which the joint goes further.
JointStep refine(LineSolver& solver, const Line& line, int joint, const Steepest& place, double step) {
  constexpr int halvings = 16;
  constexpr double least_jump = 1e-3;  // rad; a slope of 12 leaves 2e-6
  double a = place.x, b = std::min(place.x + step, line.length);
  double q_a = solver.at(line, a)[joint], q_b = solver.at(line, b)[joint];
  JointStep result{
      .joint = joint, .rate = place.rate, .finest_rate = place.rate, .jump = 0, .action = {}, .change = line.change};
  for (int n = 0; n < halvings; ++n) {
    const double middle = (a + b) / 2, q = solver.at(line, middle)[joint];
    if (std::abs(q - q_a) > std::abs(q_b - q))
      b = middle, q_b = q;
    else
      a = middle, q_a = q;
    result.finest_rate = std::max(result.finest_rate, std::abs(q_b - q_a) / (b - a));
  }
  if (std::abs(q_b - q_a) > least_jump) result.jump = std::abs(q_b - q_a);
  result.action = line.at(a);
  return result;
}

}  // namespace

SmoothnessScore measure_smoothness(const HandProfile& profile, const SmoothnessOptions& options) {
  const std::vector<Line> lines = all_lines(ActionSpace(profile), options);
  const CascadeSolver<double> solver(profile, options.solve);
  std::vector<std::vector<Steepest>> found(lines.size());
  parallel_for(static_cast<int>(lines.size()), options.threads, [&] {
    return [&, own = LineSolver(profile, solver)](int k) mutable { found[k] = walk(own, lines[k], options.step); };
  });

  LineSolver own(profile, solver);
  SmoothnessScore score;
  for (int joint = 0; joint < static_cast<int>(profile.tree.joints.size()); ++joint)
    for (bool radial : {true, false}) {
      std::size_t steepest = lines.size();
      for (std::size_t k = 0; k < lines.size(); ++k)
        if (lines[k].radial == radial && found[k][joint].rate > 0 &&
            (steepest == lines.size() || found[k][joint].rate > found[steepest][joint].rate))
          steepest = k;
      if (steepest == lines.size()) continue;
      (radial ? score.radial : score.azimuth)
          .push_back(refine(own, lines[steepest], joint, found[steepest][joint], options.step));
    }
  return score;
}

}  // namespace uhas
