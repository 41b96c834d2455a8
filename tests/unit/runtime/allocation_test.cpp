// The real-time path allocates nothing, failures included: malloc, which operator new calls, is counted
// over 10,000 calls.
#include <dlfcn.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>

#include "support/chains_profile.hpp"
#include "support/mirrored_profile.hpp"
#include "support/random_action.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_profile.hpp"
#include "uhas/c/uhas.h"
#include "uhas/profile_io/write_profile.hpp"
#include "uhas/runtime/batch_solver.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/deformation_field.hpp"
#include "uhas/runtime/differentiable_solver.hpp"
#include "uhas/runtime/fingertip_kinematics.hpp"
#include "uhas/runtime/observation.hpp"
#include "uhas/runtime/retarget.hpp"
#include "uhas/runtime/sphere_controller.hpp"

// the sanitizers bring a malloc of their own
#ifndef UHAS_SANITIZED

namespace {

std::atomic<bool> counting = false;  // on every thread
std::atomic<long> allocations = 0;

}  // namespace

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {  // which operator new calls for wide types
  static void* (*const next)(std::size_t, std::size_t) =
      reinterpret_cast<void* (*)(std::size_t, std::size_t)>(dlsym(RTLD_NEXT, "aligned_alloc"));
  if (counting) ++allocations;
  return next(alignment, size);
}

extern "C" void* malloc(std::size_t size) {
  static void* (*const next)(std::size_t) = reinterpret_cast<void* (*)(std::size_t)>(dlsym(RTLD_NEXT, "malloc"));
  if (counting) ++allocations;
  return next(size);
}

using namespace uhas;

TEST_CASE("counting sees operator new and malloc") {
  allocations = 0;
  counting = true;
  struct alignas(64) Wide {
    char bytes[64];
  };
  auto* volatile a = new int(1);
  auto* volatile wide = new Wide;
  void* volatile b = std::malloc(1);
  counting = false;
  delete a;
  delete wide;
  std::free(b);
  CHECK(allocations == 3);
}

TEST_CASE("10,000 walks allocate nothing: plain, with a report, differentiated and in batches") {
  CascadeSolver<double> solver(test::chains_profile());
  DifferentiableSolver<double> differentiable(test::chains_profile());
  BatchSolver<double> batch(test::chains_profile());
  constexpr std::size_t count = 100;
  std::vector<double> actions, q(count * solver.joint_count()), jacobian(15 * solver.joint_count());
  std::mt19937_64 random(5);
  for (std::size_t n = 0; n < count; ++n)
    for (double number : test::random_action(random, 1, n % 2 == 0 ? 0.5 : 2)) actions.push_back(number);
  allocations = 0;
  counting = true;
  Status worst = Status::ok;
  for (std::size_t n = 0; n < 10'000; ++n) {
    const Action<double> action{.values = std::span(actions).subspan(n % count * 15, 15)};
    const std::span<double> one = std::span(q).first(solver.joint_count());
    SolveReport report;
    worst = std::max({worst, solver.solve(action, one), solver.solve(action, one, report),
                      differentiable.solve_with_jacobian(action, one, jacobian)});
    if (n % count == 0) worst = std::max(worst, batch.solve({.count = count, .values = actions}, q));
  }
  counting = false;
  CHECK(allocations == 0);
  CHECK(worst == Status::ok);
}

TEST_CASE("10,000 solves allocate nothing") {
  for (CascadeRule rule : {CascadeRule::correspondence, CascadeRule::contact}) {
    for (FieldReading field : {FieldReading::finger, FieldReading::field}) {
      CascadeSolver<double> solver(test::small_profile(),
                                   {.rule = rule, .closing = CascadeClosing::fade, .field = field, .passes = 3});
      std::vector<double> q(solver.joint_count());
      std::vector<std::uint8_t> at_limit(q.size()), closed(q.size());
      SolveReport report{.residual_rms = 0, .at_limit = at_limit, .closed = closed};
      std::mt19937_64 random(5);
      std::vector<std::vector<double>> actions;
      for (int n = 0; n < 100; ++n) actions.push_back(test::random_action(random, 1, 3));
      actions[3][2] = std::numeric_limits<double>::quiet_NaN();
      actions[4].pop_back();
      int refused = 0;
      allocations = 0;
      counting = true;
      for (int n = 0; n < 2500; ++n) refused += solver.solve({.values = actions[n % 100]}, q, report) != Status::ok;
      counting = false;
      CHECK(allocations == 0);
      CHECK(refused == 50);
    }
  }
}

