#include "uhas/anatomy/anatomy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "uhas/anatomy/digits_detail.hpp"
#include "uhas/anatomy/fingertip_detail.hpp"
#include "uhas/anatomy/open_pose_detail.hpp"
#include "uhas/anatomy/palm_plane.hpp"
#include "uhas/anatomy/palm_tree_detail.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/runtime/forward_kinematics.hpp"

namespace uhas {
namespace {

/// A thumb whose root and tip are within 20 degrees of straight ahead or straight against the fingers makes neither a
/// right nor a left hand.
constexpr double kHandedAzimuth = 20 * std::numbers::pi / 180;

double root_azimuth(const PalmPlane& plane, int finger) {
  const Vector3d p = plane.roots[finger] - plane.center;
  return std::atan2(dot(p, plane.y), dot(p, plane.x));
}

/// How far an azimuth is from straight ahead and from straight back (rad).
double angle_aside(double azimuth) { return std::min(std::abs(azimuth), std::numbers::pi - std::abs(azimuth)); }

class AnatomyInference {
 public:
  AnatomyInference(const HandModel& model, const HandConfig& config) : model_(model), config_(config) {}

  Anatomy infer() {
    find_chains();
    find_tips();
    start_pose();
    find_motion();
    find_open_hand();
    name_digits();
    finish_limits();
    return std::move(anatomy_);
  }

 private:
  /// Records what was found; below 0.5 the user is told which config key settles it.
  void note(const std::string& item, const std::string& value, const std::string& reason, double confidence,
            const std::string& key) {
    anatomy_.findings.push_back({item, value, reason, confidence});
    if (confidence < 0.5)
      anatomy_.warnings.push_back("doubtful " + item + ": " + value + " (" + reason + "); set \"" + key +
                                  "\" in a hand config if it is wrong");
  }

  std::size_t count() const { return anatomy_.fingers.size(); }

  std::string describe(int finger) const {
    const std::vector<int>& joints = anatomy_.fingers[finger].joints;
    return anatomy_.tree.joints[joints.front()].name + " .. " + anatomy_.tree.joints[joints.back()].name;
  }

  void find_chains() {
    const FingerChains found = find_finger_chains(model_, config_.palm_link);
    anatomy_ = make_palm_tree(model_, found);
    const std::string fingers = std::to_string(count());
    note("palm_link", anatomy_.palm_link,
         config_.palm_link ? "set by the config" : "the lowest group of links in which all long chains of joints meet",
         config_.palm_link ? 1 : found.palm_margin, "palm_link");
    note("fingers", fingers + " fingers",
         "branches of movable joints from the palm, each as long as a finger" +
             std::string(anatomy_.other_joints.empty() ? ""
                                                       : "; " + std::to_string(anatomy_.other_joints.size()) +
                                                             " other joints are above the palm or too short"),
         0.4 + 0.6 * found.chain_margin, "palm_link");
  }

  void find_tips() {
    double confidence = 1;
    std::string reason;
    for (FingerAnatomy& finger : anatomy_.fingers) {
      const Fingertip tip = find_fingertip(model_, anatomy_, finger);
      finger.tip_link = tip.link;
      finger.p_tip_link = tip.p_link;
      if (tip.confidence < confidence || reason.empty()) reason = tip.reason;
      confidence = std::min(confidence, tip.confidence);
    }
    note("fingertips", "one a finger", reason, confidence, "palm_link");
  }

  /// Everything at mid range, but for the joints that the config sets.
  void start_pose() {
    const KinematicTree& tree = anatomy_.tree;
    for (const Joint& joint : tree.joints) q_.push_back(mid_range(joint));
    held_.assign(tree.joints.size(), false);
    for (const auto& [name, value] : config_.q_open) {
      const auto joint = std::find_if(tree.joints.begin(), tree.joints.end(),
                                      [&name = name](const Joint& j) { return j.name == name; });
      if (joint == tree.joints.end())
        throw Error(ErrorCode::invalid_config, "", "q_open: no finger has a joint \"" + name + "\"",
                    "name a joint of a finger");
      if (joint->mimic_master >= 0)
        throw Error(ErrorCode::invalid_config, "",
                    "q_open: joint \"" + name + "\" mimics \"" + tree.joints[joint->mimic_master].name + "\"",
                    "set that joint");
      if (value < joint->lower || value > joint->upper)
        throw Error(ErrorCode::invalid_config, "",
                    "q_open: " + std::to_string(value) + " is outside the limits of \"" + name + "\"",
                    "stay within the limits of the URDF");
      const auto index = static_cast<std::size_t>(joint - tree.joints.begin());
      held_[index] = true;
      q_[index] = value;
    }
    apply_mimics(tree, q_);
  }

