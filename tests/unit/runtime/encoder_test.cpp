// Encode and retarget on the small profile: coupled joints, a sliding joint, a left hand, shared slots.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "support/arch_profile.hpp"
#include "support/random_action.hpp"
#include "support/small_profile.hpp"
#include "uhas/runtime/retarget.hpp"

using namespace uhas;

namespace {

/// Joint values for `action`; false when a joint was held at a limit or closed.
bool solve_freely(CascadeSolver<double>& solver, const std::vector<double>& action, std::vector<double>& q) {
  q.resize(solver.joint_count());
  std::vector<std::uint8_t> at_limit(q.size()), closed(q.size());
  SolveReport report{.residual_rms = 0, .at_limit = at_limit, .closed = closed};
  REQUIRE(solver.solve({.values = action, .driving_vectors_phi = {}}, q, report) == Status::ok);
  return std::count(at_limit.begin(), at_limit.end(), 1) + std::count(closed.begin(), closed.end(), 1) == 0;
}

std::vector<double> solve(CascadeSolver<double>& solver, const std::vector<double>& action) {
  std::vector<double> q;
  solve_freely(solver, action, q);
  return q;
}

std::vector<double> q_sphere_of(const HandProfile& profile) {
  std::vector<double> q;
  for (const JointTraits& traits : profile.joint_traits) q.push_back(traits.q_sphere);
  return q;
}

/// Largest difference over the independent joints, sliding joints in sphere radii, as a report states it.
double distance(const HandProfile& profile, const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Joint& joint = profile.tree.joints[i];
    const double unit = joint.kind == JointKind::prismatic ? profile.radius : 1;
    if (joint.mimic_master < 0) largest = std::max(largest, std::abs(a[i] - b[i]) / unit);
  }
  return largest;
}

}  // namespace

TEST_CASE("what a solve gave is encoded to an action that gives it again") {
  for (const HandProfile& profile : {test::small_profile(), test::arch_profile()}) {
    for (FieldReading field : {FieldReading::finger, FieldReading::field}) {
      for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors) {
        CascadeSolver<double> solver(profile, {.field = field});
        Encoder<double> encoder(profile, {.field = field}, vectors);
        CHECK(encoder.action_size() == 5 + 5 * vectors);
        std::mt19937_64 random(3);
        std::vector<double> q, action(encoder.action_size());
        int free = 0;
        for (int n = 0; n < 300; ++n) {
          if (!solve_freely(solver, test::random_action(random, 0.4, 0.4, vectors), q)) continue;
          ++free;
          EncodeReport report;
          REQUIRE(encoder.encode(q, action, report) == Status::ok);
          CAPTURE(profile.hand);
          CAPTURE(vectors);
          CAPTURE(n);
          CHECK(distance(profile, solve(solver, action), q) <= 1e-3);
        }
        CHECK(free > 30);
      }
    }
  }
}

TEST_CASE("the reference posture is the zero action") {
  const HandProfile profile = test::small_profile();
  Encoder<double> encoder(profile);
  std::vector<double> action(15, 1.0);
  EncodeReport report;
  REQUIRE(encoder.encode(q_sphere_of(profile), action, report) == Status::ok);
  for (double value : action) CHECK(std::abs(value) < 1e-6);
  CHECK(report.residual_max < 1e-6);
}

TEST_CASE("the slots of a finger hold one value, within bounds") {
  const HandProfile profile = test::small_profile();
  CascadeSolver<double> solver(profile);
  Encoder<double> encoder(profile);
  std::mt19937_64 random(5);
  std::vector<double> action(15);
  EncodeReport report;
  for (int n = 0; n < 50; ++n) {
    REQUIRE(encoder.encode(solve(solver, test::random_action(random, 1, 3)), action, report) == Status::ok);
    for (int slot = 1; slot < 4; ++slot) {  // the index owns slots 0 to 3
      CHECK(action[slot] == action[0]);
      CHECK(action[5 + 2 * slot] == action[5]);
      CHECK(action[6 + 2 * slot] == action[6]);
    }
    CHECK(action[0] >= test::small_lateral_table().delta_theta_lower);
    CHECK(action[0] <= test::small_lateral_table().delta_theta_upper);
    CHECK(action[4] == 0.0);  // the thumb has no lateral table
    for (int i = 5; i < 15; ++i) CHECK(std::abs(action[i]) <= kRadialBound);
  }
}

