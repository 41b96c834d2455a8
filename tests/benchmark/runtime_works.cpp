#include "runtime_works.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>

#include "uhas/c/uhas.h"
#include "uhas/profile_io/write_profile.hpp"
#include "uhas/runtime/batch_solver.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/encoder.hpp"
#include "uhas/runtime/fingertip_kinematics.hpp"
#include "uhas/runtime/observation.hpp"

namespace uhas::benchmark {
namespace {

// single calls in a sample, and encodes: long against the clock, short against a time slice
constexpr std::size_t kSingles = 200, kEncodes = 50;

/// Rows of numbers that works walk through, sample after sample, from the first again at the end.
template <class Real>
class Rows {
 public:
  Rows(const std::vector<double>& numbers, std::size_t count)
      : numbers_(numbers.begin(), numbers.end()), count_(count) {}

  std::size_t width() const { return numbers_.size() / count_; }
  std::span<const Real> operator[](std::size_t row) const {
    return std::span(numbers_).subspan(row % count_ * width(), width());
  }
  /// [rows][width()], the rows repeated as often as it takes.
  std::vector<Real> repeated(std::size_t rows) const {
    std::vector<Real> out;
    for (std::size_t n = 0; n < rows; ++n) out.insert(out.end(), (*this)[n].begin(), (*this)[n].end());
    return out;
  }

