// uhas.h against the C++ that it wraps: the same numbers bit for bit, and every refusal a code.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "support/address_space_limit.hpp"
#include "support/arch_profile.hpp"
#include "support/random_action.hpp"
#include "support/refused_rows.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_profile.hpp"
#include "uhas/c/uhas.h"
#include "uhas/profile_io/write_profile.hpp"
#include "uhas/runtime/action.hpp"
#include "uhas/runtime/batch_solver.hpp"
#include "uhas/runtime/joint_groups.hpp"
#include "uhas/runtime/observation.hpp"
#include "uhas/runtime/retarget.hpp"
#include "uhas/runtime/sphere_controller.hpp"

extern "C" int solve_from_c(const uhas_profile* profile, double* q, size_t joints);

using namespace uhas;

namespace {

constexpr std::size_t kJoints = 5;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The small profile, by way of a file.
const uhas_profile* small_handle() {
  static uhas_profile* const handle = [] {
    test::ScratchFolder folder;
    const std::string path = folder.file("small.h5");
    write_profile(test::small_profile(), path);
    uhas_profile* loaded = nullptr;
    char message[256] = "";
    REQUIRE_MESSAGE(uhas_profile_load(path.c_str(), &loaded, message, sizeof message) == UHAS_OK, message);
    return loaded;
  }();
  return handle;
}

/// A handle that frees itself.
template <class Handle, auto free>
struct Owned {
  Handle* get = nullptr;
  ~Owned() { free(get); }
};
using OwnedSolver = Owned<uhas_solver, uhas_solver_free>;
using OwnedController = Owned<uhas_controller, uhas_controller_free>;
using OwnedObserver = Owned<uhas_observer, uhas_observer_free>;
using OwnedEncoder = Owned<uhas_encoder, uhas_encoder_free>;
using OwnedRetargeter = Owned<uhas_retargeter, uhas_retargeter_free>;

std::vector<double> random_actions(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<double> actions;
  for (std::size_t n = 0; n < count; ++n) {
    const std::vector<double> action = test::random_action(random, 0.4, 0.6);
    actions.insert(actions.end(), action.begin(), action.end());
  }
  return actions;
}

template <class Real>
std::vector<Real> solve_in_cpp(const std::vector<double>& actions) {
  CascadeSolver<Real> solver(test::small_profile());
  std::vector<Real> q(actions.size() / 15 * kJoints);
  for (std::size_t n = 0; n < actions.size() / 15; ++n) {
    const std::vector<Real> action(actions.begin() + 15 * n, actions.begin() + 15 * (n + 1));
    REQUIRE(solver.solve({.values = action, .driving_vectors_phi = {}}, std::span(q).subspan(kJoints * n, kJoints)) ==
            Status::ok);
  }
  return q;
}

}  // namespace

TEST_CASE("the profile answers what it was asked to hold") {
  const HandProfile profile = test::small_profile();
  const uhas_profile* handle = small_handle();
  CHECK(uhas_profile_hand(handle) == profile.hand);
  CHECK(uhas_profile_radius(handle) == profile.radius);
  REQUIRE(uhas_profile_joint_count(handle) == kJoints);
  double lower[kJoints], upper[kJoints], q[kJoints];
  CHECK(uhas_profile_joint_limits(handle, lower, upper, kJoints) == UHAS_OK);
  CHECK(uhas_profile_reference_posture(handle, q, kJoints) == UHAS_OK);
  for (std::size_t i = 0; i < kJoints; ++i) {
    CHECK(uhas_profile_joint_name(handle, i) == profile.tree.joints[i].name);
    CHECK(lower[i] == profile.tree.joints[i].lower);
    CHECK(upper[i] == profile.tree.joints[i].upper);
    CHECK(q[i] == profile.joint_traits[i].q_sphere);
  }
  CHECK(uhas_profile_joint_name(handle, kJoints) == nullptr);
  CHECK(uhas_profile_joint_limits(handle, lower, upper, kJoints - 1) == UHAS_WRONG_SIZE);
  CHECK(uhas_profile_reference_posture(handle, nullptr, kJoints) == UHAS_WRONG_SIZE);
}