TEST_CASE("the report tells how far the solve of the action stays away") {
  const HandProfile profile = test::small_profile();
  CascadeSolver<double> solver(profile);
  Encoder<double> encoder(profile, {}, 1);  // two joints of the thumb, one number
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> action(10);
  double largest = 0;
  for (int n = 0; n < 50; ++n) {
    std::vector<double> q;
    for (const Joint& joint : profile.tree.joints)
      q.push_back(joint.lower + unit(random) * (joint.upper - joint.lower));
    EncodeReport report;
    REQUIRE(encoder.encode(q, action, report) == Status::ok);
    const std::vector<double> reached = solve(solver, action);
    CHECK(report.residual_max == doctest::Approx(distance(profile, reached, q)));
    CHECK(report.residual_rms <= report.residual_max);
    CHECK(report.residual_rms >= report.residual_max / 2);  // four independent joints
    largest = std::max(largest, report.residual_max);
  }
  CHECK(largest > 0.05);
}

TEST_CASE("followers are not read, whole turns of a continuous joint too, and values beyond the limits are reported") {
  const HandProfile profile = test::small_profile();
  Encoder<double> encoder(profile);
  const std::vector<double> q = q_sphere_of(profile);
  std::vector<double> action(15), other(15);
  EncodeReport report;
  REQUIRE(encoder.encode(q, action, report) == Status::ok);

  std::vector<double> changed = q;
  changed[2] = NAN;                    // follows joint 1
  changed[3] += 6 * std::numbers::pi;  // continuous
  REQUIRE(encoder.encode(changed, other, report) == Status::ok);
  for (int i = 0; i < 15; ++i) CHECK(other[i] == doctest::Approx(action[i]).epsilon(1e-6));
  CHECK(report.residual_max < 1e-6);

  changed[0] = 1e300;
  REQUIRE(encoder.encode(changed, other, report) == Status::ok);
  CHECK(report.residual_max >= 1e299);
  for (double value : other) CHECK(std::isfinite(value));
}

TEST_CASE("what cannot be encoded is refused by a status and nothing is written") {
  Encoder<double> encoder(test::small_profile());
  std::vector<double> q(5, 0.1), action(15, 7.0);
  EncodeReport report{.residual_max = 7, .residual_rms = 7, .fingers = {}};
  const auto refuses = [&](std::span<const double> in, std::span<double> out, Status status) {
    CHECK(encoder.encode(in, out, report) == status);
    CHECK(std::all_of(action.begin(), action.end(), [](double value) { return value == 7.0; }));
    CHECK(report.residual_max == 7);
  };
  const std::span<double> whole(action);
  refuses(std::vector<double>(4, 0.1), whole, Status::wrong_size);
  refuses({}, whole.first(0), Status::wrong_size);
  refuses(std::vector<double>(10, 0.1), whole, Status::wrong_size);
  refuses(q, whole.first(14), Status::wrong_size);
  q[3] = std::numeric_limits<double>::quiet_NaN();
  refuses(q, whole, Status::non_finite_input);
  CHECK_THROWS_AS(Encoder<double>(test::small_profile(), {}, 0), Error);
  CHECK_THROWS_AS(Encoder<double>(test::small_profile(), {}, 5), Error);
  CHECK_THROWS_AS(Encoder<double>(test::small_profile(), {.passes = 0}), Error);
}

