// One rule of refusal in every call for many hands: a row that is refused hinders no other.
#include "support/refused_rows.hpp"

#include <doctest/doctest.h>

#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/batch_solver.hpp"
#include "uhas/runtime/fingertip_kinematics.hpp"
#include "uhas/runtime/observation.hpp"
#include "uhas/runtime/retarget.hpp"

using namespace uhas;

namespace {

constexpr std::size_t kRows = 23, kJoints = 5;

template <class Real>
std::vector<Real> random_actions() {
  std::mt19937_64 random(1);
  std::vector<Real> actions;
  for (std::size_t n = 0; n < kRows; ++n)
    for (double value : test::random_action(random, 0.4, 0.6)) actions.push_back(Real(value));
  return actions;
}

template <class Real>
std::vector<Real> random_postures() {
  std::vector<Real> q(kRows * kJoints);
  REQUIRE(BatchSolver<Real>(test::small_profile()).solve({.count = kRows, .values = random_actions<Real>()}, q) ==
          Status::ok);
  return q;
}

template <class Real>
void check_wide_calls(InstructionSet set) {
  CAPTURE(to_string(set));
  const HandProfile profile = test::small_profile();
  const std::vector<Real> q = random_postures<Real>();
  using In = std::span<const Real>;
  using Out = std::span<Real>;
  using Statuses = std::span<Status>;

  BatchSolver<Real> solver(profile, {}, {.threads = 2, .instruction_set = set});
  test::check_refused_rows(random_actions<Real>(), kRows, kJoints, [&](In actions, Out angles, Statuses statuses) {
    return solver.solve({.count = kRows, .values = actions}, angles, statuses);
  });
  Observer<Real> observer(profile, {.pad_directions = true}, set);
  test::check_refused_rows(q, kRows, observer.size(), [&](In postures, Out observations, Statuses statuses) {
    return observer.observe_batch(postures, q, observations, statuses);
  });
  test::check_refused_rows(q, kRows, observer.size(), [&](In rates, Out observations, Statuses statuses) {
    return observer.observe_batch(q, rates, observations, statuses);
  });
  const FingertipKinematics<Real> kinematics(profile, set);
  test::check_refused_rows(q, kRows, 3 * kinematics.finger_count(), [&](In postures, Out tips, Statuses statuses) {
    return kinematics.fingertips_batch(postures, tips, statuses);
  });
}

template <class Real>
void check_narrow_calls() {
  const HandProfile profile = test::small_profile();
  const std::vector<Real> q = random_postures<Real>();
  using In = std::span<const Real>;
  using Out = std::span<Real>;
  using Statuses = std::span<Status>;
  Encoder<Real> encoder(profile);
  test::check_refused_rows(q, kRows, 15, [&](In postures, Out actions, Statuses statuses) {
    return encoder.encode_batch(postures, actions, {}, statuses);
  });
  Retargeter<Real> retargeter(profile, profile);
  test::check_refused_rows(q, kRows, kJoints, [&](In postures, Out angles, Statuses statuses) {
    return retargeter.retarget_batch(postures, angles, {}, statuses);
  });

  // so do the reports
  std::vector<Real> actions(2 * 15), two(q.begin(), q.begin() + 2 * kJoints);
  two[0] = std::numeric_limits<Real>::infinity();
  EncodeReport reports[2];
  for (EncodeReport& report : reports) report.residual_max = 7;
  CHECK(encoder.encode_batch(two, actions, reports) == Status::non_finite_input);
  CHECK(reports[0].residual_max == 7);
  CHECK(reports[1].residual_max < 7);
}

}  // namespace

TEST_CASE("a row that is refused hinders no other, on every instruction set") {
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2}) {
    if (!is_available(set)) {
      MESSAGE("SKIPPED: ", to_string(set), ", which this processor has not");
      continue;
    }
    check_wide_calls<double>(set);
    check_wide_calls<float>(set);
  }
}

TEST_CASE("a posture that cannot be encoded hinders no other") {
  check_narrow_calls<double>();
  check_narrow_calls<float>();
}

TEST_CASE("what all rows of a batch share refuses each of them; a row may be refused for more") {
  BatchSolver<double> solver(test::small_profile());
  std::vector<double> actions = random_actions<double>(), q(kRows * kJoints, 77.0);
  const std::vector<double> falling{2.0, 1.0};
  actions[15] = std::numeric_limits<double>::quiet_NaN();
  std::vector<Status> statuses(kRows, Status::ok);
  CHECK(solver.solve({.count = kRows, .values = actions, .driving_vectors_phi = falling}, q, statuses) ==
        Status::invalid_driving_vectors);
  CHECK(statuses[1] == Status::non_finite_input);
  CHECK(std::count(statuses.begin(), statuses.end(), Status::invalid_driving_vectors) == kRows - 1);
  CHECK(q == std::vector<double>(q.size(), 77.0));
}

TEST_CASE("statuses of another number are refused, and nothing is written") {
  const HandProfile profile = test::small_profile();
  const std::vector<double> q = random_postures<double>();
  std::vector<Status> few(kRows - 1, Status::unknown_hand);
  std::vector<double> out(kRows * 90, 77.0);
  const std::span<double> all(out);
  CHECK(Observer<double>(profile).observe_batch(q, q, all, few) == Status::wrong_size);
  CHECK(FingertipKinematics<double>(profile).fingertips_batch(q, all.first(kRows * 6), few) == Status::wrong_size);
  CHECK(Encoder<double>(profile).encode_batch(q, all.first(kRows * 15), {}, few) == Status::wrong_size);
  CHECK(Retargeter<double>(profile, profile).retarget_batch(q, all.first(q.size()), {}, few) == Status::wrong_size);
  CHECK(out == std::vector<double>(out.size(), 77.0));
  CHECK(few == std::vector<Status>(kRows - 1, Status::unknown_hand));
}
