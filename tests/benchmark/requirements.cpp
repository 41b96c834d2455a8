#include "requirements.hpp"

#include <functional>
#include <optional>
#include <string>

namespace uhas::benchmark {
namespace {

struct Requirement {
  std::string text;
  bool at_most;
  double must, aim;
  bool large_hands;  ///< speaks of a five-finger hand of twenty joints
  std::function<double(const HandMeasurement&)> value;
};

/// median(above) / median(below)
auto ratio(const char* above, const char* below) {
  return [=](const HandMeasurement& hand) { return hand.median(above) / hand.median(below); };
}

const std::vector<Requirement>& requirements() {
  constexpr bool at_most = true, at_least = false, large = true, all = false;
  static const std::vector<Requirement> list{
      {"solve, gentle: times own fingertips", at_most, 2, 1.2, all,
       ratio("solve, gentle, double", "fingertips, double")},
      {"solve, any: times own fingertips", at_most, 5, 3, all, ratio("solve, any, double", "fingertips, double")},
      {"solve, closing grasp: times own fingertips", at_most, 6, 3, all,
       ratio("solve, closing grasp, double", "fingertips, double")},
      {"batch, gentle: times the batch's fingertips", at_most, 5, 3.5, all,
       ratio("solve, gentle, batch, float", "fingertips, batch, float")},
      {"batch, any: times the batch's fingertips", at_most, 16, 10, all,
       ratio("solve, any, batch, float", "fingertips, batch, float")},
      {"batch, closing grasp: times the batch's fingertips", at_most, 32, 16, all,
       ratio("solve, closing grasp, batch, float", "fingertips, batch, float")},
      {"learner's step, gentle: times the batch's fingertips", at_most, 10, 7, all,
       ratio("solve + observe + fingertips, gentle, batch, float", "fingertips, batch, float")},
      {"encode, any: times a solve", at_most, 15, 8, all, ratio("encode, any, double", "solve, any, double")},
      {"encode, any, p99: times a solve", at_most, 100, 100, all,
       [](const HandMeasurement& hand) { return hand.encode_tail.call.p99 / hand.any_tail.call.median; }},
      {"solve, gentle, with a report: times without", at_most, 3, 2, all,
       ratio("solve, gentle, double, report", "solve, gentle, double")},
      {"solve: faster than NLopt SLSQP to the end", at_least, 1000, 1000, large,
       ratio("NLopt, SLSQP", "solve, trajectory, double")},
      {"solve: faster than KDL LMA", at_least, 150, 150, large, ratio("KDL, LMA", "solve, trajectory, double")},
      {"solve: times damped least squares", at_most, 0.5, 0.5, large,
       ratio("solve, trajectory, double", "damped least squares")},
      {"solve, gentle: p99 / median", at_most, 3, 1.5, all,
       [](const HandMeasurement& hand) { return hand.gentle_tail.call.p99 / hand.gentle_tail.call.median; }},
      {"solve, any: p99 / median", at_most, 3, 1.5, all,
       [](const HandMeasurement& hand) { return hand.any_tail.call.p99 / hand.any_tail.call.median; }},
      {"forward kinematics: faster than KDL's", at_least, 3.5, 5, all, ratio("KDL, fingertips", "fingertips, double")},
      {"forward kinematics, batch: faster than KDL's", at_least, 35, 50, all,
       ratio("KDL, fingertips", "fingertips, batch, float")},
  };
  return list;
}

std::vector<const HandMeasurement*> hands_for(const Requirement& requirement,
                                              const std::vector<HandMeasurement>& hands) {
  std::vector<const HandMeasurement*> chosen;
  for (const HandMeasurement& hand : hands)
    if (!requirement.large_hands || (hand.fingers >= 5 && hand.independent_joints >= 20)) chosen.push_back(&hand);
  if (chosen.empty())
    for (const HandMeasurement& hand : hands) chosen.push_back(&hand);
  return chosen;
}

}  // namespace

std::vector<Judgement> hold_against_requirements(const std::vector<HandMeasurement>& hands, const PointGrowth& growth) {
  std::vector<Judgement> judgements;
  for (const Requirement& requirement : requirements()) {
    std::optional<Judgement> worst;
    for (const HandMeasurement* hand : hands_for(requirement, hands)) {
      const double value = requirement.value(*hand);
      if (!worst || (requirement.at_most ? value > worst->value : value < worst->value))
        worst = {requirement.text, requirement.at_most, requirement.must, requirement.aim, value, hand->hand};
    }
    if (worst) judgements.push_back(*worst);
  }
  if (growth.rows.size() > 1)  // "constant": what a repetition of the measurement may differ by
    judgements.push_back({"solve, 100 times the stored points: times the time", true, 1.1, 1.1,
                          growth.rows.back().solve.median / growth.rows.front().solve.median, growth.hand});
  return judgements;
}

}  // namespace uhas::benchmark
