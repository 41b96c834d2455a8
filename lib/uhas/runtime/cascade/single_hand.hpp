// The solve of one hand: fingers that stand alone go through their first pass side by side, a finger a lane; all else
// goes through the cascade.
#pragma once

#include <memory>
#include <vector>

#include "uhas/runtime/cascade/cascade.hpp"
#include "uhas/runtime/lanes/finger_lanes.hpp"

namespace uhas {

template <class Real>
class SingleHand {
 public:
  /// `model` must outlive this and its copies.
  explicit SingleHand(const SolverModel<Real>& model);

  std::size_t joint_count() const noexcept { return model_->joints.size(); }

  /// @param action  that has passed ActionDecoder::check
  /// @param q       [joint] profile units, out
  void solve(const ActionNumbers<Real>& action, std::span<Real> q) noexcept;

  /// What the last solve found out.
  /// @param action, q  of that solve
  void report(const ActionNumbers<Real>& action, std::span<const Real> q, SolveReport& report) noexcept;

 private:
  using Visit = PointMoments<Real> (*)(const PointColumns<Real>&, const RadialProfile<Real>&, CascadeClosing);

  /// Fingers that are walked side by side, and where the walk leaves its numbers.
  struct Bundle {
    AffineBundle<Real> constants;
    struct Place {
      int joint, step, lane;
      int number;  ///< step * width + lane
    };
    std::vector<Place> places;  ///< joints that a step turns
    int first;                  ///< number of this bundle's in the arrays of all
  };

  static std::vector<Bundle> make_bundles(const SolverModel<Real>& model, int width);
  void solve_bundle(std::size_t index, const ActionNumbers<Real>& action, std::span<Real> q) noexcept;
  void solve_others(const ActionNumbers<Real>& action, std::span<Real> q) noexcept;
  bool decode_finger(const AffineFinger<Real>& finger, const ActionNumbers<Real>& action, int lane) noexcept;
  void visit_points(const Bundle& bundle, const ActionNumbers<Real>& action, int lane) noexcept;
  SquaredErrors squared_errors() const noexcept;
  Real share_left_at(std::size_t index, const typename Bundle::Place& place) const noexcept;

  const SolverModel<Real>* model_;
  FingerLanes<Real> lanes_;
  std::shared_ptr<const std::vector<Bundle>> bundles_;
  Cascade<Real, Visit> cascade_;
  FingerInput<Real> input_{};                           // of a bundle; lanes without a finger stay at rest
  std::vector<Real> q_, at_limit_, open_share_, sums_;  // of all bundles, as FingerLanes has them
  std::vector<unsigned> faded_;                         // [bundle] lanes
};

}  // namespace uhas
