// Batches against single solves: every instruction set, any number of threads, mixed hands, rows that are refused.
#include "uhas/runtime/batch_solver.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <system_error>
#include <utility>
#include <vector>

#include "support/address_space_limit.hpp"
#include "support/arch_profile.hpp"
#include "support/mirrored_profile.hpp"
#include "support/random_action.hpp"
#include "support/small_profile.hpp"

using namespace uhas;

namespace {

std::vector<InstructionSet> available_sets() {
  std::vector<InstructionSet> sets;
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2})
    if (is_available(set)) sets.push_back(set);
  return sets;
}

/// N random actions in rows, and driving angles for each row that differ from the default by up to 15 degrees.
template <class Real>
struct RandomRows {
  RandomRows(std::size_t n, int v, double r, std::uint64_t seed) : count(n), vectors(v) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (std::size_t i = 0; i < n; ++i) {
      for (double x : test::random_action(random, 0.6, r, v)) values.push_back(static_cast<Real>(x));
      for (int k = 0; k < kSlotCount * v; ++k) {
        const double spread = std::min(std::numbers::pi / 12, 0.4 * std::numbers::pi / (v + 1));
        phi.push_back(static_cast<Real>(std::numbers::pi * (1 + k % v) / (v + 1) + spread * unit(random)));
      }
    }
  }

  std::size_t count;
  int vectors;
  std::vector<Real> values, phi;  // [count][5 + 5 V], [count][5 V]

  ActionBatch<Real> batch(bool own_angles) const {
    ActionBatch<Real> all{.count = count, .values = values, .driving_vectors = vectors};
    if (own_angles) all.driving_vectors_phi = phi, all.phi_per_row = true;
    return all;
  }
  Action<Real> row(std::size_t i, bool own_angles) const {
    const std::size_t size = kSlotCount * (1 + vectors), angles = kSlotCount * vectors;
    Action<Real> action{.values = std::span(values).subspan(i * size, size)};
    if (own_angles) action.driving_vectors_phi = std::span(phi).subspan(i * angles, angles);
    return action;
  }
};

/// Largest difference between a batch and the same rows solved one by one.
template <class Real>
double difference(const HandProfile& profile, const SolveOptions& options, InstructionSet set,
                  const RandomRows<Real>& rows, bool own_angles) {
  CascadeSolver<Real> single(profile, options);
  BatchSolver<Real> solver(profile, options, {.threads = 1, .instruction_set = set});
  const std::size_t joints = single.joint_count();
  std::vector<Real> q(rows.count * joints), one(joints);
  REQUIRE(solver.solve(rows.batch(own_angles), q) == Status::ok);
  double largest = 0;
  for (std::size_t i = 0; i < rows.count; ++i) {
    REQUIRE(single.solve(rows.row(i, own_angles), one) == Status::ok);
    for (std::size_t k = 0; k < joints; ++k) largest = std::max(largest, double(std::abs(q[i * joints + k] - one[k])));
  }
  return largest;
}

template <class Real>
constexpr double kTolerance = std::is_same_v<Real, float> ? 1e-4 : 1e-10;

template <class Real>
std::vector<Real> solve_all(BatchSolver<Real>& solver, const ActionBatch<Real>& batch) {
  std::vector<Real> q(batch.count * solver.widest_joint_count(), Real(77));
  REQUIRE(solver.solve(batch, q) == Status::ok);
  return q;
}

}  // namespace

TEST_CASE_TEMPLATE("a batch solves what single solves do, on every instruction set", Real, float, double) {
  const HandProfile left = test::small_profile();
  const HandProfile hands[] = {left, test::mirror_image(left), test::arch_profile()};
  for (InstructionSet set : available_sets()) {
    CAPTURE(to_string(set));
    for (std::size_t h = 0; h < 3; ++h) {
      CAPTURE(h);
      for (double bound : {0.5, 2.0}) {
        CAPTURE(bound);
        for (bool own_angles : {false, true})
          for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors) {
            CAPTURE(own_angles);
            CAPTURE(vectors);
            const RandomRows<Real> rows(203, vectors, bound, 5);
            CHECK(difference(hands[h], {}, set, rows, own_angles) <= kTolerance<Real>);
          }
      }
    }
  }
}

TEST_CASE("every option can be solved in batches") {
  for (InstructionSet set : available_sets())
    for (CascadeRule rule : {CascadeRule::correspondence, CascadeRule::contact})
      for (CascadeClosing closing : {CascadeClosing::fade, CascadeClosing::hard})
        for (FieldReading field : {FieldReading::finger, FieldReading::field})
          for (int passes : {1, 3}) {
            CAPTURE(to_string(set));
            const RandomRows<double> rows(101, 2, 2.0, 6);
            CHECK(difference(test::small_profile(), {rule, closing, field, passes}, set, rows, false) <= 1e-10);
          }
}

