#include "uhas/runtime/cascade/affine_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "uhas/runtime/cascade/affine_walk.hpp"
#include "uhas/runtime/cascade/patch_moments.hpp"
#include "uhas/runtime/cascade/solver_model.hpp"

namespace uhas {
namespace {

/// Moments that are affine in the displacements: at rest, and a radius of displacement of each driving vector more.
using AffineMoments = std::vector<PointMoments<double>>;  // [1 + V]

/// Writes numbers in the order in which a walk reads them.
template <class Real>
class NumberWriter {
 public:
  void number(double x) { numbers.push_back(static_cast<Real>(x)); }
  void vector(Vector3d v) { number(v.x), number(v.y), number(v.z); }
  void transform(const RigidTransformd& T) {
    for (int j = 0; j < 3; ++j) vector(T.rotation.column(j));
    vector(T.translation);
  }
  /// Each component of `part(moments)`, at rest and for each displacement.
  template <class Part>
  void affine_vector(const AffineMoments& moments, Part part) {
    for (double Vector3d::*component : {&Vector3d::x, &Vector3d::y, &Vector3d::z})
      for (const PointMoments<double>& m : moments) number(part(m).*component);
  }

  std::vector<Real> numbers;
};

/// A finger of the model that has an affine form, as a bundle wants it.
template <class Real>
class FingerCompiler {
 public:
  FingerCompiler(const SolverModel<Real>& model, int part)
      : model_(&model), part_(part), tree_(model.parts[part].tree) {
    const std::vector<int>& laterals = model.parts[part].laterals;
    lateral_ = laterals.empty() ? -1 : laterals.front();
    const int lateral_joint = lateral_ < 0 ? -1 : model.laterals[lateral_].joint;
    for (int n = 0; n < static_cast<int>(tree_.size()); ++n) {
      const int joint = tree_[n].joint;
      const auto solves = [&](int k) { return model.steps[k].joint == joint; };
      if (joint == lateral_joint)
        lateral_place_ = n;
      else if (std::any_of(model.parts[part].steps.begin(), model.parts[part].steps.end(), solves))
        (lateral_ >= 0 && lateral_place_ < 0 ? before_ : beyond_).push_back(n);
    }
  }

  int before() const { return static_cast<int>(before_.size()); }
  int beyond() const { return static_cast<int>(beyond_.size()); }

  AffineFinger<Real> finger(int before, int beyond) const {
    AffineFinger<Real> finger;
    finger.finger = model_->parts[part_].fingers.front();
    finger.part = part_;
    finger.lateral = lateral_;
    finger.lowest = static_cast<Real>(kFadeBegins);
    for (const SolverPoint<Real>& point : model_->points)
      if (point.finger == finger.finger) finger.lowest = std::max(finger.lowest, -point.rho);
    for (int place : places(before, beyond)) finger.joints.push_back(place < 0 ? -1 : tree_[place].joint);
    for (const ScopedJoint& s : tree_)
      if (std::count(finger.joints.begin(), finger.joints.end(), s.joint) == 0)
        finger.others.emplace_back(s.joint, model_->starts[s.joint].value.q);
    return finger;
  }

  /// For a bundle of so many steps. The first fits of a finger that has fewer before its lateral joint, and the last of
  /// one that has fewer beyond, do nothing.
  std::vector<Real> constants(int before, int beyond) const {
    const std::vector<int> steps = places(before, beyond);
    NumberWriter<Real> out;
    int done = 0;  // joints of the chain that the walk has passed
    for (int s = 0; s < static_cast<int>(steps.size()); ++s) {
      out.transform(way(done, steps[s]));
      if (steps[s] >= 0) done = steps[s] + 1;
      if (s != before) write_fit(out, steps[s]);
    }
    return out.numbers;
  }

  std::vector<Real> sum_constants(int before, int beyond) const {
    const std::vector<AffineMoments> carried = carry(1);
    const std::vector<int> steps = places(before, beyond);
    NumberWriter<Real> out;
    for (int s = 0; s < static_cast<int>(steps.size()); ++s)
      if (s != before) write_sums(out, steps[s], carried, s < before);
    return out.numbers;
  }

  std::vector<Real> affine(int before, int beyond, int vectors) const {
    const std::vector<AffineMoments> carried = carry(vectors);
    const AffineMoments nothing(1 + vectors);
    const std::vector<int> steps = places(before, beyond);
    NumberWriter<Real> out;
    for (int s = 0; s < static_cast<int>(steps.size()); ++s) {
      if (s == before) continue;
      // rows x and y of M, which alone a turn about z sees
      const AffineMoments& moments = steps[s] < 0 ? nothing : carried[steps[s]];
      using Moments = PointMoments<double>;
      out.affine_vector(moments, [](const Moments& m) { return Vector3d{m.pt[0].x, m.pt[1].x, m.pt[2].x}; });
      out.affine_vector(moments, [](const Moments& m) { return Vector3d{m.pt[0].y, m.pt[1].y, m.pt[2].y}; });
      if (s > before) continue;
      // of the points beyond the lateral joint all
      const AffineMoments& beyond_lateral = steps[s] < 0 ? nothing : carried[lateral_place_];
      out.affine_vector(beyond_lateral, [](const Moments& m) { return m.t; });
      for (int j = 0; j < 3; ++j) out.affine_vector(beyond_lateral, [j](const Moments& m) { return m.pt[j]; });
    }
    return out.numbers;
  }

