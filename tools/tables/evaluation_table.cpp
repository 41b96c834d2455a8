#include "tables/evaluation_table.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <ostream>

#include "text/numbers.hpp"
#include "text/table.hpp"
#include "text/words.hpp"

namespace uhas::tools {
namespace {

/// One score of a hand as a number; NaN where the hand has none.
struct Score {
  std::string name, unit;
  int decimals;
  std::function<double(const EvaluatedHand&)> value;
};

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPercent = 100, kMillimetres = 1000, kDegrees = 180 / std::numbers::pi, kMicroseconds = 1e-3;

/// Mean over the fingers whose input has bounds.
double mean_followed(const EvaluatedHand& hand, InputReach FingerReach::*input) {
  double sum = 0, count = 0;
  for (const FingerReach& finger : hand.evaluation.reach.fingers)
    if ((finger.*input).upper > (finger.*input).lower) sum += (finger.*input).followed, ++count;
  return count > 0 ? sum / count : kNone;
}

double dead_inputs(const EvaluatedHand& hand) {
  int count = 0;
  for (const FingerReach& finger : hand.evaluation.reach.fingers) {
    count += finger.azimuth.dead;
    for (const InputReach& input : finger.radial) count += input.dead;
  }
  return count;
}

double most_clamped(const EvaluatedHand& hand) {
  double most = 0;
  for (const ClampedJoint& joint : hand.evaluation.reach.clamped) most = std::max(most, joint.share);
  return most;
}

double steepest(const std::vector<JointStep>& steps) {
  double most = 0;
  for (const JointStep& step : steps) most = std::max(most, step.finest_rate);
  return most;
}

const SolveFit& fit_of(const EvaluatedHand& hand, CascadeRule rule, int passes) {
  return *std::ranges::find_if(hand.evaluation.fit.solves,
                               [&](const SolveFit& s) { return s.solve.rule == rule && s.solve.passes == passes; });
}

std::vector<Score> all_scores() {
  std::vector<Score> scores{
      {"reach, delta theta followed", "%", 0,
       [](const auto& h) { return kPercent * mean_followed(h, &FingerReach::azimuth); }},
      {"reach, delta r followed", "%", 0,
       [](const auto& h) { return kPercent * mean_followed(h, &FingerReach::together); }},
      {"reach, dead inputs", "", 0, dead_inputs},
      {"reach, joint most at a limit", "% of actions", 0, [](const auto& h) { return kPercent * most_clamped(h); }},
      {"fit, optimum, median", "radii", 3, [](const auto& h) { return h.evaluation.fit.optimum.median; }}};
  for (int passes : {1, 3, 10}) {
    const std::string name = "fit, " + std::to_string(passes) + (passes == 1 ? " pass / optimum" : " passes / optimum");
    scores.push_back({name + ", median", "", 3, [=](const auto& h) {
                        return fit_of(h, CascadeRule::correspondence, passes).pooled.ratio.median;
                      }});
    scores.push_back({name + ", p95", "", 3,
                      [=](const auto& h) { return fit_of(h, CascadeRule::correspondence, passes).pooled.ratio.p95; }});
  }
  scores.insert(
      scores.end(),
      {{"fit, contact / optimum, median", "", 3,
        [](const auto& h) { return fit_of(h, CascadeRule::contact, 1).pooled.ratio.median; }},
       {"surface, off the sphere at rest, median", "radii", 3,
        [](const auto& h) { return h.evaluation.surface.at_rest.median; }},
       {"surface, off the deformed sphere, median", "radii", 3,
        [](const auto& h) { return h.evaluation.surface.deformed.median; }},
       {"surface, off the deformed sphere, p95", "radii", 3,
        [](const auto& h) { return h.evaluation.surface.deformed.p95; }},
       {"surface, coverage", "%", 0, [](const auto& h) { return kPercent * h.evaluation.surface.coverage; }},
       {"surface, largest hole", "deg", 0, [](const auto& h) { return kDegrees * h.evaluation.surface.largest_hole; }},
       {"smoothness, delta r", "rad a radius", 1,
        [](const auto& h) { return steepest(h.evaluation.smoothness[0].radial); }},
       {"smoothness, delta r, 3 passes", "rad a radius", 1,
        [](const auto& h) { return steepest(h.evaluation.smoothness[2].radial); }},
       {"smoothness, delta theta", "rad a rad", 1,
        [](const auto& h) { return steepest(h.evaluation.smoothness[0].azimuth); }},
       {"collision", "% of actions", 1,
        [](const auto& h) { return h.evaluation.collision ? kPercent * h.evaluation.collision->share : kNone; }},
       {"collision, distance, median", "mm", 1,
        [](const auto& h) {
          return h.evaluation.collision ? kMillimetres * h.evaluation.collision->distance.median : kNone;
        }},
       {"time, median", "us a solve", 2, [](const auto& h) { return kMicroseconds * h.evaluation.time.median; }},
       {"time, p99", "us a solve", 2, [](const auto& h) { return kMicroseconds * h.evaluation.time.p99; }}});
  return scores;
}

std::string text(double value, int decimals) { return std::isfinite(value) ? fixed(value, decimals) : "-"; }

std::string with_unit(const Score& score) { return score.unit.empty() ? score.name : score.name + ", " + score.unit; }

std::string bounds(double lower, double upper, const std::function<std::string(double)>& number) {
  return number(lower) + " .. " + number(upper);
}

void print_reach(std::ostream& out, const EvaluatedHand& hand) {
  const auto radii = [](double x) { return fixed(x, 2); };
  Table table({{"finger"},
               {"delta theta, deg", Align::right},
               {"useful", Align::right},
               {"achieved", Align::right},
               {"useful delta r, both, radii", Align::right},
               {"achieved", Align::right},
               {"at 60 deg", Align::right},
               {"at 120 deg", Align::right},
               {"dead"}});
  for (std::size_t f = 0; f < hand.profile.fingers.size(); ++f) {
    const FingerReach& reach = hand.evaluation.reach.fingers[f];
    std::vector<std::string> dead;
    if (reach.azimuth.dead) dead.push_back("theta");
    for (std::size_t j = 0; j < reach.radial.size(); ++j)
      if (reach.radial[j].dead) dead.push_back("r" + std::to_string(j));
    const auto useful = [](const InputReach& input, const auto& number) {
      return bounds(input.useful_lower, input.useful_upper, number);
    };
    const auto achieved = [](const InputReach& input, const auto& number) {
      return bounds(input.achieved_lower, input.achieved_upper, number);
    };
    table.add_row({hand.profile.fingers[f].name, bounds(reach.azimuth.lower, reach.azimuth.upper, degrees),
                   useful(reach.azimuth, degrees), achieved(reach.azimuth, degrees), useful(reach.together, radii),
                   achieved(reach.together, radii), useful(reach.radial[0], radii), useful(reach.radial[1], radii),
                   join(dead, ", ")});
  }
  table.print(out);
}

void print_fingers(std::ostream& out, const EvaluatedHand& hand) {
  Table table({{"finger"},
               {"1 pass / optimum", Align::right},
               {"p95", Align::right},
               {"3 passes, p95", Align::right},
               {"residual, radii", Align::right},
               {"p95", Align::right},
               {"off the deformed sphere, radii", Align::right},
               {"p95", Align::right},
               {"points at phi, deg", Align::right},
               {"gap", Align::right}});
  const SolveFit &one = fit_of(hand, CascadeRule::correspondence, 1),
                 &three = fit_of(hand, CascadeRule::correspondence, 3);
  for (std::size_t f = 0; f < hand.profile.fingers.size(); ++f) {
    const FingerSurface& surface = hand.evaluation.surface.fingers[f];
    table.add_row({hand.profile.fingers[f].name, fixed(one.fingers[f].ratio.median, 3),
                   fixed(one.fingers[f].ratio.p95, 3), fixed(three.fingers[f].ratio.p95, 3),
                   fixed(one.fingers[f].residual.median, 3), fixed(one.fingers[f].residual.p95, 3),
                   fixed(surface.deformed.median, 3), fixed(surface.deformed.p95, 3),
                   bounds(surface.phi_least, surface.phi_greatest, degrees), degrees(surface.phi_gap)});
  }
  table.print(out);
}

void print_joints(std::ostream& out, const EvaluatedHand& hand) {
  Table table({{"joint"},
               {"rad a radius of delta r", Align::right},
               {"3 passes", Align::right},
               {"at a limit, % of actions", Align::right}});
  const std::vector<JointStep>&one = hand.evaluation.smoothness[0].radial,
        &three = hand.evaluation.smoothness[2].radial;
  for (std::size_t k = 0; k < one.size(); ++k) {
    const auto& clamped = hand.evaluation.reach.clamped;
    const auto at = std::ranges::find(clamped, one[k].joint, &ClampedJoint::joint);
    const auto same = std::ranges::find(three, one[k].joint, &JointStep::joint);
    table.add_row({hand.profile.tree.joints[one[k].joint].name, fixed(one[k].finest_rate, 1),
                   same == three.end() ? "-" : fixed(same->finest_rate, 1),
                   at == clamped.end() ? "0" : fixed(kPercent * at->share, 0)});
  }
  table.print(out);
}

void print_collisions(std::ostream& out, const EvaluatedHand& hand) {
  if (!hand.evaluation.collision || hand.evaluation.collision->pairs.empty()) return;
  constexpr std::size_t most = 5;
  Table table({{"links that touch"}, {""}, {"poses", Align::right}});
  const std::vector<PairContacts>& pairs = hand.evaluation.collision->pairs;
  for (std::size_t k = 0; k < std::min(pairs.size(), most); ++k)
    table.add_row({hand.profile.links[pairs[k].first].name, hand.profile.links[pairs[k].second].name,
                   std::to_string(pairs[k].poses)});
  out << '\n';
  table.print(out);
}

}  // namespace

void print_evaluation(std::ostream& out, const EvaluationRun& run) {
  std::vector<Table::Column> columns{{"score"}};
  for (const EvaluatedHand& hand : run.hands) columns.push_back({hand.label, Align::right});
  const bool two = run.hands.size() == 2;
  if (two) columns.push_back({"difference", Align::right});
  Table table(columns);
  for (const Score& score : all_scores()) {
    std::vector<Table::Cell> cells{with_unit(score)};
    for (const EvaluatedHand& hand : run.hands) cells.push_back(text(score.value(hand), score.decimals));
    if (two) cells.push_back(text(score.value(run.hands[1]) - score.value(run.hands[0]), score.decimals));
    table.add_row(cells);
  }
  table.print(out);
  if (run.hands.size() != 1) return;
  const EvaluatedHand& hand = run.hands.front();
  for (const auto& print : {print_reach, print_fingers, print_joints}) {
    out << '\n';
    print(out, hand);
  }
  print_collisions(out, hand);
}

void print_evaluation_markdown(std::ostream& out, const EvaluationRun& run) {
  const auto row = [&](const std::string& first, const auto& cell) {
    out << "| " << first << " |";
    for (const EvaluatedHand& hand : run.hands) out << ' ' << cell(hand) << " |";
    out << '\n';
  };
  row("score", [](const EvaluatedHand& hand) { return hand.label; });
  row("---", [](const EvaluatedHand&) { return std::string("---:"); });
  for (const Score& score : all_scores())
    row(with_unit(score), [&](const EvaluatedHand& hand) { return text(score.value(hand), score.decimals); });
}

}  // namespace uhas::tools