TEST_CASE("a row's result depends on no other row and on no number of threads") {
  const RandomRows<float> rows(1000, 2, 2.0, 7);
  for (InstructionSet set : available_sets()) {
    CAPTURE(to_string(set));
    BatchSolver<float> solver(test::small_profile(), {}, {.threads = 1, .instruction_set = set});
    const std::vector<float> all = solve_all(solver, rows.batch(true));
    const std::size_t joints = solver.joint_count();

    for (int threads : {2, 5}) {
      BatchSolver<float> crew(test::small_profile(), {}, {.threads = threads, .instruction_set = set});
      for (int again = 0; again < 3; ++again) CHECK(solve_all(crew, rows.batch(true)) == all);
    }
    for (std::size_t count = 0; count < 20; ++count) {  // lanes left over
      ActionBatch<float> few = rows.batch(true);
      few.count = count;
      few.driving_vectors_phi = few.driving_vectors_phi.first(count * 10);
      const std::vector<float> q = solve_all(solver, few);
      CHECK(std::equal(q.begin(), q.end(), all.begin()));
    }
    RandomRows<float> backwards = rows;
    for (std::size_t i = 0; i < rows.count; ++i) {
      std::copy_n(rows.values.begin() + 15 * i, 15, backwards.values.begin() + 15 * (rows.count - 1 - i));
      std::copy_n(rows.phi.begin() + 10 * i, 10, backwards.phi.begin() + 10 * (rows.count - 1 - i));
    }
    const std::vector<float> reversed = solve_all(solver, backwards.batch(true));
    bool same = true;
    for (std::size_t i = 0; i < rows.count; ++i)
      same &= std::equal(all.begin() + joints * i, all.begin() + joints * (i + 1),
                         reversed.begin() + joints * (rows.count - 1 - i));
    CHECK(same);
  }
}

TEST_CASE("a mixed set of hands: each row is solved for its own") {
  const std::vector<HandProfile> hands{test::small_profile(), test::arch_profile(),
                                       test::mirror_image(test::small_profile())};
  const RandomRows<double> rows(500, 2, 2.0, 8);
  std::vector<int> hand_of_row;
  for (std::size_t i = 0; i < rows.count; ++i) hand_of_row.push_back(int((i * i + i / 7) % 3));
  for (int threads : {1, 3}) {
    BatchSolver<double> solver(hands, {}, {.threads = threads});
    CHECK(solver.hand_count() == 3);
    CHECK(solver.joint_count(1) == 3);
    CHECK(solver.widest_joint_count() == 5);
    ActionBatch<double> batch = rows.batch(false);
    batch.hands = hand_of_row;
    const std::vector<double> q = solve_all(solver, batch);
    for (int h = 0; h < 3; ++h) {
      BatchSolver<double> alone(hands[h]);
      const std::size_t joints = alone.joint_count();
      const std::vector<double> expected = solve_all(alone, rows.batch(false));
      for (std::size_t i = 0; i < rows.count; ++i) {
        if (hand_of_row[i] != h) continue;
        REQUIRE(std::equal(expected.begin() + joints * i, expected.begin() + joints * (i + 1), q.begin() + 5 * i));
        for (std::size_t k = joints; k < 5; ++k) REQUIRE(q[5 * i + k] == 77);  // past the hand's joints: untouched
      }
    }
  }
}

TEST_CASE("a refused row is left untouched and named; the others are solved") {
  RandomRows<double> rows(50, 2, 1.0, 9);
  std::vector<int> hand_of_row(50, 0);
  rows.values[15 * 13 + 4] = std::numeric_limits<double>::quiet_NaN();
  rows.values[15 * 49] = std::numeric_limits<double>::infinity();
  std::swap(rows.phi[10 * 20], rows.phi[10 * 20 + 1]);
  hand_of_row[30] = 1;
  hand_of_row[31] = -1;
  for (InstructionSet set : available_sets()) {
    for (int threads : {1, 2}) {
      BatchSolver<double> solver(test::small_profile(), {}, {.threads = threads, .instruction_set = set});
      ActionBatch<double> batch = rows.batch(true);
      batch.hands = hand_of_row;
      std::vector<double> q(50 * 5, 77.0), one(5);
      std::vector<Status> statuses(50, Status::wrong_size);
      CHECK(solver.solve(batch, q, statuses) == Status::non_finite_input);
      CHECK(solver.solve(batch, q) == Status::non_finite_input);
      CascadeSolver<double> single(test::small_profile());
      for (std::size_t i = 0; i < 50; ++i) {
        CAPTURE(i);
        const Status expected = i == 30 || i == 31 ? Status::unknown_hand : single.solve(rows.row(i, true), one);
        CHECK(statuses[i] == expected);
        for (std::size_t k = 0; k < 5; ++k)
          CHECK(q[5 * i + k] == (expected == Status::ok ? doctest::Approx(one[k]).epsilon(1e-9) : doctest::Approx(77)));
      }
    }
  }
}