TEST_CASE("what cannot be set up has a code and one line of text, cut to the buffer") {
  uhas_profile* profile = reinterpret_cast<uhas_profile*>(1);
  char message[256] = "";
  CHECK(uhas_profile_load("/no/such/hand.h5", &profile, message, sizeof message) == UHAS_ERROR_FILE_UNREADABLE);
  CHECK(profile == nullptr);
  CHECK(std::string(message).starts_with("/no/such/hand.h5: "));
  CHECK(std::string(message).find('\n') == std::string::npos);

  char small[8] = "";
  CHECK(uhas_profile_load("/no/such/hand.h5", &profile, small, sizeof small) == UHAS_ERROR_FILE_UNREADABLE);
  CHECK(std::string(small) == "/no/suc");
  CHECK(uhas_profile_load("/n\u00f6", &profile, small, 4) == UHAS_ERROR_FILE_UNREADABLE);  // a character of two bytes
  CHECK(std::string(small) == "/n");
  CHECK(uhas_profile_load("/no/such/hand.h5", &profile, nullptr, 0) == UHAS_ERROR_FILE_UNREADABLE);
  CHECK(uhas_profile_load(nullptr, &profile, message, sizeof message) == UHAS_ERROR_INVALID_OPTION);
  CHECK(uhas_profile_load("/no/such/hand.h5", nullptr, message, sizeof message) == UHAS_ERROR_INVALID_OPTION);

  uhas_solver* solver = nullptr;
  const auto refuses = [&](const uhas_solve_options& options, int code) {
    CHECK(uhas_solver_create(small_handle(), &options, &solver, message, sizeof message) == code);
    CHECK(solver == nullptr);
  };
  CHECK(uhas_solver_create(nullptr, nullptr, &solver, message, sizeof message) == UHAS_ERROR_INVALID_OPTION);
  uhas_solve_options options = UHAS_SOLVE_OPTIONS_INIT;
  options.rule = 2;
  refuses(options, UHAS_ERROR_INVALID_OPTION);
  options = UHAS_SOLVE_OPTIONS_INIT;
  options.struct_size = sizeof options + 1;  // of a header to come
  refuses(options, UHAS_ERROR_INVALID_OPTION);
  options.struct_size = 0;
  refuses(options, UHAS_ERROR_INVALID_OPTION);

  uhas_controller_options controller_options = UHAS_CONTROLLER_OPTIONS_INIT;
  controller_options.range_scale = 2;
  uhas_controller* controller = nullptr;
  CHECK(uhas_controller_create(small_handle(), &controller_options, &controller, message, sizeof message) ==
        UHAS_ERROR_INVALID_OPTION);
  uhas_observation_options observation_options = UHAS_OBSERVATION_OPTIONS_INIT;
  observation_options.points = 1u << 7;
  uhas_observer* observer = nullptr;
  CHECK(uhas_observer_create(small_handle(), &observation_options, &observer, message, sizeof message) ==
        UHAS_ERROR_INVALID_OPTION);
}

TEST_CASE("options may be shorter than the library's: what is missing has its default") {
  uhas_solve_options options = UHAS_SOLVE_OPTIONS_INIT;
  options.passes = 0;                                          // would be refused
  options.struct_size = offsetof(uhas_solve_options, passes);  // is not read
  OwnedSolver solver;
  CHECK(uhas_solver_create(small_handle(), &options, &solver.get, nullptr, 0) == UHAS_OK);
}

TEST_CASE("solves are those of C++, in both precisions, one or many") {
  constexpr std::size_t count = 20;
  const std::vector<double> actions = random_actions(count, 1);
  const std::vector<float> actions_f(actions.begin(), actions.end());
  OwnedSolver solver;
  REQUIRE(uhas_solver_create(small_handle(), nullptr, &solver.get, nullptr, 0) == UHAS_OK);

  std::vector<double> q(count * kJoints), residual(count);
  std::vector<std::uint8_t> at_limit(q.size(), 7), closed(q.size(), 7);
  uhas_solve_report report = UHAS_SOLVE_REPORT_INIT;
  report.residual_rms = residual.data(), report.at_limit = at_limit.data(), report.closed = closed.data();
  REQUIRE(uhas_solver_solve(solver.get, actions.data(), actions.size(), nullptr, q.data(), q.size(), &report,
                            nullptr) == UHAS_OK);
  CHECK(q == solve_in_cpp<double>(actions));
  CHECK(std::count(at_limit.begin(), at_limit.end(), 7) + std::count(closed.begin(), closed.end(), 7) == 0);
  for (double value : residual) CHECK(value > 0);

  std::vector<float> q_f(q.size());
  REQUIRE(uhas_solver_solve_f(solver.get, actions_f.data(), actions.size(), nullptr, q_f.data(), q_f.size(), nullptr,
                              nullptr) == UHAS_OK);
  CHECK(q_f == solve_in_cpp<float>(actions));
}

TEST_CASE("the bounds of actions are those of C++, and a report tells of a number beyond them") {
  OwnedSolver solver;
  uhas_solve_options options = UHAS_SIM_SOLVE_OPTIONS_INIT;
  options.driving_vectors = 3;
  REQUIRE(uhas_solver_create(small_handle(), &options, &solver.get, nullptr, 0) == UHAS_OK);
  std::vector<double> lower(20), upper(20);
  REQUIRE(uhas_solver_action_bounds(solver.get, lower.data(), upper.data(), 20) == UHAS_OK);
  const ActionBounds expected = action_bounds(test::small_profile(), 3, kUhasSim.convention);
  CHECK(lower == expected.lower);
  CHECK(upper == expected.upper);
  CHECK(uhas_solver_action_bounds(solver.get, lower.data(), upper.data(), 15) == UHAS_WRONG_SIZE);
  CHECK(uhas_solver_action_bounds(nullptr, lower.data(), upper.data(), 20) == UHAS_WRONG_SIZE);
  CHECK(uhas_solver_action_bounds(solver.get, nullptr, upper.data(), 20) == UHAS_WRONG_SIZE);

  std::vector<double> actions(40, 0.0), q(2 * kJoints);
  actions[20 + 7] = 2.5;
  std::vector<std::uint8_t> clamped(2, 7);
  uhas_solve_report report = UHAS_SOLVE_REPORT_INIT;
  report.clamped = clamped.data();
  REQUIRE(uhas_solver_solve(solver.get, actions.data(), actions.size(), nullptr, q.data(), q.size(), &report,
                            nullptr) == UHAS_OK);
  CHECK(clamped == std::vector<std::uint8_t>{0, 1});
}