TEST_CASE("a batch is what its postures are one by one, and a copy encodes like its original") {
  const HandProfile profile = test::small_profile();
  CascadeSolver<double> solver(profile);
  Encoder<double> encoder(profile);
  std::mt19937_64 random(7);
  constexpr std::size_t count = 20;
  std::vector<double> q, actions(15 * count), action(15);
  for (std::size_t n = 0; n < count; ++n) {
    const std::vector<double> one = solve(solver, test::random_action(random, 0.4, 0.6));
    q.insert(q.end(), one.begin(), one.end());
  }
  std::vector<EncodeReport> reports(count);
  REQUIRE(encoder.encode_batch(q, actions, reports) == Status::ok);
  Encoder<double> original = encoder, copy(test::arch_profile()), moved(test::arch_profile());
  moved = Encoder<double>(std::move(original));
  copy = moved;
  for (std::size_t n = 0; n < count; ++n) {
    EncodeReport report;
    REQUIRE(copy.encode(std::span(q).subspan(5 * n, 5), action, report) == Status::ok);
    CHECK(std::equal(action.begin(), action.end(), actions.begin() + 15 * n));
    CHECK(report.residual_max == reports[n].residual_max);
  }
  CHECK(encoder.encode_batch(q, actions, {}) == Status::ok);
  CHECK(encoder.encode_batch(q, actions, std::span(reports).first(3)) == Status::wrong_size);
  CHECK(encoder.encode_batch(std::span(q).first(7), actions, {}) == Status::wrong_size);
  CHECK(encoder.encode_batch({}, {}, {}) == Status::ok);
}

TEST_CASE("float encodes like double") {
  const HandProfile profile = test::small_profile();
  CascadeSolver<double> solver(profile);
  Encoder<float> encoder(profile);
  std::mt19937_64 random(8);
  for (int n = 0; n < 100; ++n) {
    std::vector<double> q;
    if (!solve_freely(solver, test::random_action(random, 0.4, 0.4), q)) continue;
    const std::vector<float> q_float(q.begin(), q.end());
    std::vector<float> action(15);
    EncodeReport report;
    REQUIRE(encoder.encode(q_float, action, report) == Status::ok);
    CHECK(distance(profile, solve(solver, {action.begin(), action.end()}), q) <= 1e-3);
  }
}

TEST_CASE("a hand retargeted to itself keeps what a solve gave") {
  const HandProfile profile = test::small_profile();
  CascadeSolver<double> solver(profile);
  Retargeter<double> retargeter(profile, profile);
  std::mt19937_64 random(9);
  std::vector<double> q, all, again(5), all_again;
  for (int n = 0; n < 100; ++n) {
    if (!solve_freely(solver, test::random_action(random, 0.4, 0.4), q)) continue;
    EncodeReport report;
    REQUIRE(retargeter.retarget(q, again, report) == Status::ok);
    CHECK(distance(profile, again, q) <= 1e-3);
    CHECK(report.residual_max <= 1e-3);
    all.insert(all.end(), q.begin(), q.end());
    all_again.insert(all_again.end(), again.begin(), again.end());
  }
  std::vector<double> batch(all.size());
  REQUIRE(retargeter.retarget_batch(all, batch, {}) == Status::ok);
  CHECK(batch == all_again);
}

TEST_CASE("the reference posture of one hand becomes that of another") {
  const HandProfile from = test::small_profile(), to = test::arch_profile();
  Retargeter<double> retargeter(from, to);
  CHECK(retargeter.joint_count_from() == 5);
  std::vector<double> q_to(retargeter.joint_count_to());
  EncodeReport report;
  REQUIRE(retargeter.retarget(q_sphere_of(from), q_to, report) == Status::ok);
  CHECK(distance(to, q_to, q_sphere_of(to)) < 1e-5);

  std::vector<double> untouched(q_to.size(), 7.0);
  CHECK(retargeter.retarget(std::vector<double>(4, 0.0), untouched, report) == Status::wrong_size);
  CHECK(retargeter.retarget(std::vector<double>(5, NAN), untouched, report) == Status::non_finite_input);
  CHECK(retargeter.retarget(q_sphere_of(from), std::span(untouched).first(1), report) == Status::wrong_size);
  CHECK(retargeter.retarget_batch(std::vector<double>(5, NAN), untouched, {}) == Status::non_finite_input);
  CHECK(std::all_of(untouched.begin(), untouched.end(), [](double value) { return value == 7.0; }));
}