 private:
  std::vector<Real> numbers_;
  std::size_t count_;
};

/// `hands` calls a sample, each on the next row.
template <class Call>
Work singles(std::string name, std::size_t hands, Call call) {
  return {std::move(name), hands, [hands, call = std::move(call)](std::size_t sample) mutable {
            for (std::size_t n = 0; n < hands; ++n) call(sample * hands + n);
          }};
}

/// The whole batch on the calling thread.
template <class Real>
Work batch_work(std::string name, const HandCase& hand, const ActionSet& set, std::size_t batch) {
  const auto solver = std::make_shared<BatchSolver<Real>>(hand.profile);
  return {std::move(name), batch,
          [=, actions = Rows<Real>(set.actions, hand.count).repeated(batch),
           q = std::vector<Real>(batch * hand.joints())](std::size_t) mutable {
            solver->solve({.count = batch, .values = actions, .driving_vectors_phi = {}, .hands = {}}, q);
          }};
}

template <class Real>
void add_fingertips(std::vector<Work>& works, const std::string& type, const HandCase& hand, std::size_t batch) {
  const FingertipKinematics<Real> kinematics(hand.profile);
  const Rows<Real> q(hand.trajectory.q, hand.count);
  const std::size_t numbers = 3 * hand.fingers();
  works.push_back(
      singles("fingertips, " + type, kSingles,
              [=, out = std::vector<Real>(numbers)](std::size_t row) mutable { kinematics.fingertips(q[row], out); }));
  works.push_back({"fingertips, batch, " + type, batch,
                   [=, many = q.repeated(batch), out = std::vector<Real>(batch * numbers)](std::size_t) mutable {
                     kinematics.fingertips_batch(many, out);
                   }});
}

void add_observations(std::vector<Work>& works, const HandCase& hand, std::size_t batch) {
  const Observer<float> observer(hand.profile);
  const Rows<float> q(hand.trajectory.q, hand.count), qd(hand.rates, hand.count);
  const std::size_t size = observer.size();
  works.push_back(singles("observe, float", kSingles,
                          [=, observer = observer, out = std::vector<float>(size)](std::size_t row) mutable {
                            observer.observe(q[row], qd[row], out);
                          }));
  works.push_back({"observe, batch, float", batch,
                   [observer = observer, many = q.repeated(batch), many_rates = qd.repeated(batch),
                    out = std::vector<float>(batch * size)](std::size_t) mutable {
                     observer.observe_batch(many, many_rates, out);
                   }});
}

/// A learner's step: joint angles, what a policy sees of them, and fingertips for the reward.
Work step_work(const HandCase& hand, std::size_t batch) {
  const auto solver = std::make_shared<BatchSolver<float>>(hand.profile);
  const Observer<float> observer(hand.profile);
  const FingertipKinematics<float> kinematics(hand.profile);
  return {"solve + observe + fingertips, gentle, batch, float", batch,
          [=, observer = observer, actions = Rows<float>(hand.gentle.actions, hand.count).repeated(batch),
           rates = Rows<float>(hand.rates, hand.count).repeated(batch), q = std::vector<float>(batch * hand.joints()),
           seen = std::vector<float>(batch * observer.size()),
           tips = std::vector<float>(batch * 3 * hand.fingers())](std::size_t) mutable {
            solver->solve({.count = batch, .values = actions}, q);
            observer.observe_batch(q, rates, seen);
            kinematics.fingertips_batch(q, tips);
          }};
}

Work report_work(std::string name, const HandProfile& profile, const std::vector<double>& actions) {
  CascadeSolver<double> solver(profile);
  std::vector<double> q(solver.joint_count());
  std::vector<std::uint8_t> flags(q.size());
  return singles(std::move(name), kSingles,
                 [rows = Rows<double>(actions, actions.size() / 15), solver, q, at_limit = flags,
                  closed = flags](std::size_t row) mutable {
                   SolveReport report{.at_limit = at_limit, .closed = closed};
                   solver.solve({.values = rows[row]}, q, report);
                 });
}

/// Single solves through the C header, without a report.
Work c_work(const HandCase& hand) {
  const auto file = std::filesystem::temp_directory_path() / ("uhas_benchmark_" + std::to_string(getpid()) + ".h5");
  write_profile(hand.profile, file.string());
  uhas_profile* profile = nullptr;
  uhas_solver* made = nullptr;
  const bool sound = uhas_profile_load(file.c_str(), &profile, nullptr, 0) == UHAS_OK &&
                     uhas_solver_create(profile, nullptr, &made, nullptr, 0) == UHAS_OK;
  std::filesystem::remove(file);
  uhas_profile_free(profile);
  if (!sound) throw std::runtime_error("the C functions refuse the profile of " + hand.profile.hand);
  const std::shared_ptr<uhas_solver> solver(made, uhas_solver_free);
  return singles("solve, gentle, double, C", kSingles,
                 [solver, rows = Rows<double>(hand.gentle.actions, hand.count),
                  q = std::vector<double>(hand.joints())](std::size_t row) mutable {
                   const std::span<const double> action = rows[row];
                   uhas_solver_solve(solver.get(), action.data(), action.size(), nullptr, q.data(), q.size(), nullptr,
                                     nullptr);
                 });
}

void add_encoding(std::vector<Work>& works, std::string name, const HandCase& hand, const ActionSet& set) {
  const Rows<double> q(set.q, hand.count);
  works.push_back(
      singles(std::move(name), kEncodes,
              [=, encoder = Encoder<double>(hand.profile), out = std::vector<double>(15)](std::size_t row) mutable {
                EncodeReport report;
                encoder.encode(q[row], out, report);
              }));
}

}  // namespace

template <class Real>
Work solve_work(std::string name, const HandProfile& profile, const std::vector<double>& actions, int passes) {
  constexpr std::size_t numbers = 15;
  CascadeSolver<Real> solver(profile, {.passes = passes});
  std::vector<Real> q(solver.joint_count());
  return singles(std::move(name), kSingles,
                 [rows = Rows<Real>(actions, actions.size() / numbers), solver, q](std::size_t row) mutable {
                   solver.solve({.values = rows[row], .driving_vectors_phi = {}}, q);
                 });
}

template Work solve_work<float>(std::string, const HandProfile&, const std::vector<double>&, int);
template Work solve_work<double>(std::string, const HandProfile&, const std::vector<double>&, int);

std::vector<Work> runtime_works(const HandCase& hand, std::size_t batch) {
  std::vector<Work> works;
  const std::pair<const char*, const ActionSet*> sets[] = {
      {"gentle", &hand.gentle}, {"any", &hand.any}, {"closing grasp", &hand.closing}};
  for (const auto& [name, set] : sets) {
    const std::string solve = std::string("solve, ") + name;
    works.push_back(solve_work<double>(solve + ", double", hand.profile, set->actions));
    works.push_back(solve_work<float>(solve + ", float", hand.profile, set->actions));
    works.push_back(report_work(solve + ", double, report", hand.profile, set->actions));
    works.push_back(solve_work<double>(solve + ", double, 3 passes", hand.profile, set->actions, 3));
    works.push_back(batch_work<double>(solve + ", batch, double", hand, *set, batch));
    works.push_back(batch_work<float>(solve + ", batch, float", hand, *set, batch));
  }
  works.push_back(solve_work<double>("solve, trajectory, double", hand.profile, hand.trajectory.actions));
  add_fingertips<double>(works, "double", hand, batch);
  add_fingertips<float>(works, "float", hand, batch);
  add_observations(works, hand, batch);
  works.push_back(step_work(hand, batch));
  works.push_back(c_work(hand));
  add_encoding(works, "encode, gentle, double", hand, hand.gentle);
  add_encoding(works, "encode, any, double", hand, hand.any);
  return works;
}

Peers::Peers(const HandCase& hand)
    : kdl(hand),
      slsqp(hand.profile, kSlsqpToTarget),
      slsqp_as_shipped(hand.profile, kSlsqpAsShipped),
      fingertip_ik(hand.profile),
      q_lma(hand.trajectory.q.begin(), hand.trajectory.q.begin() + hand.joints()),
      q_slsqp(q_lma),
      q_slsqp_as_shipped(q_lma),
      q_fingertip_ik(q_lma) {
  std::vector<double> tips(3 * hand.fingers());
  kdl.fingertips(q_lma, tips);
  for (std::size_t i = 0; i < tips.size(); ++i)
    if (std::abs(tips[i] - hand.trajectory.fingertips[i]) > 1e-9)
      throw std::runtime_error("KDL and uhas disagree on the fingertips of " + hand.profile.hand);
}

std::vector<Work> peer_works(const HandCase& hand, Peers& peers) {
  const auto targets = std::make_shared<const Rows<double>>(hand.trajectory.fingertips, hand.count);
  const auto q = std::make_shared<const Rows<double>>(hand.trajectory.q, hand.count);
  std::vector<double> out(3 * hand.fingers());
  return {
      singles("KDL, fingertips", kSingles,
              [=, &peers](std::size_t row) mutable { peers.kdl.fingertips((*q)[row], out); }),
      singles("KDL, LMA", 10, [=, &peers](std::size_t row) { peers.kdl.reach((*targets)[row], peers.q_lma); }),
      singles("NLopt, SLSQP", 1, [=, &peers](std::size_t row) { peers.slsqp.reach((*targets)[row], peers.q_slsqp); }),
      singles(
          "NLopt, SLSQP, as shipped", 1,
          [=, &peers](std::size_t row) { peers.slsqp_as_shipped.reach((*targets)[row], peers.q_slsqp_as_shipped); }),
      singles("damped least squares", 100,
              [=, &peers](std::size_t row) { peers.fingertip_ik.reach((*targets)[row], peers.q_fingertip_ik); }),
  };
}

}  // namespace uhas::benchmark