TEST_CASE("a C program solves, with options of every kind") {
  std::vector<double> q(kJoints), expected(kJoints);
  REQUIRE(solve_from_c(small_handle(), q.data(), q.size()) == UHAS_OK);
  CascadeSolver<double> solver(test::small_profile(), {.passes = 2});
  const std::vector<double> action{0.1, 0.1, 0.1, 0.1, 0, -0.2, -0.2, -0.2, -0.2, -0.2, -0.2, -0.2, -0.2, 0.1, 0.1};
  const std::vector<double> angles{1.0, 2.0};
  REQUIRE(solver.solve({.values = action, .driving_vectors_phi = angles}, expected) == Status::ok);
  CHECK(q == expected);
}

TEST_CASE("randomised action spaces and the other convention are those of C++, in single calls and in batches") {
  const std::vector<double> actions = random_actions(3, 5), offsets{0.05, -0.05, 0.1, 0.02, -0.03}, bounds{-0.4, 0.1};
  uhas_action_options action_options = UHAS_ACTION_OPTIONS_INIT;
  action_options.azimuth_offsets = offsets.data(), action_options.radial_bounds = bounds.data();
  const uhas_solve_options sim = UHAS_SIM_SOLVE_OPTIONS_INIT;
  for (const uhas_solve_options* solve_options : {static_cast<const uhas_solve_options*>(nullptr), &sim}) {
    CascadeSolver<double> expected(test::small_profile(), solve_options == nullptr ? kUhas : kUhasSim);
    OwnedSolver solver;
    REQUIRE(uhas_solver_create(small_handle(), solve_options, &solver.get, nullptr, 0) == UHAS_OK);
    const uhas_profile* profile = small_handle();
    uhas_batch* batch = nullptr;
    REQUIRE(uhas_batch_create(&profile, 1, solve_options, nullptr, &batch, nullptr, 0) == UHAS_OK);

    std::vector<double> q(3 * kJoints), q_batch(q.size()), q_expected(q.size());
    CHECK(uhas_solver_solve(solver.get, actions.data(), actions.size(), &action_options, q.data(), q.size(), nullptr,
                            nullptr) == UHAS_OK);
    CHECK(uhas_batch_solve(batch, actions.data(), actions.size(), &action_options, nullptr, q_batch.data(),
                           q_batch.size(), nullptr) == UHAS_OK);
    for (std::size_t n = 0; n < 3; ++n)
      REQUIRE(
          expected.solve(
              {.values = std::span(actions).subspan(15 * n, 15), .azimuth_offsets = offsets, .radial_bounds = bounds},
              std::span(q_expected).subspan(kJoints * n, kJoints)) == Status::ok);
    CHECK(q == q_expected);
    for (std::size_t i = 0; i < q.size(); ++i) CHECK(std::abs(q_batch[i] - q_expected[i]) < 1e-10);
    uhas_batch_free(batch);
  }
  const double wrong[2] = {0.1, 0.2};
  action_options.radial_bounds = wrong;
  OwnedSolver solver;
  REQUIRE(uhas_solver_create(small_handle(), nullptr, &solver.get, nullptr, 0) == UHAS_OK);
  std::vector<double> q(3 * kJoints);
  CHECK(uhas_solver_solve(solver.get, actions.data(), actions.size(), &action_options, q.data(), q.size(), nullptr,
                          nullptr) == UHAS_INVALID_RADIAL_BOUNDS);
}

