#include "uhas/anatomy/opening/open_pose.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "uhas/anatomy/opening/preferred_value.hpp"
#include "uhas/kinematics/finger_groups.hpp"
#include "uhas/kinematics/mimics.hpp"

namespace uhas {
namespace {

/// What a zero may cost against the best opening of a finger, which is 2; a base joint 10 degrees off costs as much.
constexpr double kSnapTolerance = 0.03;
/// The same for a thumb, whose pad rarely faces along the normal: its optimum is blunt.
constexpr double kThumbSnapTolerance = 0.07;
/// Gains smaller than this end the search.
constexpr double kGain = 1e-4;
/// Side joints whose combinations of low, middle and high values are starts.
constexpr std::size_t kMaxStartJoints = 3;

/// Fingers that share no variable with others, and their variables.
struct FingerGroup {
  std::vector<int> fingers;
  std::vector<int> variables;  ///< root to tip
};

std::vector<FingerGroup> compile_groups(const HandSkeleton& hand) {
  std::vector<std::vector<int>> variables;  // [finger]
  for (const FingerSkeleton& finger : hand.fingers) variables.push_back(independent_joints(hand.tree, finger.joints));
  std::vector<FingerGroup> groups;
  for (const std::vector<int>& fingers : group_fingers(variables)) {
    std::vector<int> joints;
    for (int f : fingers) joints.insert(joints.end(), hand.fingers[f].joints.begin(), hand.fingers[f].joints.end());
    groups.push_back({fingers, independent_joints(hand.tree, joints)});
  }
  return groups;
}

/// Opens groups of fingers, one after the other, for a palm normal.
class OpenPoseSearch {
 public:
  OpenPoseSearch(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                 const PalmNormal& normal)
      : hand_(hand), motion_(motion), bases_(extended.bases), thumb_(thumb), normal_(normal) {
    for (const FingerSkeleton& finger : hand.fingers) length_.push_back(finger_length(hand.tree, finger));
  }

  /// The groups of fingers that are opened together, with the variables to find. A gripper's fingers open by flexion
  /// alone: one that cannot lie flat would lean to its side for that.
  std::vector<FingerGroup> groups(Bases bases) const {
    std::vector<FingerGroup> groups = compile_groups(hand_);
    for (FingerGroup& group : groups)
      std::erase_if(group.variables, [&](int variable) {
        const bool is_searched = is_base_flexion(group, variable) ? bases == Bases::searched : !normal_.opposing;
        return !is_searched || motion_.held[variable] || stays_extended(group, variable);
      });
    return groups;
  }

  /// The best of the climbs from all starts; of equals the earlier.
  void open(const FingerGroup& group, std::vector<double>& q) const {
    double best_value = -std::numeric_limits<double>::infinity();
    std::vector<double> best;
    for (std::vector<double>& start : starts(group, q)) {
      const double value = climb(group, start);
      if (value > best_value + kGain) best = start, best_value = value;
    }
    q = best;
    settle(group, q);
  }

 private:
  /// How open the fingers of the group are: 2 for each that is straight in the palm plane with its pad
  /// along the normal.
  double openness(const FingerGroup& group, std::span<const double> q) const {
    const Vector3d n = normal_.normal;
    double sum = 0;
    for (int finger : group.fingers) {
      const FingerPosture posture = measure_posture(hand_.tree, hand_.fingers[finger], motion_.flexions[finger], q);
      sum += norm(orthogonal_part(posture.tip - posture.root, n)) / length_[finger] + dot(posture.closing, n);
    }
    return sum;
  }

  double try_value(const FingerGroup& group, int variable, double value, std::span<double> q) const {
    set_with_followers(hand_.tree, variable, value, q);
    return openness(group, q);
  }

  int flexion_variable(int finger, std::size_t i) const {
    return independent_joint(hand_.tree, hand_.fingers[finger].joints[motion_.flexions[finger].positions[i]]);
  }

  /// Distal flexion joints, a thumb's flexion joints and sliding jaws are open where `q` has them: straight, or at the
  /// end. What is left to find are side and roll joints, the angle of a finger's base to the palm, and that of a
  /// thumb's when it is a guess.
  bool stays_extended(const FingerGroup& group, int variable) const {
    for (int finger : group.fingers) {
      const Flexion& flexion = motion_.flexions[finger];
      const bool thumb_stays = finger == thumb_ && !bases_[finger].is_guess;
      for (std::size_t i = thumb_stays || flexion.sliding ? 0 : 1; i < flexion.positions.size(); ++i)
        if (flexion_variable(finger, i) == variable) return true;
    }
    return false;
  }

  bool is_base_flexion(const FingerGroup& group, int variable) const {
    return std::ranges::any_of(group.fingers, [&](int finger) { return flexion_variable(finger, 0) == variable; });
  }

  /// `q` and every combination of low, middle and high values of the first side joints.
  std::vector<std::vector<double>> starts(const FingerGroup& group, const std::vector<double>& q) const {
    std::vector<std::vector<double>> starts = {q};
    std::size_t varied = 0;
    for (int variable : group.variables) {
      if (is_base_flexion(group, variable) || varied++ == kMaxStartJoints) continue;
      const Joint& joint = hand_.tree.joints[variable];
      const std::size_t count = starts.size();
      for (std::size_t i = 0; i < count; ++i) {
        for (double value : {joint.lower, joint.upper}) {
          starts.push_back(starts[i]);
          set_with_followers(hand_.tree, variable, value, starts.back());
        }
      }
    }
    return starts;
  }

  /// Coordinate ascent; every joint scans its whole range.
  double climb(const FingerGroup& group, std::vector<double>& q) const {
    double value = openness(group, q);
    for (;;) {
      for (int variable : group.variables) {
        const double best = preferred_value(hand_.tree.joints[variable], kGain, motion_.zero_is_straight,
                                            [&](double candidate) { return try_value(group, variable, candidate, q); });
        set_with_followers(hand_.tree, variable, best, q);
      }
      const double before = std::exchange(value, openness(group, q));
      if (!(value > before + kGain)) return value;
    }
  }

  /// Designers put "open" at zero: zero is taken where it costs next to nothing, joint by joint, and what one joint
  /// costs is not there for the next.
  void settle(const FingerGroup& group, std::vector<double>& q) const {
    double lowest = openness(group, q);
    for (int finger : group.fingers) lowest -= finger == thumb_ ? kThumbSnapTolerance : kSnapTolerance;
    for (int variable : group.variables) {
      const double left = openness(group, q) - lowest;
      const double value = preferred_value(
          hand_.tree.joints[variable], left, motion_.zero_is_straight,
          [&, trial = q](double candidate) mutable { return try_value(group, variable, candidate, trial); });
      set_with_followers(hand_.tree, variable, value, q);
    }
  }

  const HandSkeleton& hand_;
  const HandMotion& motion_;
  const std::vector<BaseAngle>& bases_;
  int thumb_;
  const PalmNormal& normal_;
  std::vector<double> length_;  ///< one a finger
};

}  // namespace

std::vector<double> find_open_pose(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended,
                                   int thumb, const PalmNormal& normal, Bases bases) {
  const OpenPoseSearch search(hand, motion, extended, thumb, normal);
  std::vector<double> q = extended.q;
  for (const FingerGroup& group : search.groups(bases)) search.open(group, q);
  return q;
}

}  // namespace uhas
