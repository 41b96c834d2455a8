#include "uhas/anatomy/opening/open_pose.hpp"

#include <algorithm>
#include <limits>
#include <utility>

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

std::vector<int> variables_of(const Anatomy& anatomy, int finger) {
  std::vector<int> variables;
  for (int joint : anatomy.fingers[finger].joints) {
    const int variable = variable_of(anatomy.tree, joint);
    if (std::find(variables.begin(), variables.end(), variable) == variables.end()) variables.push_back(variable);
  }
  return variables;
}

std::vector<FingerGroup> group_fingers(const Anatomy& anatomy) {
  std::vector<FingerGroup> groups;
  for (int finger = 0; finger < static_cast<int>(anatomy.fingers.size()); ++finger) {
    FingerGroup merged{{finger}, variables_of(anatomy, finger)};
    std::erase_if(groups, [&](const FingerGroup& group) {
      const bool shares = std::any_of(group.variables.begin(), group.variables.end(), [&](int variable) {
        return std::find(merged.variables.begin(), merged.variables.end(), variable) != merged.variables.end();
      });
      if (!shares) return false;
      merged.fingers.insert(merged.fingers.end(), group.fingers.begin(), group.fingers.end());
      for (int variable : group.variables)
        if (std::find(merged.variables.begin(), merged.variables.end(), variable) == merged.variables.end())
          merged.variables.push_back(variable);
      return true;
    });
    groups.push_back(std::move(merged));
  }
  return groups;
}

class OpenPoseSearch {
 public:
  OpenPoseSearch(const Anatomy& anatomy, std::span<const Flexion> flexions, const PalmNormal& normal,
                 bool zero_is_neutral, const std::vector<bool>& held)
      : anatomy_(anatomy),
        flexions_(flexions),
        normal_(normal.normal),
        opposing_(normal.opposing),
        zero_is_neutral_(zero_is_neutral),
        held_(held) {
    for (const FingerAnatomy& finger : anatomy.fingers) length_.push_back(finger_length(anatomy, finger));
  }

  /// The groups of fingers that are opened together, with the variables to find. A gripper's fingers open by flexion
  /// alone: one that cannot lie flat would lean to its side for that.
  std::vector<FingerGroup> groups(Bases bases) const {
    std::vector<FingerGroup> groups = group_fingers(anatomy_);
    for (FingerGroup& group : groups)
      std::erase_if(group.variables, [&](int variable) {
        const bool is_base = is_base_flexion(group, variable);
        return held_[variable] || stays_extended(group, variable) || (is_base ? bases == Bases::held : opposing_);
      });
    return groups;
  }

  void open(const FingerGroup& group, std::vector<double>& q) {
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
  double openness(const FingerGroup& group, std::span<const double> q) {
    double sum = 0;
    for (int finger : group.fingers) {
      const FingerPosture posture = measure_posture(anatomy_, anatomy_.fingers[finger], flexions_[finger], q, scratch_);
      sum +=
          norm(orthogonal_part(posture.tip - posture.root, normal_)) / length_[finger] + dot(posture.closing, normal_);
    }
    return sum;
  }

  double try_value(const FingerGroup& group, int variable, double value, std::span<double> q) {
    set_joint(anatomy_.tree, variable, value, q);
    return openness(group, q);
  }

  /// Distal flexion joints, a thumb's flexion joints and sliding jaws are open where `q` has them: straight, or at the
  /// end. What is left to find are side and roll joints, the angle of a finger's base to the palm, and that of a
  /// thumb's when it is a guess.
  bool stays_extended(const FingerGroup& group, int variable) const {
    for (int finger : group.fingers) {
      const Flexion& flexion = flexions_[finger];
      const bool thumb_stays = finger == anatomy_.thumb && !flexion.base_is_guess;
      const std::size_t from = thumb_stays || flexion.sliding ? 0 : 1;
      for (std::size_t i = from; i < flexion.positions.size(); ++i)
        if (variable_of(anatomy_.tree, anatomy_.fingers[finger].joints[flexion.positions[i]]) == variable) return true;
    }
    return false;
  }

  bool is_base_flexion(const FingerGroup& group, int variable) const {
    return std::any_of(group.fingers.begin(), group.fingers.end(), [&](int finger) {
      const int joint = anatomy_.fingers[finger].joints[flexions_[finger].positions.front()];
      return variable_of(anatomy_.tree, joint) == variable;
    });
  }

  /// `q` and every combination of low, middle and high values of the first side joints.
  std::vector<std::vector<double>> starts(const FingerGroup& group, const std::vector<double>& q) const {
    std::vector<std::vector<double>> starts = {q};
    std::size_t varied = 0;
    for (int variable : group.variables) {
      if (is_base_flexion(group, variable) || varied++ == kMaxStartJoints) continue;
      const Joint& joint = anatomy_.tree.joints[variable];
      const std::size_t count = starts.size();
      for (std::size_t i = 0; i < count; ++i) {
        for (double value : {joint.lower, joint.upper}) {
          starts.push_back(starts[i]);
          set_joint(anatomy_.tree, variable, value, starts.back());
        }
      }
    }
    return starts;
  }

  /// Coordinate ascent; every joint scans its whole range.
  double climb(const FingerGroup& group, std::vector<double>& q) {
    double value = openness(group, q);
    for (;;) {
      for (int variable : group.variables) {
        const double best = preferred_value(anatomy_.tree.joints[variable], kGain, zero_is_neutral_,
                                            [&](double candidate) { return try_value(group, variable, candidate, q); });
        set_joint(anatomy_.tree, variable, best, q);
      }
      const double before = std::exchange(value, openness(group, q));
      if (!(value > before + kGain)) return value;
    }
  }

  /// Designers put "open" at zero: zero is taken where it costs next to nothing, by base flexion joints or
  /// by all others.
  void settle(const FingerGroup& group, std::vector<double>& q) {
    double lowest = openness(group, q);
    for (int finger : group.fingers) lowest -= finger == anatomy_.thumb ? kThumbSnapTolerance : kSnapTolerance;
    for (int variable : group.variables) {
      const double best = openness(group, q);
      const double value = preferred_value(
          anatomy_.tree.joints[variable], best - lowest, zero_is_neutral_,
          [&, trial = q](double candidate) mutable { return try_value(group, variable, candidate, trial); });
      set_joint(anatomy_.tree, variable, value, q);
    }
  }

  const Anatomy& anatomy_;
  std::span<const Flexion> flexions_;
  Vector3d normal_;
  bool opposing_;
  bool zero_is_neutral_;
  const std::vector<bool>& held_;
  std::vector<double> length_;
  FingerPose scratch_;
};

}  // namespace

std::vector<double> find_open_pose(const Anatomy& anatomy, std::span<const Flexion> flexions, const PalmNormal& normal,
                                   bool zero_is_neutral, Bases bases, std::vector<double> q,
                                   const std::vector<bool>& held) {
  OpenPoseSearch search(anatomy, flexions, normal, zero_is_neutral, held);
  for (const FingerGroup& group : search.groups(bases)) search.open(group, q);
  return q;
}

}  // namespace uhas