TEST_CASE("what a solve is refused for leaves every output as it was") {
  OwnedSolver solver;
  REQUIRE(uhas_solver_create(small_handle(), nullptr, &solver.get, nullptr, 0) == UHAS_OK);
  std::vector<double> actions = random_actions(2, 2), q(3 * kJoints, 7.0);
  const auto solve = [&](std::size_t actions_size, std::size_t q_size, const uhas_action_options* options) {
    return uhas_solver_solve(solver.get, actions.data(), actions_size, options, q.data(), q_size, nullptr, nullptr);
  };
  CHECK(solve(30, 9, nullptr) == UHAS_WRONG_SIZE);
  CHECK(solve(29, 10, nullptr) == UHAS_WRONG_SIZE);
  CHECK(solve(24, 10, nullptr) == UHAS_WRONG_SIZE);
  CHECK(solve(15, 10, nullptr) == UHAS_WRONG_SIZE);
  CHECK(uhas_solver_solve(nullptr, actions.data(), 30, nullptr, q.data(), 10, nullptr, nullptr) == UHAS_WRONG_SIZE);
  CHECK(uhas_solver_solve(solver.get, nullptr, 30, nullptr, q.data(), 10, nullptr, nullptr) == UHAS_WRONG_SIZE);
  CHECK(uhas_solver_solve(solver.get, actions.data(), 30, nullptr, nullptr, 10, nullptr, nullptr) == UHAS_WRONG_SIZE);
  const double falling[2] = {2.0, 1.0};
  uhas_action_options options = UHAS_ACTION_OPTIONS_INIT;
  options.driving_vectors_phi = falling, options.driving_vectors_size = 2;
  CHECK(solve(30, 10, &options) == UHAS_INVALID_DRIVING_VECTORS);
  options.driving_vectors_size = 1000;
  CHECK(solve(30, 10, &options) == UHAS_WRONG_SIZE);
  options.struct_size = 1000;
  CHECK(solve(30, 10, &options) == UHAS_WRONG_SIZE);
  CHECK(solve(30, 15, nullptr) == UHAS_WRONG_SIZE);  // not three actions of one driving vector
  const double bounds[2] = {-1.0, 0.5};
  options = UHAS_ACTION_OPTIONS_INIT;
  options.radial_bounds = bounds, options.driving_vectors_size = 2;  // of no array
  CHECK(solve(30, 10, &options) == UHAS_WRONG_SIZE);
  CHECK(std::all_of(q.begin(), q.end(), [](double value) { return value == 7.0; }));
  CHECK(solve(0, 0, nullptr) == UHAS_OK);
}

TEST_CASE("the controller moves rows of hands as C++ moves one, and holds the one that is refused") {
  const HandProfile profile = test::small_profile();
  uhas_controller_options options = UHAS_CONTROLLER_OPTIONS_INIT;
  options.velocity_scale = 0.5, options.range_scale = 0.9, options.time_constant = 0.1;
  OwnedController controller;
  REQUIRE(uhas_controller_create(small_handle(), &options, &controller.get, nullptr, 0) == UHAS_OK);
  SphereController<double> expected(profile, {.velocity_scale = 0.5, .range_scale = 0.9, .time_constant = 0.1});

  std::vector<double> start = reference_posture(profile), targets(2 * kJoints), one = start, other = start;
  start.insert(start.end(), one.begin(), one.end());
  REQUIRE(uhas_controller_reset(controller.get, start.data(), 10, targets.data(), 10, nullptr) == UHAS_OK);
  for (unsigned tick = 0; tick < 20; ++tick) {
    std::vector<double> actions = random_actions(2, tick);
    if (tick == 7) actions[3] = kNan;
    const int status =
        uhas_controller_update(controller.get, actions.data(), 30, nullptr, 0.01, targets.data(), 10, nullptr);
    CHECK(status == (tick == 7 ? UHAS_NON_FINITE_INPUT : UHAS_OK));
    expected.update({.values = std::span(actions).first(15), .driving_vectors_phi = {}}, 0.01, one);
    expected.update({.values = std::span(actions).last(15), .driving_vectors_phi = {}}, 0.01, other);
    CHECK(std::equal(one.begin(), one.end(), targets.begin()));
    CHECK(std::equal(other.begin(), other.end(), targets.begin() + kJoints));
  }
  const std::vector<double> held = targets, action = random_actions(2, 1);
  CHECK(uhas_controller_update(controller.get, action.data(), 30, nullptr, 0, targets.data(), 10, nullptr) ==
        UHAS_INVALID_PERIOD);
  CHECK(uhas_controller_reset(controller.get, start.data(), 10, targets.data(), 5, nullptr) == UHAS_WRONG_SIZE);
  CHECK(targets == held);

  std::vector<float> start_f(kJoints, 0.1f), targets_f(kJoints);
  const std::vector<float> action_f(15, -0.1f);
  REQUIRE(uhas_controller_reset_f(controller.get, start_f.data(), kJoints, targets_f.data(), kJoints, nullptr) ==
          UHAS_OK);
  REQUIRE(uhas_controller_update_f(controller.get, action_f.data(), 15, nullptr, 0.01f, targets_f.data(), kJoints,
                                   nullptr) == UHAS_OK);
  SphereController<float> expected_f(profile, {.velocity_scale = 0.5, .range_scale = 0.9, .time_constant = 0.1});
  std::vector<float> one_f(kJoints);
  expected_f.reset(start_f, one_f);
  expected_f.update({.values = action_f, .driving_vectors_phi = {}}, 0.01f, one_f);
  CHECK(targets_f == one_f);
}