 private:
  /// [step] the place of the joint in the chain that the step turns; -1 = none.
  std::vector<int> places(int before, int beyond) const {
    std::vector<int> places(before - before_.size(), -1);
    places.insert(places.end(), before_.begin(), before_.end());
    places.push_back(lateral_place_);
    places.insert(places.end(), beyond_.begin(), beyond_.end());
    places.resize(before + 1 + beyond, -1);
    return places;
  }

  RigidTransformd frame_at_zero(int place) const {
    return model_->joints[tree_[place].joint].T_parent_joint.template cast<double>();
  }
  RigidTransformd frame_at_start(int place) const {
    return model_->joints[tree_[place].joint].moved(frame_at_zero(place),
                                                    model_->starts[tree_[place].joint].value.template cast<double>());
  }
  double decay(int place) const {
    return model_->joints[tree_[place].joint].decay_inward(double(model_->passes.front().decay));
  }

  /// Of moments that go from the lateral joint to the one at `place`.
  double decay_to_lateral(int place) const {
    double factor = 1;
    for (int n = place + 1; n <= lateral_place_; ++n) factor *= tree_[n].inner ? decay(n) : 0;
    return factor;
  }

  /// The frames from joint `done` of the chain to the joint at `place`, all at their start; the lateral joint turns by
  /// itself.
  RigidTransformd way(int done, int place) const {
    RigidTransformd T;
    for (int n = done; n <= place; ++n) T = T * (n == lateral_place_ ? frame_at_zero(n) : frame_at_start(n));
    return T;
  }

  /// Of the points on the joint's own links.
  AffineMoments own_moments(int joint, int vectors) const {
    AffineMoments own(1 + vectors);
    std::array<double, kMaxDrivingVectors> phi;
    const std::span<const Real> angles = model_->decoder.default_angles(vectors);
    std::copy(angles.begin(), angles.end(), phi.begin());
    const auto share = [&](double angle, int j) {
      return displacement_share(angle, std::span(phi).first(vectors), j, model_->options.convention.held_toward_pole);
    };
    for (const SolverPoint<Real>& point : model_->points) {
      if (point.joint != joint) continue;
      const Vector3d p = point.p.template cast<double>(), n = point.direction.template cast<double>();
      const double w = point.weight;
      own[0].add(w, 1, p, double(point.rho) * n);
      for (int j = 0; j < vectors; ++j) own[1 + j].add_pair(p, w * share(double(point.phi), j) * n);
    }
    return own;
  }

  /// [joint of the chain] what it carries, from the tip inward; what lies beyond the lateral joint stays there.
  std::vector<AffineMoments> carry(int vectors) const {
    std::vector<AffineMoments> carried(tree_.size());
    for (int n = static_cast<int>(tree_.size()) - 1; n >= 0; --n) {
      carried[n] = own_moments(tree_[n].joint, vectors);
      const int child = n + 1;
      if (child == static_cast<int>(tree_.size()) || !tree_[child].inner || child == lateral_place_) continue;
      const RigidTransformd scaled_T = scaled(frame_at_start(child), decay(child));
      for (int m = 0; m <= vectors; ++m) carried[n][m].add_transformed(carried[child][m], scaled_T, decay(child));
    }
    return carried;
  }

  /// Of a joint's sums what no displacement changes; of no joint, zeros.
  void write_sums(NumberWriter<Real>& out, int place, const std::vector<AffineMoments>& carried, bool before) const {
    const PointMoments<double> sums = place < 0 ? PointMoments<double>{} : carried[place].front();
    if (before) {
      const double factor = place < 0 ? 0 : decay_to_lateral(place);
      const PointMoments<double>& beyond = carried[lateral_place_ < 0 ? 0 : lateral_place_].front();
      out.number(sums.weight + factor * beyond.weight);
      out.number(sums.p.x), out.number(sums.p.y);
      // the way to the lateral joint, and what goes through its turn
      out.transform(scaled(place < 0 ? RigidTransformd{} : way(place + 1, lateral_place_), factor));
      out.number(beyond.weight);
      out.vector(beyond.p);
    } else {
      out.number(hold_of(sums.p.x, sums.p.y, sums.weight));
      out.number(sums.p.x), out.number(sums.p.y);
    }
  }

  /// What a fit needs besides its sums; of no joint, zeros.
  void write_fit(NumberWriter<Real>& out, int place) const {
    const SolverJoint<Real> none;
    const SolverJoint<Real>& joint = place < 0 ? none : model_->joints[tree_[place].joint];
    const double start = place < 0 ? 0.0 : double(model_->starts[tree_[place].joint].value.q);
    for (int u = 0; u < kLeadInputs; ++u) out.number(place < 0 ? 0.0 : double(model_->leads[tree_[place].joint][u]));
    out.number(start);
    for (double limit : {double(joint.lower.q), double(joint.upper.q)}) write_limit(out, limit, limit - start);
  }