  void find_motion() {
    Vector3d center;
    for (const FingerAnatomy& finger : anatomy_.fingers) {
      flexions_.push_back(find_flexion(anatomy_, finger));
      center += flexion_origin(anatomy_, finger, flexions_.back()) / static_cast<double>(count());
      mean_length_ += finger_length(anatomy_, finger) / static_cast<double>(count());
    }
    for (std::size_t i = 0; i < count(); ++i) find_closing_side(anatomy_, anatomy_.fingers[i], center, flexions_[i]);
    agree_on_closing_side(anatomy_, flexions_);
    extend_fingers();
  }

  /// Straightens every finger for the present values of its side joints.
  void extend_fingers() {
    known_base_.clear();
    for (std::size_t i = 0; i < count(); ++i) {
      std::vector<double> extended = q_;
      known_base_.push_back(extend_finger(anatomy_, anatomy_.fingers[i], flexions_[i], extended));
      for (int joint : anatomy_.fingers[i].joints)
        if (const int variable = variable_of(anatomy_.tree, joint); !held_[variable]) q_[variable] = extended[variable];
    }
    apply_mimics(anatomy_.tree, q_);
  }

  std::vector<FingerPosture> measure_postures() {
    std::vector<FingerPosture> postures;
    for (std::size_t i = 0; i < count(); ++i)
      postures.push_back(measure_posture(anatomy_, anatomy_.fingers[i], flexions_[i], q_, scratch_));
    return postures;
  }

  /// The palm normal follows from the open fingers, and the open pose from the normal: a few rounds agree.
  void find_open_hand() {
    constexpr int rounds = 3;
    postures_ = measure_postures();
    const Thumb thumb = find_thumb(postures_, mean_length_);
    anatomy_.thumb = thumb.finger;
    note("thumb", thumb.finger < 0 ? "none" : describe(thumb.finger),
         thumb.finger < 0
             ? "no finger stands apart from a row of like fingers"
             : "without it the others are most alike in direction, closing side and place of their knuckles",
         thumb.confidence, "handedness");

    PalmNormal found = find_palm_normal(postures_, thumb.finger);
    if (config_.palm_normal_in_root)
      found.normal = normalized(anatomy_.T_root_palm.rotation.transposed() * *config_.palm_normal_in_root);
    for (int round = 0; round < rounds && !config_.palm_normal_in_root; ++round) {
      q_ = find_open_pose(anatomy_, flexions_, found.normal, Bases::held, q_, held_);
      extend_fingers();
      postures_ = measure_postures();
      found = find_palm_normal(postures_, thumb.finger);
    }
    q_ = find_open_pose(anatomy_, flexions_, found.normal, Bases::searched, q_, held_);
    postures_ = measure_postures();
    anatomy_.palm_normal_palm = found.normal;
    anatomy_.q_open = q_;
    note_normal(found);
    note_open_pose();

    for (std::size_t i = 0; i < count(); ++i) {
      FingerAnatomy& finger = anatomy_.fingers[i];
      pose_finger(anatomy_, finger, q_, scratch_);
      std::vector<RigidTransformd> T_palm_joint(q_.size());
      forward_kinematics(anatomy_.tree, q_, T_palm_joint);
      const RigidTransformd T_palm_tip =
          T_palm_joint[finger.joints.back()] * anatomy_.links[finger.tip_link].T_joint_link;
      finger.pad_normal_link = T_palm_tip.rotation.transposed() * postures_[i].closing;
    }
  }