TEST_CASE("10,000 deformed spheres allocate nothing") {
  DeformationField field(test::small_profile());
  std::mt19937_64 random(6);
  std::vector<double> action = test::random_action(random, 1, 3);
  std::vector<Spherical<double>> points(10, {1, 1, 1});
  int refused = 0;
  allocations = 0;
  counting = true;
  for (int n = 0; n < 10'000; ++n) {
    action[3] = n % 5 == 4 ? std::numeric_limits<double>::infinity() : 0.1;
    refused += field.deform({.values = action}, points) != Status::ok;
  }
  counting = false;
  CHECK(allocations == 0);
  CHECK(refused == 2000);
}

TEST_CASE("10,000 batches allocate nothing on any thread") {
  const std::vector<HandProfile> hands{test::small_profile(), test::mirror_image(test::small_profile())};
  std::mt19937_64 random(7);
  constexpr std::size_t kRows = 21;
  std::vector<float> values, q(kRows * 5);
  std::vector<int> hand_of_row;
  for (std::size_t i = 0; i < kRows; ++i) {
    for (double x : test::random_action(random, 1, 3)) values.push_back(static_cast<float>(x));
    hand_of_row.push_back(static_cast<int>(i % 2));
  }
  std::vector<float> poisoned = values;
  poisoned[100] = std::numeric_limits<float>::quiet_NaN();
  std::vector<Status> statuses(kRows);
  for (InstructionSet set : {InstructionSet::scalar, InstructionSet::baseline, InstructionSet::avx2}) {
    if (!is_available(set)) continue;
    for (int threads : {1, 2}) {
      BatchSolver<float> solver(hands, {}, {.threads = threads, .instruction_set = set});
      int refused = 0;
      allocations = 0;
      counting = true;
      for (int n = 0; n < 10'000; ++n)
        refused += solver.solve({.count = n % 5 == 4 ? kRows + 1 : kRows,
                                 .values = n % 5 == 3 ? poisoned : values,
                                 .hands = hand_of_row},
                                q, statuses) != Status::ok;
      counting = false;
      CHECK(allocations == 0);
      CHECK(refused == 4000);
    }
  }
}

TEST_CASE("10,000 observations allocate nothing") {
  Observer<double> observer(test::small_profile(), {.pad_directions = true});
  const std::size_t joints = observer.joint_count();
  std::vector<double> q(4 * joints, 0.1), qd(q.size(), 1.0), observations(4 * observer.size());
  std::vector<double> not_finite = q;
  not_finite.front() = std::numeric_limits<double>::quiet_NaN();
  const std::span one_q(q.data(), joints), one_qd(qd.data(), joints), one(observations.data(), observer.size());
  int refused = 0;
  allocations = 0;
  counting = true;
  for (int n = 0; n < 2500; ++n) {
    refused += observer.observe(one_q, one_qd, one) != Status::ok;
    refused += observer.observe(one_q, qd, one) != Status::ok;
    refused += observer.observe_batch(q, qd, observations) != Status::ok;
    refused += observer.observe_batch(not_finite, qd, observations) != Status::ok;
  }
  counting = false;
  CHECK(allocations == 0);
  CHECK(refused == 5000);
}

TEST_CASE("10,000 forward kinematics allocate nothing") {
  const FingertipKinematics<float> kinematics(test::small_profile());
  std::vector<float> q(20 * kinematics.joint_count(), 0.1f), fingertips(20 * 3 * kinematics.finger_count());
  std::vector<float> not_finite = q;
  not_finite.front() = std::numeric_limits<float>::quiet_NaN();
  const std::span one_q(q.data(), kinematics.joint_count()), one(fingertips.data(), 3 * kinematics.finger_count());
  int refused = 0;
  allocations = 0;
  counting = true;
  for (int n = 0; n < 2500; ++n) {
    refused += kinematics.fingertips(one_q, one) != Status::ok;
    refused += kinematics.fingertips(q, one) != Status::ok;
    refused += kinematics.fingertips_batch(q, fingertips) != Status::ok;
    refused += kinematics.fingertips_batch(not_finite, fingertips) != Status::ok;
  }
  counting = false;
  CHECK(allocations == 0);
  CHECK(refused == 5000);
}

TEST_CASE("encoding and retargeting allocate nothing") {
  const HandProfile profile = test::small_profile();
  Retargeter<double> retargeter(profile, profile);
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(-1, 2);  // postures off the manifold and beyond the limits
  std::vector<double> postures(5 * 100), q(5), batch(5 * 10);
  for (double& value : postures) value = unit(random);
  postures[5 * 3] = std::numeric_limits<double>::infinity();
  std::vector<EncodeReport> reports(10);
  int refused = 0;
  allocations = 0;
  counting = true;
  for (int n = 0; n < 1000; ++n) {
    const std::span<const double> posture = std::span(postures).subspan(5 * (n % 100), n % 100 == 4 ? 4 : 5);
    refused += retargeter.retarget(posture, q, reports[0]) != Status::ok;
  }
  for (int n = 0; n < 10; ++n)
    refused += retargeter.retarget_batch(std::span(postures).subspan(50 * n, 50), batch, reports) != Status::ok;
  counting = false;
  CHECK(allocations == 0);
  CHECK(refused == 21);
}

TEST_CASE("10,000 control periods allocate nothing") {
  SphereController<double> controller(test::small_profile(), {.range_scale = 0.9, .time_constant = 0.1});
  std::mt19937_64 random(7);
  std::vector<std::vector<double>> actions;
  for (int n = 0; n < 100; ++n) actions.push_back(test::random_action(random, 1, 3));
  actions[3][2] = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> targets(controller.joint_count());
  int refused = 0;
  allocations = 0;
  counting = true;
  for (int n = 0; n < 10000; ++n) {
    if (n % 1000 == 0) refused += controller.reset(targets, targets) != Status::ok;
    refused += controller.update({.values = actions[n % 100], .driving_vectors_phi = {}}, n % 100 == 4 ? 0 : 0.01,
                                 targets) != Status::ok;
  }
  counting = false;
  CHECK(allocations == 0);
  CHECK(refused == 200);
}

TEST_CASE("10,000 calls from C allocate nothing") {
  test::ScratchFolder folder;
  write_profile(test::small_profile(), folder.file("small.h5"));
  uhas_profile* profile = nullptr;
  uhas_solver* solver = nullptr;
  REQUIRE(uhas_profile_load(folder.file("small.h5").c_str(), &profile, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_solver_create(profile, nullptr, &solver, nullptr, 0) == UHAS_OK);
  std::mt19937_64 random(8);
  std::vector<double> action = test::random_action(random, 1, 1), q(5);
  const double angles[] = {1, 2};
  uhas_action_options options = UHAS_ACTION_OPTIONS_INIT;
  options.driving_vectors_phi = angles, options.driving_vectors_size = 2;
  int refused = 0;
  allocations = 0;
  counting = true;
  for (int n = 0; n < 10000; ++n)
    refused +=
        uhas_solver_solve(solver, action.data(), n % 10 ? 15 : 14, &options, q.data(), 5, nullptr, nullptr) != UHAS_OK;
  counting = false;
  CHECK(allocations == 0);
  CHECK(refused == 1000);
  uhas_solver_free(solver);
  uhas_profile_free(profile);
}

#endif
