// The moments of point pairs against sums over the points themselves.
#include "uhas/runtime/cascade/moments.hpp"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace uhas;

namespace {

struct Pair {
  Vector3d p, t;
  double w, share;
};

std::vector<Pair> random_pairs(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vector3d{unit(random), unit(random), unit(random)}; };
  std::vector<Pair> pairs;
  for (int i = 0; i < 9; ++i) pairs.push_back({vector(), vector(), 1.5 + unit(random), 0.5 + 0.5 * unit(random)});
  return pairs;
}

RigidTransformd some_transform() { return {Rotationd::about(normalized(Vector3d{1, -2, 0.5}), 0.9), {0.3, -0.2, 0.7}}; }

}  // namespace

TEST_CASE("moments moved to another frame are the moments of the moved points") {
  std::mt19937_64 random(1);
  const std::vector<Pair> pairs = random_pairs(random);
  PointMoments<double> here, there, moved;
  for (const Pair& pair : pairs) {
    here.add(pair.w, pair.share, pair.p, pair.t);
    there.add(0.3 * pair.w, pair.share, some_transform() * pair.p, pair.t);
  }
  moved.add_transformed(here, scaled(some_transform(), 0.3), 0.3);
  CHECK(moved.full_weight == doctest::Approx(there.full_weight));
  CHECK(moved.weight == doctest::Approx(there.weight));
  CHECK(norm(moved.p - there.p) < 1e-12);
  CHECK(norm(moved.t - there.t) < 1e-12);
  for (int j = 0; j < 3; ++j) CHECK(norm(moved.pt[j] - there.pt[j]) < 1e-12);
}

TEST_CASE("the fit of a joint is the sum over its points") {
  std::mt19937_64 random(2);
  const std::vector<Pair> pairs = random_pairs(random);
  const Vector3d axis{0, 0, 1};
  const RigidTransformd T_S_F = some_transform();
  PointMoments<double> moments;
  double sine = 0, cosine = 0, shift = 0;
  for (const Pair& pair : pairs) {
    moments.add(pair.w, pair.share, pair.p, pair.t);
    const Vector3d t = T_S_F.inverse() * pair.t;
    const double w = pair.w * pair.share;
    sine += w * dot(axis, cross(pair.p, t));
    cosine += w * dot(orthogonal_part(pair.p, axis), orthogonal_part(t, axis));
    shift += w * dot(axis, t - pair.p);
  }
  const TurnFit<double> fit = fit_turn(turn_sums(moments), T_S_F);
  CHECK(fit.sine == doctest::Approx(sine).epsilon(1e-12));
  CHECK(fit.cosine == doctest::Approx(cosine).epsilon(1e-12));
  CHECK(fit_shift(moments, T_S_F) == doctest::Approx(shift).epsilon(1e-12));
}

TEST_CASE("the angle of the fit minimises the weighted squared distance") {
  std::mt19937_64 random(3);
  for (int n = 0; n < 50; ++n) {
    const std::vector<Pair> pairs = random_pairs(random);
    PointMoments<double> moments;
    for (const Pair& pair : pairs) moments.add(pair.w, pair.share, pair.p, pair.t);
    const TurnFit<double> fit = fit_turn(turn_sums(moments), RigidTransformd{});
    const auto cost = [&](double angle) {
      double sum = 0;
      for (const Pair& pair : pairs) {
        const Vector3d e = Rotationd::about(Vector3d{0, 0, 1}, angle) * pair.p - pair.t;
        sum += pair.w * pair.share * dot(e, e);
      }
      return sum;
    };
    const double best = std::atan2(fit.sine, fit.cosine);
    for (int k = 0; k < 360; ++k) CHECK(cost(best) <= cost(k * 0.0174533) + 1e-12);
  }
}

TEST_CASE("turning the targets turns their moments") {
  std::mt19937_64 random(4);
  PointMoments<double> moments, turned;
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (const Pair& pair : random_pairs(random)) {
    moments.add(pair.w, pair.share, pair.p, pair.t);
    turned.add(pair.w, pair.share, pair.p, Rotationd::about(Vector3d{0, 0, 1}, 0.7) * pair.t);
  }
  moments.turn_targets(c, s);
  CHECK(norm(moments.t - turned.t) < 1e-12);
  for (int j = 0; j < 3; ++j) CHECK(norm(moments.pt[j] - turned.pt[j]) < 1e-12);
}