  /// One that a turn cannot reach, half a circle away or more, is beyond every diamond angle.
  static void write_limit(NumberWriter<Real>& out, double limit, double turn) {
    const bool within_reach = std::abs(turn) < std::numbers::pi;
    out.number(limit);
    out.number(within_reach ? diamond_angle(std::sin(turn), std::cos(turn)) : std::copysign(3, turn));
    out.number(std::sin(turn)), out.number(std::cos(turn));
  }

  const SolverModel<Real>* model_;
  int part_;
  std::span<const ScopedJoint> tree_;  // of the part: a chain
  int lateral_ = -1;                   // index into the model's laterals
  int lateral_place_ = -1;             // in the chain
  std::vector<int> before_, beyond_;   // places of fitted joints, before and beyond the lateral one
};

template <class Real>
bool has_affine_form(const SolverModel<Real>& model, const SolverPart& part) {
  if (part.fingers.size() != 1 || part.laterals.size() > 1 || !part.lateral_followers.empty()) return false;
  for (std::size_t n = 0; n < part.tree.size(); ++n) {
    const SolverJoint<Real>& joint = model.joints[part.tree[n].joint];
    if (joint.follows || joint.parent != (n == 0 ? -1 : part.tree[n - 1].joint)) return false;
  }
  const auto is_turn = [&](int k) { return model.steps[k].single && !model.joints[model.steps[k].joint].prismatic; };
  const auto turns = [&](int k) { return !model.joints[model.laterals[k].joint].prismatic; };
  return std::all_of(part.steps.begin(), part.steps.end(), is_turn) &&
         std::all_of(part.laterals.begin(), part.laterals.end(), turns);
}

/// Lane by lane into [numbers][width]; lanes past the last repeat it.
template <class Real>
std::vector<Real> interleave(const std::vector<std::vector<Real>>& lanes, int width) {
  std::vector<Real> numbers;
  for (std::size_t k = 0; k < lanes.front().size(); ++k)
    for (std::size_t l = 0; l < std::size_t(width); ++l) numbers.push_back(lanes[std::min(l, lanes.size() - 1)][k]);
  return numbers;
}

template <class Real>
AffineBundle<Real> make_bundle(std::span<const FingerCompiler<Real>> fingers, int width) {
  AffineBundle<Real> bundle;
  bundle.width = width;
  for (const auto& finger : fingers) {
    bundle.before = std::max(bundle.before, finger.before());
    bundle.beyond = std::max(bundle.beyond, finger.beyond());
  }
  const auto of_each = [&](auto numbers_of) {
    std::vector<std::vector<Real>> lanes;
    for (const auto& finger : fingers) lanes.push_back(numbers_of(finger));
    return interleave(lanes, width);
  };
  for (const auto& finger : fingers) bundle.fingers.push_back(finger.finger(bundle.before, bundle.beyond));
  bundle.constants = of_each([&](const auto& finger) { return finger.constants(bundle.before, bundle.beyond); });
  bundle.sum_constants =
      of_each([&](const auto& finger) { return finger.sum_constants(bundle.before, bundle.beyond); });
  for (int vectors = 1; vectors <= kMaxDrivingVectors; ++vectors)
    bundle.affine[vectors - 1] =
        of_each([&](const auto& finger) { return finger.affine(bundle.before, bundle.beyond, vectors); });
  return bundle;
}

}  // namespace

template <class Real>
std::vector<AffineBundle<Real>> bundle_fingers(const SolverModel<Real>& model, int width) {
  const SolveOptions& options = model.options;
  if (options.rule != CascadeRule::correspondence || options.field != FieldReading::finger || model.passes.size() > 1)
    return {};
  std::vector<FingerCompiler<Real>> fingers;
  for (int n = 0; n < static_cast<int>(model.parts.size()); ++n)
    if (has_affine_form(model, model.parts[n])) fingers.emplace_back(model, n);
  // fingers of a kind walk together
  const auto kind = [](const FingerCompiler<Real>& finger) { return std::pair(finger.before(), finger.beyond()); };
  std::stable_sort(fingers.begin(), fingers.end(), [&](const auto& a, const auto& b) { return kind(a) < kind(b); });
  std::vector<AffineBundle<Real>> bundles;
  for (std::span<const FingerCompiler<Real>> rest = fingers; !rest.empty();) {
    const std::size_t count = std::min<std::size_t>(width, rest.size());
    bundles.push_back(make_bundle(rest.first(count), width));
    rest = rest.subspan(count);
  }
  return bundles;
}

template std::vector<AffineBundle<float>> bundle_fingers(const SolverModel<float>& model, int width);
template std::vector<AffineBundle<double>> bundle_fingers(const SolverModel<double>& model, int width);

}  // namespace uhas