TEST_CASE("a controller approaches solutions as C++ does") {
  OwnedController controller;
  REQUIRE(uhas_controller_create(small_handle(), nullptr, &controller.get, nullptr, 0) == UHAS_OK);
  SphereController<double> in_cpp(test::small_profile());
  const std::vector<double> solutions = solve_in_cpp<double>(random_actions(2, 8));
  std::vector<double> targets(2 * kJoints), expected = targets;
  REQUIRE(uhas_controller_approach(controller.get, solutions.data(), 10, 0.01, targets.data(), 10, nullptr) == UHAS_OK);
  for (std::size_t n = 0; n < 2; ++n)
    in_cpp.approach(std::span(solutions).subspan(kJoints * n, kJoints), 0.01,
                    std::span(expected).subspan(kJoints * n, kJoints));
  CHECK(targets == expected);
  const std::vector<float> solution_f(solutions.begin(), solutions.begin() + kJoints);
  std::vector<float> target_f(kJoints), expected_f = target_f;
  REQUIRE(uhas_controller_approach_f(controller.get, solution_f.data(), kJoints, 0.01f, target_f.data(), kJoints,
                                     nullptr) == UHAS_OK);
  SphereController<float>(test::small_profile()).approach(solution_f, 0.01f, expected_f);
  CHECK(target_f == expected_f);
  CHECK(uhas_controller_approach(controller.get, solutions.data(), 5, 0.01, targets.data(), 10, nullptr) ==
        UHAS_WRONG_SIZE);
  CHECK(uhas_controller_approach(controller.get, solutions.data(), 10, -1, targets.data(), 10, nullptr) ==
        UHAS_INVALID_PERIOD);
  CHECK(targets == expected);
}

#ifndef UHAS_SANITIZED
TEST_CASE("what the system refuses is an error with the words of the system") {
  const uhas_profile* profile = small_handle();
  uhas_batch_options options = UHAS_BATCH_OPTIONS_INIT;
  options.threads = 256;
  uhas_batch* batch = nullptr;
  char message[128] = "";
  {
    const test::AddressSpaceLimit room_for_few_stacks(6u << 20);
    CHECK(uhas_batch_create(&profile, 1, nullptr, &options, &batch, message, sizeof message) == UHAS_ERROR_INTERNAL);
  }
  CHECK(batch == nullptr);
  CHECK(std::string(message) == "Resource temporarily unavailable");
}
#endif

TEST_CASE("batches are those of C++, mixed sets of hands and bad rows too") {
  const std::vector<HandProfile> hands{test::small_profile(), test::arch_profile()};
  test::ScratchFolder folder;
  write_profile(hands[1], folder.file("arch.h5"));
  uhas_profile* arch = nullptr;
  REQUIRE(uhas_profile_load(folder.file("arch.h5").c_str(), &arch, nullptr, 0) == UHAS_OK);
  const uhas_profile* profiles[] = {small_handle(), arch};
  uhas_batch_options options = UHAS_BATCH_OPTIONS_INIT;
  options.threads = 2;
  Owned<uhas_batch, uhas_batch_free> batch;
  REQUIRE(uhas_batch_create(profiles, 2, nullptr, &options, &batch.get, nullptr, 0) == UHAS_OK);
  uhas_profile_free(arch);
  BatchSolver<double> in_cpp(hands, {}, {.threads = 2});
  REQUIRE(uhas_batch_row_size(batch.get) == kJoints);

  constexpr std::size_t count = 40;
  std::vector<double> actions = random_actions(count, 9), q(count * kJoints, 7.0), expected = q;
  std::vector<int> hand_of_row(count), statuses(count);
  for (std::size_t n = 0; n < count; ++n) hand_of_row[n] = static_cast<int>(n % 2);
  actions[15 * 3] = kNan;
  hand_of_row[5] = 2;
  CHECK(uhas_batch_solve(batch.get, actions.data(), actions.size(), nullptr, hand_of_row.data(), q.data(), q.size(),
                         statuses.data()) == UHAS_NON_FINITE_INPUT);
  CHECK(in_cpp.solve({.count = count, .values = actions, .hands = hand_of_row}, expected) == Status::non_finite_input);
  CHECK(q == expected);
  for (std::size_t n = 0; n < count; ++n)
    CHECK(statuses[n] == (n == 3 ? UHAS_NON_FINITE_INPUT : n == 5 ? UHAS_UNKNOWN_HAND : UHAS_OK));

  CHECK(uhas_batch_solve(batch.get, actions.data(), 15, nullptr, nullptr, q.data(), q.size(), nullptr) ==
        UHAS_WRONG_SIZE);
  CHECK(uhas_batch_solve(batch.get, actions.data(), 7 * count, nullptr, nullptr, q.data(), q.size(), nullptr) ==
        UHAS_WRONG_SIZE);
  CHECK(uhas_batch_solve(batch.get, nullptr, 15 * count, nullptr, nullptr, q.data(), q.size(), nullptr) ==
        UHAS_WRONG_SIZE);
  CHECK(q == expected);

  const std::vector<double> good = random_actions(count, 10);
  const std::vector<float> good_f(good.begin(), good.end());
  std::vector<float> q_f(count * kJoints);
  REQUIRE(uhas_batch_solve_f(batch.get, good_f.data(), good_f.size(), nullptr, nullptr, q_f.data(), q_f.size(),
                             nullptr) == UHAS_OK);
  const std::vector<double> alone = solve_in_cpp<double>(good);
  for (std::size_t i = 0; i < alone.size(); ++i) CHECK(std::abs(double(q_f[i]) - alone[i]) < 1e-4);

  uhas_batch* none = nullptr;
  char message[256] = "";
  CHECK(uhas_batch_create(profiles, 0, nullptr, nullptr, &none, message, sizeof message) == UHAS_ERROR_INVALID_OPTION);
  CHECK(uhas_batch_create(nullptr, 1, nullptr, nullptr, &none, message, sizeof message) == UHAS_ERROR_INVALID_OPTION);
  options.threads = 0;
  CHECK(uhas_batch_create(profiles, 1, nullptr, &options, &none, message, sizeof message) == UHAS_ERROR_INVALID_OPTION);
  CHECK(none == nullptr);
}

