#include "uhas/collision/collision_free_solver.hpp"

#include "uhas/collision/action_way.hpp"

namespace uhas {
namespace {

constexpr int kSteps = 32, kHalvings = 10;  // stated in the header and in uhas-solve(1)

}  // namespace

struct CollisionFreeSolver::Search {
  CascadeSolver<double> solver;
  const SelfCollision& collision;
  ActionWay way;
  std::vector<double> q;

  bool collides_at(double scale) {
    solver.solve(way.at(scale), q);
    return collision.collides(q);
  }

  /// The greatest scale found below one that collides; the way's end collides, its beginning does not.
  double free_scale() {
    int step = 1;
    while (step < kSteps && !collides_at(step / double(kSteps))) ++step;
    double free = (step - 1) / double(kSteps), colliding = step / double(kSteps);
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (free + colliding);
      (collides_at(middle) ? colliding : free) = middle;
    }
    return free;
  }
};

CollisionFreeSolver::CollisionFreeSolver(const HandProfile& profile, const SolveOptions& options,
                                         const SelfCollision& collision)
    : search_(new Search{CascadeSolver<double>(profile, options), collision, ActionWay(profile, options.convention),
                         std::vector<double>(profile.tree.joints.size())}) {}

CollisionFreeSolver::CollisionFreeSolver(CollisionFreeSolver&&) noexcept = default;
CollisionFreeSolver::~CollisionFreeSolver() = default;

CollisionFreeSolution CollisionFreeSolver::solve(const Action<double>& action, std::span<double> q,
                                                 SolveReport& report) {
  CollisionFreeSolution result;
  result.status = search_->solver.solve(action, q, report);
  if (result.status != Status::ok) return result;
  result.values.assign(action.values.begin(), action.values.end());
  if (!search_->collision.collides(q)) {
    result.scale = 1;
    return result;
  }
  search_->way.lead_to(action);
  if (search_->collides_at(0)) return result;

  result.scale = search_->free_scale();
  const Action<double> scaled = search_->way.at(*result.scale);
  result.values.assign(scaled.values.begin(), scaled.values.end());
  result.status = search_->solver.solve(scaled, q, report);
  return result;
}

}  // namespace uhas