TEST_CASE("rows may stand apart in input and output") {
  const RandomRows<float> rows(37, 2, 2.0, 10);
  BatchSolver<float> solver(test::small_profile());
  const std::vector<float> dense = solve_all(solver, rows.batch(false));
  std::vector<float> apart(37 * 20 - 5, 1e30f), q(37 * 9 - 4, 77.0f);
  for (std::size_t i = 0; i < 37; ++i) std::copy_n(rows.values.begin() + 15 * i, 15, apart.begin() + 20 * i);
  CHECK(solver.solve({.count = 37, .values = apart, .stride = 20}, q, {}, 9) == Status::ok);
  for (std::size_t i = 0; i < q.size(); ++i) CHECK(q[i] == (i % 9 < 5 ? dense[5 * (i / 9) + i % 9] : 77.0f));
}

TEST_CASE("normalised actions and angles for all rows") {
  RandomRows<double> rows(40, 2, 1.0, 11);
  const std::vector<double> phi{0.9, 1.9};
  for (InstructionSet set : available_sets()) {
    BatchSolver<double> solver(test::small_profile(), {}, {.threads = 1, .instruction_set = set});
    ActionBatch<double> batch = rows.batch(false);
    batch.normalized = true;
    batch.driving_vectors_phi = phi;
    const std::vector<double> q = solve_all(solver, batch);
    CascadeSolver<double> single(test::small_profile());
    std::vector<double> one(5);
    for (std::size_t i = 0; i < rows.count; ++i) {
      Action<double> action = rows.row(i, false);
      action.normalized = true;
      action.driving_vectors_phi = phi;
      REQUIRE(single.solve(action, one) == Status::ok);
      for (std::size_t k = 0; k < 5; ++k) CHECK(q[5 * i + k] == doctest::Approx(one[k]).epsilon(1e-9));
    }
  }
}

TEST_CASE("azimuth offsets and radial bounds, for all rows or for each") {
  const RandomRows<double> rows(40, 2, 2.0, 13);
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> offsets(40 * 5), bounds(40 * 2);
  for (double& offset : offsets) offset = 0.2 * unit(random) - 0.1;
  for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i] = i % 2 == 0 ? -2 * unit(random) : 2 * unit(random);
  CascadeSolver<double> single(test::small_profile());
  std::vector<double> one(5);
  for (InstructionSet set : available_sets()) {
    BatchSolver<double> solver(test::small_profile(), {}, {.threads = 2, .instruction_set = set});
    for (bool per_row : {false, true}) {
      ActionBatch<double> batch = rows.batch(false);
      batch.azimuth_offsets = std::span<const double>(offsets).first(per_row ? 200 : 5);
      batch.radial_bounds = std::span<const double>(bounds).first(per_row ? 80 : 2);
      const std::vector<double> q = solve_all(solver, batch);
      for (std::size_t i = 0; i < rows.count; ++i) {
        Action<double> action = rows.row(i, false);
        action.azimuth_offsets = std::span<const double>(offsets).subspan(per_row ? 5 * i : 0, 5);
        action.radial_bounds = std::span<const double>(bounds).subspan(per_row ? 2 * i : 0, 2);
        REQUIRE(single.solve(action, one) == Status::ok);
        for (std::size_t k = 0; k < 5; ++k) CHECK(q[5 * i + k] == doctest::Approx(one[k]).epsilon(1e-9));
      }
    }
  }
  bounds[2 * 7] = 0.1;
  std::vector<double> q(200);
  std::vector<Status> statuses(40);
  BatchSolver<double> solver(test::small_profile());
  ActionBatch<double> batch = rows.batch(false);
  batch.radial_bounds = bounds;
  CHECK(solver.solve(batch, q, statuses) == Status::invalid_radial_bounds);
  CHECK(std::count(statuses.begin(), statuses.end(), Status::ok) == 39);
  CHECK(statuses[7] == Status::invalid_radial_bounds);
}