TEST_CASE("observations are those of C++") {
  uhas_observation_options options = UHAS_OBSERVATION_OPTIONS_INIT;
  options.points = 1u << 0 | 1u << 6, options.pad_directions = 1;
  OwnedObserver observer;
  REQUIRE(uhas_observer_create(small_handle(), &options, &observer.get, nullptr, 0) == UHAS_OK);
  Observer<double> expected(test::small_profile(),
                            {.points = {true, false, false, false, false, false, true}, .pad_directions = true});
  const std::size_t size = uhas_observer_size(observer.get);
  REQUIRE(size == std::size_t(expected.size()));

  const std::vector<double> q = solve_in_cpp<double>(random_actions(3, 3)), qd(q.size(), 0.5);
  std::vector<double> observations(3 * size), in_cpp(3 * size);
  REQUIRE(uhas_observer_observe(observer.get, q.data(), q.size(), qd.data(), qd.size(), observations.data(),
                                observations.size(), nullptr) == UHAS_OK);
  REQUIRE(expected.observe_batch(q, qd, in_cpp) == Status::ok);
  CHECK(observations == in_cpp);
  CHECK(uhas_observer_observe(observer.get, q.data(), q.size(), qd.data(), qd.size(), observations.data(), size,
                              nullptr) == UHAS_WRONG_SIZE);
  CHECK(uhas_observer_observe(observer.get, q.data(), q.size(), nullptr, q.size(), observations.data(), 3 * size,
                              nullptr) == UHAS_WRONG_SIZE);

  const std::vector<float> q_f(q.begin(), q.end()), qd_f(q.size(), 0.5f);
  std::vector<float> observations_f(3 * size);
  REQUIRE(uhas_observer_observe_f(observer.get, q_f.data(), q.size(), qd_f.data(), qd.size(), observations_f.data(),
                                  3 * size, nullptr) == UHAS_OK);
  for (std::size_t i = 0; i < observations.size(); ++i)
    CHECK(std::abs(double(observations_f[i]) - observations[i]) < 1e-4);
}