  void note_normal(const PalmNormal& found) {
    if (config_.palm_normal_in_root)
      return note("palm_normal", "as given", "set by the config", 1, "palm_normal_in_root");
    constexpr double guess = 0.45;  // the angle of the fingers' bases to the palm may be 15 degrees off
    double evidence = 0;
    bool known = false;
    for (std::size_t i = 0; i < count(); ++i) {
      evidence += flexions_[i].evidence / static_cast<double>(count());
      if (static_cast<int>(i) != anatomy_.thumb && known_base_[i]) known = true;
    }
    const double confidence = std::min({found.coherence, 2 * evidence, known ? 1.0 : guess});
    const Vector3d n = anatomy_.T_root_palm.rotation * found.normal;
    const auto number = [](double value) { return std::to_string(value).substr(0, value < 0 ? 6 : 5); };
    note("palm_normal", number(n.x) + " " + number(n.y) + " " + number(n.z) + " in the root frame",
         found.opposing ? "the axis around which opposing fingers close"
                        : "mean direction in which the fingers close, the side of their larger joint ranges",
         confidence, "palm_normal_in_root");
  }

  void note_open_pose() {
    double openness = 1;
    for (std::size_t i = 0; i < count(); ++i) {
      if (static_cast<int>(i) == anatomy_.thumb) continue;
      openness = std::min(openness, dot(postures_[i].closing, anatomy_.palm_normal_palm));
    }
    note("q_open", "fingers extended", "each finger straight in the palm plane with its pad toward the palm normal",
         std::clamp(openness, 0.0, 1.0), "q_open");
  }

  void name_digits() {
    anatomy_.middle = find_middle_finger(postures_, anatomy_.thumb, anatomy_.palm_normal_palm);
    note("middle_finger", anatomy_.middle < 0 ? "none" : describe(anatomy_.middle),
         anatomy_.middle < 0 ? "a hand without a thumb, or with too few fingers beside it"
                             : "second from the thumb across the palm",
         1, "handedness");

    double confidence = 1;
    std::string reason = "no thumb";
    if (anatomy_.thumb >= 0) {
      const PalmPlane plane = measure_palm_plane(anatomy_);
      const double azimuth = plane.azimuth[anatomy_.thumb];
      const double aside = std::max(angle_aside(azimuth), angle_aside(root_azimuth(plane, anatomy_.thumb)));
      if (aside >= kHandedAzimuth) anatomy_.handedness = azimuth < 0 ? Handedness::right : Handedness::left;
      reason = anatomy_.handedness == Handedness::none ? "the thumb stands straight against the fingers"
                                                       : "the side of the middle finger on which the open thumb stands";
      confidence = std::min(1.0, 0.5 + std::abs(aside - kHandedAzimuth) / (2 * kHandedAzimuth));
    }
    if (config_.handedness) {
      anatomy_.handedness = *config_.handedness;
      reason = "set by the config";
      confidence = 1;
    }
    const char* names[] = {"none", "right", "left"};
    note("handedness", names[static_cast<int>(anatomy_.handedness)], reason, confidence, "handedness");
  }

  /// A continuous joint turns half a turn to both sides of open.
  void finish_limits() {
    for (std::size_t i = 0; i < q_.size(); ++i) {
      Joint& joint = anatomy_.tree.joints[i];
      if (joint.kind != JointKind::continuous) continue;
      joint.lower = q_[i] - std::numbers::pi;
      joint.upper = q_[i] + std::numbers::pi;
    }
  }

  const HandModel& model_;
  const HandConfig& config_;
  Anatomy anatomy_;
  double mean_length_ = 0;               ///< of the fingers
  std::vector<Flexion> flexions_;        ///< one a finger
  std::vector<bool> known_base_;         ///< one a finger: the angle of its base to the palm is no guess
  std::vector<FingerPosture> postures_;  ///< one a finger, at `q_`
  std::vector<double> q_;
  std::vector<bool> held_;  ///< joints whose open value the config sets
  FingerPose scratch_;
};

}  // namespace

Anatomy infer_anatomy(const HandModel& model, const HandConfig& config) {
  return AnatomyInference(model, config).infer();
}

}  // namespace uhas