TEST_CASE("what cannot be a batch is refused whole, and nothing is written") {
  const RandomRows<double> rows(10, 2, 1.0, 12);
  BatchSolver<double> solver(test::small_profile());
  std::vector<double> q(50, 77.0);
  const std::vector<double> falling{2.0, 1.0};
  const std::vector<int> nine_hands(9, 0);
  std::vector<Status> nine(9);
  const std::span<double> all(q);
  const auto changed = [&](auto change) {
    ActionBatch<double> batch = rows.batch(false);
    change(batch);
    return solver.solve(batch, all);
  };
  CHECK(changed([](auto& batch) { batch.count = 11; }) == Status::wrong_size);
  CHECK(changed([](auto& batch) { batch.driving_vectors = 3; }) == Status::wrong_size);
  CHECK(changed([](auto& batch) { batch.driving_vectors = 0; }) == Status::wrong_size);
  CHECK(changed([](auto& batch) { batch.driving_vectors = 5; }) == Status::wrong_size);
  CHECK(changed([](auto& batch) { batch.stride = 14; }) == Status::wrong_size);
  CHECK(changed([](auto& batch) { batch.stride = 16; }) == Status::wrong_size);
  CHECK(changed([](auto& batch) { batch.count = std::numeric_limits<std::size_t>::max(); }) == Status::wrong_size);
  CHECK(changed([&](auto& batch) { batch.hands = nine_hands; }) == Status::wrong_size);
  CHECK(changed([&](auto& batch) { batch.driving_vectors_phi = falling; }) == Status::invalid_driving_vectors);
  CHECK(changed([&](auto& batch) { batch.driving_vectors_phi = falling, batch.phi_per_row = true; }) ==
        Status::wrong_size);
  CHECK(solver.solve(rows.batch(false), all.first(49)) == Status::wrong_size);
  CHECK(solver.solve(rows.batch(false), all, {}, 4) == Status::wrong_size);
  CHECK(solver.solve(rows.batch(false), all, nine) == Status::wrong_size);
  CHECK(std::all_of(q.begin(), q.end(), [](double x) { return x == 77.0; }));
}

TEST_CASE("a batch solver tells how many hands it solves at once") {
  const HandProfile profile = test::small_profile();
  const auto lanes = [&](auto real, InstructionSet set) {
    return BatchSolver<decltype(real)>(profile, {}, {.instruction_set = set}).lanes();
  };
  CHECK(lanes(0.0, InstructionSet::scalar) == 1);
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2}) {
    if (!is_available(set)) continue;
    CHECK(lanes(0.0, set) > 1);
    CHECK(lanes(0.0f, set) == 2 * lanes(0.0, set));  // a register holds twice as many
  }
}

TEST_CASE("a batch solver may be moved") {
  const HandProfile profile = test::small_profile();
  BatchSolver<double> made(profile), moved(std::move(made)), assigned(test::arch_profile());
  const std::vector<double> actions(2 * 15, 0.1);
  std::vector<double> q(2 * 5), expected = q;
  REQUIRE(moved.solve({.count = 2, .values = actions}, expected) == Status::ok);
  assigned = std::move(moved);
  REQUIRE(assigned.solve({.count = 2, .values = actions}, q) == Status::ok);
  CHECK(q == expected);
}

#ifndef UHAS_SANITIZED
TEST_CASE("threads that cannot be started are an error, and those that were are ended") {
  const HandProfile profile = test::small_profile();
  {
    const test::AddressSpaceLimit room_for_few_stacks(6u << 20);
    CHECK_THROWS_AS(BatchSolver<double>(profile, {}, {.threads = 256}), std::system_error);
  }
  CHECK_NOTHROW(BatchSolver<double>(profile, {}, {.threads = 2}));
}
#endif

TEST_CASE("a batch solver that cannot be made says why") {
  const HandProfile profile = test::small_profile();
  CHECK_THROWS_AS(BatchSolver<float>(std::span<const HandProfile>{}), Error);
  CHECK_THROWS_AS(BatchSolver<float>(profile, {}, {.threads = 0}), Error);
  CHECK_THROWS_AS(BatchSolver<float>(profile, {}, {.threads = 257}), Error);
  CHECK_THROWS_WITH_AS(
      BatchSolver<float>(profile, {}, {.instruction_set = static_cast<InstructionSet>(1000)}),
      "instruction_set is unknown, which this machine or build has not; leave the choice to the library", Error);
  CHECK_THROWS_AS(BatchSolver<float>(profile, {.passes = 0}), Error);
}