TEST_CASE("encoding and retargeting are those of C++") {
  const HandProfile profile = test::small_profile();
  const std::vector<double> q = solve_in_cpp<double>(random_actions(3, 4));
  OwnedEncoder encoder;
  OwnedRetargeter retargeter;
  REQUIRE(uhas_encoder_create(small_handle(), nullptr, &encoder.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_retargeter_create(small_handle(), small_handle(), nullptr, &retargeter.get, nullptr, 0) == UHAS_OK);
  Encoder<double> encoder_in_cpp(profile);
  Retargeter<double> retargeter_in_cpp(profile, profile);

  std::vector<double> actions(45), actions_in_cpp(45), q_to(q.size()), q_to_in_cpp(q.size());
  uhas_encode_report reports[3];
  EncodeReport reports_in_cpp[3];
  REQUIRE(uhas_encoder_encode(encoder.get, q.data(), q.size(), actions.data(), actions.size(), reports, nullptr) ==
          UHAS_OK);
  REQUIRE(encoder_in_cpp.encode_batch(q, actions_in_cpp, reports_in_cpp) == Status::ok);
  CHECK(actions == actions_in_cpp);
  for (int n = 0; n < 3; ++n) {
    CHECK(reports[n].residual_max == reports_in_cpp[n].residual_max);
    CHECK(reports[n].residual_rms == reports_in_cpp[n].residual_rms);
    for (int f = 0; f < kSlotCount; ++f) {
      CHECK(reports[n].finger_residual[f] == reports_in_cpp[n].fingers[f].residual);
      CHECK(reports[n].finger_joint[f] == reports_in_cpp[n].fingers[f].joint);
    }
  }
  REQUIRE(uhas_retargeter_retarget(retargeter.get, q.data(), q.size(), q_to.data(), q_to.size(), nullptr, nullptr) ==
          UHAS_OK);
  REQUIRE(retargeter_in_cpp.retarget_batch(q, q_to_in_cpp, {}) == Status::ok);
  CHECK(q_to == q_to_in_cpp);

  std::vector<double> bad = q;
  bad[10] = kNan;
  CHECK(uhas_encoder_encode(encoder.get, bad.data(), bad.size(), actions.data(), actions.size(), nullptr, nullptr) ==
        UHAS_NON_FINITE_INPUT);
  CHECK(uhas_encoder_encode(encoder.get, q.data(), q.size(), actions.data(), 44, nullptr, nullptr) == UHAS_WRONG_SIZE);
  CHECK(uhas_retargeter_retarget(retargeter.get, q.data(), 14, q_to.data(), q_to.size(), nullptr, nullptr) ==
        UHAS_WRONG_SIZE);
  CHECK(actions == actions_in_cpp);

  const std::vector<float> q_f(q.begin(), q.end());
  std::vector<float> actions_f(45), q_to_f(q.size());
  REQUIRE(uhas_encoder_encode_f(encoder.get, q_f.data(), q.size(), actions_f.data(), 45, reports, nullptr) == UHAS_OK);
  REQUIRE(uhas_retargeter_retarget_f(retargeter.get, q_f.data(), q.size(), q_to_f.data(), q.size(), reports, nullptr) ==
          UHAS_OK);
  for (std::size_t i = 0; i < q.size(); ++i) CHECK(std::abs(double(q_to_f[i]) - q[i]) < 1e-3);

  uhas_encoder* none = nullptr;
  char message[128] = "";
  uhas_solve_options options = UHAS_SOLVE_OPTIONS_INIT;
  options.driving_vectors = 5;
  CHECK(uhas_encoder_create(small_handle(), &options, &none, message, sizeof message) == UHAS_ERROR_INVALID_OPTION);
  CHECK(std::string(message) == "driving_vectors is 5; choose a number from 1 to 4");
}

TEST_CASE("a row that is refused hinders no other, in every call") {
  constexpr std::size_t count = 23;
  const std::vector<double> actions = random_actions(count, 6), q = solve_in_cpp<double>(actions);
  const uhas_profile* profile = small_handle();
  OwnedSolver solver;
  OwnedController controller;
  OwnedObserver observer;
  OwnedEncoder encoder;
  OwnedRetargeter retargeter;
  Owned<uhas_batch, uhas_batch_free> batch;
  REQUIRE(uhas_solver_create(profile, nullptr, &solver.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_controller_create(profile, nullptr, &controller.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_observer_create(profile, nullptr, &observer.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_encoder_create(profile, nullptr, &encoder.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_retargeter_create(profile, profile, nullptr, &retargeter.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_batch_create(&profile, 1, nullptr, nullptr, &batch.get, nullptr, 0) == UHAS_OK);

  // call(input, its size, output, its size, statuses): what the function of uhas.h returns
  const auto check = [&](const std::vector<double>& input, std::size_t outputs, auto call) {
    test::check_refused_rows(input, count, outputs, [&](auto in, auto out, std::span<Status> statuses) {
      int* const as_int = statuses.empty() ? nullptr : reinterpret_cast<int*>(statuses.data());
      return static_cast<Status>(call(in.data(), in.size(), out.data(), out.size(), as_int));
    });
  };
  using In = const double*;
  const std::vector<double> start(q.size(), 0.1);
  std::vector<double> residual(count, 7.0);
  std::vector<std::uint8_t> at_limit(q.size(), 7);
  uhas_solve_report report = UHAS_SOLVE_REPORT_INIT;
  report.residual_rms = residual.data(), report.at_limit = at_limit.data();
  for (const bool reported : {false, true})
    check(actions, kJoints, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
      return uhas_solver_solve(solver.get, in, size, nullptr, out, out_size, reported ? &report : nullptr, statuses);
    });
  check(actions, kJoints, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
    return uhas_batch_solve(batch.get, in, size, nullptr, nullptr, out, out_size, statuses);
  });
  check(q, kJoints, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
    return uhas_controller_reset(controller.get, in, size, out, out_size, statuses);
  });
  check(actions, kJoints, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
    return uhas_controller_update(controller.get, in, size, nullptr, 0.01, out, out_size, statuses);
  });
  check(q, kJoints, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
    return uhas_controller_approach(controller.get, in, size, 0.01, out, out_size, statuses);
  });
  check(q, 90, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
    return uhas_observer_observe(observer.get, in, size, start.data(), size, out, out_size, statuses);
  });
  std::vector<uhas_encode_report> reports(count);
  check(q, 15, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
    return uhas_encoder_encode(encoder.get, in, size, out, out_size, reports.data(), statuses);
  });
  check(q, kJoints, [&](In in, std::size_t size, double* out, std::size_t out_size, int* statuses) {
    return uhas_retargeter_retarget(retargeter.get, in, size, out, out_size, reports.data(), statuses);
  });

  // the arrays of a report have rows too
  std::vector<double> two(actions.begin(), actions.begin() + 30), angles(2 * kJoints);
  two[0] = kNan;
  residual[0] = 7, at_limit[0] = 7, residual[1] = 7, at_limit[kJoints] = 7;
  CHECK(uhas_solver_solve(solver.get, two.data(), 30, nullptr, angles.data(), 10, &report, nullptr) ==
        UHAS_NON_FINITE_INPUT);
  CHECK(residual[0] == 7);
  CHECK(at_limit[0] == 7);
  CHECK(residual[1] < 7);
  CHECK(at_limit[kJoints] < 7);

  // what the rows share refuses each of them
  std::vector<int> statuses(2, UHAS_OK);
  CHECK(uhas_controller_update(controller.get, actions.data(), 30, nullptr, -1, angles.data(), 10, statuses.data()) ==
        UHAS_INVALID_PERIOD);
  CHECK(statuses == std::vector<int>(2, UHAS_INVALID_PERIOD));
}

