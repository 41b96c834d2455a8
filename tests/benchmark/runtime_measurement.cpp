#include "runtime_measurement.hpp"

#include <malloc.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "runtime_works.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/profile_builder/build_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/encoder.hpp"
#include "uhas/runtime/fingertip_kinematics.hpp"
#include "uhas/runtime/observation.hpp"

namespace uhas::benchmark {
namespace {

std::size_t solver_points(const HandProfile& profile) {
  return std::size_t(
      std::ranges::count_if(profile.correspondences, [](const auto& point) { return point.weight > 0; }));
}

/// Lets a peer follow the trajectory once more, now to look at its answers.
template <class Reach, class Fingertips>
PeerAnswers judge(std::string name, const HandCase& hand, Reach reach, Fingertips fingertips) {
  constexpr double near = 1e-3;      // m
  constexpr double rounding = 1e-9;  // rad, m
  const std::size_t joints = hand.joints(), numbers = 3 * hand.fingers(),
                    count = std::min<std::size_t>(hand.count, 400);
  std::vector<double> q(hand.trajectory.q.begin(), hand.trajectory.q.begin() + joints), tips(numbers);
  std::size_t reached = 0, within = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const auto targets = std::span(hand.trajectory.fingertips).subspan(n * numbers, numbers);
    reach(targets, q);
    fingertips(q, tips);
    for (std::size_t f = 0; f < hand.fingers(); ++f) {
      const auto at = [&](std::span<const double> v) { return Vector3d{v[3 * f], v[3 * f + 1], v[3 * f + 2]}; };
      reached += norm(at(tips) - at(targets)) <= near;
    }
    const auto fits = [&](const Joint& joint) {
      const double value = q[&joint - hand.profile.tree.joints.data()];
      return joint.mimic_master >= 0 || (value >= joint.lower - rounding && value <= joint.upper + rounding);
    };
    within += std::ranges::all_of(hand.profile.tree.joints, fits);
  }
  return {std::move(name), double(reached) / double(count * hand.fingers()), double(within) / double(count)};
}

std::vector<PeerAnswers> judge_peers(const HandCase& hand, Peers& peers) {
  const FingertipKinematics<double> kinematics(hand.profile);
  const auto own = [&](std::span<const double> q, std::span<double> out) { kinematics.fingertips(q, out); };
  const auto kdl = [&](std::span<const double> q, std::span<double> out) { peers.kdl.fingertips(q, out); };
  return {judge(
              "KDL, LMA", hand, [&](auto targets, auto& q) { peers.kdl.reach(targets, q); }, kdl),
          judge(
              "NLopt, SLSQP", hand, [&](auto targets, auto& q) { peers.slsqp.reach(targets, q); }, own),
          judge(
              "NLopt, SLSQP, as shipped", hand,
              [&](auto targets, auto& q) { peers.slsqp_as_shipped.reach(targets, q); }, own),
          judge(
              "damped least squares", hand, [&](auto targets, auto& q) { peers.fingertip_ik.reach(targets, q); }, own)};
}

/// What `make()` leaves on the heap.
template <class Make>
ObjectSize object_size(std::string name, Make make) {
  const std::size_t before = mallinfo2().uordblks;
  const auto object = make();
  return {std::move(name), sizeof object, mallinfo2().uordblks - before};
}

std::vector<ObjectSize> object_sizes(const HandProfile& profile) {
  const CascadeSolver<double> shared(profile);
  return {object_size("HandProfile", [&] { return profile; }),
          object_size("CascadeSolver<double>", [&] { return CascadeSolver<double>(profile); }),
          object_size("CascadeSolver<double>, a copy", [&] { return shared; }),
          object_size("CascadeSolver<float>", [&] { return CascadeSolver<float>(profile); }),
          object_size("FingertipKinematics<float>", [&] { return FingertipKinematics<float>(profile); }),
          object_size("Observer<float>", [&] { return Observer<float>(profile); }),
          object_size("Encoder<double>", [&] { return Encoder<double>(profile); })};
}

Tail solve_tail(const HandCase& hand, const ActionSet& set, const RuntimeSettings& settings) {
  CascadeSolver<double> solver(hand.profile);
  std::vector<double> q(solver.joint_count());
  const std::size_t size = set.actions.size() / hand.count;
  const auto solve = [&](std::size_t call) {
    const Action<double> action{.values = std::span(set.actions).subspan(call % hand.count * size, size),
                                .driving_vectors_phi = {}};
    solver.solve(action, q);
  };
  return measure_tail(solve, settings.tail_calls, settings.tail_runs);
}

Tail encode_tail(const HandCase& hand, const ActionSet& set, const RuntimeSettings& settings) {
  Encoder<double> encoder(hand.profile);
  std::vector<double> action(encoder.action_size());
  const std::size_t size = hand.joints();
  const auto encode = [&](std::size_t call) {
    EncodeReport report;
    encoder.encode(std::span(set.q).subspan(call % hand.count * size, size), action, report);
  };
  constexpr std::size_t solves_in_an_encode = 20;  // about: as long as the others take
  return measure_tail(encode, settings.tail_calls / solves_in_an_encode, settings.tail_runs);
}

}  // namespace

const Summary& HandMeasurement::summary(const std::string& work) const {
  const auto found = std::ranges::find(works, work, &Measured::work);
  if (found == works.end()) throw std::out_of_range("not measured: " + work);
  return found->summary;
}

HandMeasurement measure_hand(const HandCase& hand, const RuntimeSettings& settings) {
  HandMeasurement measurement;
  measurement.hand = hand.urdf.stem();
  measurement.fingers = hand.fingers();
  measurement.joints = hand.joints();
  measurement.independent_joints = std::size_t(std::ranges::count(hand.profile.tree.joints, -1, &Joint::mimic_master));
  measurement.stored_points = hand.profile.correspondences.size();
  measurement.solver_points = solver_points(hand.profile);
  measurement.sizes = object_sizes(hand.profile);

  Peers peers(hand);
  std::vector<Work> works = runtime_works(hand, settings.batch);
  for (Work& work : peer_works(hand, peers)) works.push_back(std::move(work));
  const std::vector<Summary> summaries = measure_in_turn(works, settings.rounds);
  for (std::size_t i = 0; i < works.size(); ++i)
    measurement.works.push_back({works[i].name, works[i].hands, summaries[i]});
  measurement.peers = judge_peers(hand, peers);
  measurement.gentle_tail = solve_tail(hand, hand.gentle, settings);
  measurement.any_tail = solve_tail(hand, hand.any, settings);
  measurement.encode_tail = encode_tail(hand, hand.any, settings);
  return measurement;
}

PointGrowth measure_point_growth(const HandCase& hand, const std::vector<int>& samples,
                                 const RuntimeSettings& settings) {
  constexpr int points_per_link =
      8;  // so few that the smallest profile has them, too: the solver's share stays the same
  PointGrowth growth{.hand = hand.urdf.stem(), .rows = {}};
  std::vector<Work> works;
  for (int count : samples) {
    BuildSettings build;
    build.correspondences.samples = count;
    build.correspondences.points_per_link = points_per_link;
    const HandProfile profile = build_profile(hand.urdf.string(), build);
    growth.rows.push_back({profile.correspondences.size(), solver_points(profile), {}});
    works.push_back(solve_work<double>("", profile, hand.any.actions));
  }
  const std::vector<Summary> summaries = measure_in_turn(works, settings.rounds);
  for (std::size_t i = 0; i < works.size(); ++i) growth.rows[i].solve = summaries[i];
  return growth;
}

}  // namespace uhas::benchmark