#ifndef UHAS_SANITIZED  // ThreadSanitizer allows no threads after a fork
TEST_CASE("after a fork the child uses its copies of handles, and makes a batch with threads anew") {
  const uhas_profile* profile = small_handle();
  uhas_batch_options two_threads = UHAS_BATCH_OPTIONS_INIT;
  two_threads.threads = 2;
  OwnedSolver solver;
  Owned<uhas_batch, uhas_batch_free> batch, threaded;
  REQUIRE(uhas_solver_create(profile, nullptr, &solver.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_batch_create(&profile, 1, nullptr, nullptr, &batch.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_batch_create(&profile, 1, nullptr, &two_threads, &threaded.get, nullptr, 0) == UHAS_OK);
  const std::vector<double> actions = random_actions(2, 3);
  std::vector<double> q(2 * kJoints);
  const auto solve = [&](uhas_batch* by) {
    return uhas_batch_solve(by, actions.data(), 30, nullptr, nullptr, q.data(), 10, nullptr);
  };
  REQUIRE(solve(threaded.get) == UHAS_OK);
  const pid_t child = fork();
  if (child == 0) {
    alarm(10);
    uhas_batch* anew = nullptr;
    int result = uhas_solver_solve(solver.get, actions.data(), 30, nullptr, q.data(), 10, nullptr, nullptr);
    if (result == UHAS_OK) result = solve(batch.get);
    if (result == UHAS_OK) result = uhas_batch_create(&profile, 1, nullptr, &two_threads, &anew, nullptr, 0);
    if (result == UHAS_OK) result = solve(anew);
    uhas_batch_free(anew);
    _exit(result);
  }
  int ended = -1;
  REQUIRE(waitpid(child, &ended, 0) == child);
  CHECK(ended == 0);
  CHECK(solve(threaded.get) == UHAS_OK);
}
#endif

TEST_CASE("the number of driving vectors is stated once, when a handle is made") {
  uhas_solve_options options = UHAS_SOLVE_OPTIONS_INIT;
  options.driving_vectors = 1;
  uhas_controller_options controller_options = UHAS_CONTROLLER_OPTIONS_INIT;
  controller_options.solve = &options;
  const uhas_profile* profile = small_handle();
  OwnedSolver solver;
  OwnedController controller;
  OwnedEncoder encoder;
  Owned<uhas_batch, uhas_batch_free> batch;
  REQUIRE(uhas_solver_create(profile, &options, &solver.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_controller_create(profile, &controller_options, &controller.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_encoder_create(profile, &options, &encoder.get, nullptr, 0) == UHAS_OK);
  REQUIRE(uhas_batch_create(&profile, 1, &options, nullptr, &batch.get, nullptr, 0) == UHAS_OK);

  const std::vector<double> actions{0.1, 0.1, 0.1, 0.1, 0, -0.2, -0.2, -0.2, -0.2, 0.1};
  std::vector<double> q(3 * kJoints), expected(kJoints), encoded(10);
  CascadeSolver<double> in_cpp(test::small_profile());
  REQUIRE(in_cpp.solve({.values = actions}, expected) == Status::ok);
  const auto first = [&] { return std::vector<double>(q.begin(), q.begin() + kJoints); };
  CHECK(uhas_solver_solve(solver.get, actions.data(), 10, nullptr, q.data(), kJoints, nullptr, nullptr) == UHAS_OK);
  CHECK(first() == expected);
  CHECK(uhas_batch_solve(batch.get, actions.data(), 10, nullptr, nullptr, q.data(), kJoints, nullptr) == UHAS_OK);
  for (std::size_t i = 0; i < kJoints; ++i) CHECK(std::abs(q[i] - expected[i]) < 1e-10);
  CHECK(uhas_controller_update(controller.get, actions.data(), 10, nullptr, 0.01, q.data(), kJoints, nullptr) ==
        UHAS_OK);
  CHECK(uhas_encoder_encode(encoder.get, q.data(), kJoints, encoded.data(), 10, nullptr, nullptr) == UHAS_OK);

  const std::vector<double> thirty(30);
  CHECK(uhas_solver_solve(solver.get, thirty.data(), 30, nullptr, q.data(), 10, nullptr, nullptr) == UHAS_WRONG_SIZE);
  CHECK(uhas_batch_solve(batch.get, thirty.data(), 30, nullptr, nullptr, q.data(), 10, nullptr) == UHAS_WRONG_SIZE);
  CHECK(uhas_controller_update(controller.get, thirty.data(), 30, nullptr, 0.01, q.data(), 10, nullptr) ==
        UHAS_WRONG_SIZE);
  CHECK(uhas_solver_solve(solver.get, thirty.data(), 30, nullptr, q.data(), 15, nullptr, nullptr) == UHAS_OK);
}

TEST_CASE("versions and statuses are told") {
  CHECK(uhas_c_api_version() == UHAS_C_API_VERSION);
  CHECK(std::count(uhas_version(), uhas_version() + std::strlen(uhas_version()), '.') == 2);
  CHECK(std::string(uhas_status_text(UHAS_OK)) == "ok");
  CHECK(uhas_status_text(-5) != nullptr);
}
