#include "uhas/anatomy/anatomy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "uhas/anatomy/config_names.hpp"
#include "uhas/anatomy/fingers/digits.hpp"
#include "uhas/anatomy/fingers/fingertip.hpp"
#include "uhas/anatomy/opening/extension.hpp"
#include "uhas/anatomy/opening/open_pose.hpp"
#include "uhas/anatomy/palm/normal_error.hpp"
#include "uhas/anatomy/palm/palm_slab.hpp"
#include "uhas/anatomy/palm/palm_tree.hpp"
#include "uhas/anatomy/palm_plane.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"

namespace uhas {
namespace {

/// A thumb whose root and tip are within 20 degrees of straight ahead or straight against the fingers makes neither a
/// right nor a left hand.
constexpr double kHandedAzimuth = 20 * std::numbers::pi / 180;

/// A palm normal with a standard error of 12 degrees has confidence 0.5: one of five such is off by 15 degrees or more.
constexpr double kDoubtfulError = 12 * std::numbers::pi / 180;

/// From this margin on the side to which a thumb closes is clear; the largest is 2.
constexpr double kClearThumbSide = 0.6;

double root_azimuth(const PalmPlane& plane, int finger) {
  const Vector3d p = plane.roots[finger] - plane.center;
  return std::atan2(dot(p, plane.y), dot(p, plane.x));
}

std::string count_joints(std::size_t count) { return std::to_string(count) + (count == 1 ? " joint" : " joints"); }

/// The unit vector along `direction`. One that is unit already keeps its bits, so that a written config states what
/// was inferred exactly.
Vector3d unit_direction(Vector3d direction) {
  constexpr double rounding = 1e-14;
  return std::abs(norm(direction) - 1) <= rounding ? direction : normalized(direction);
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
  /// Records what was found; `item` is the config key that overrides it.
  void note(const std::string& item, const std::string& value, const std::string& reason, double confidence) {
    anatomy_.findings.push_back({item, value, reason, confidence});
    if (const std::string warning = doubt(anatomy_.findings.back()); !warning.empty())
      anatomy_.warnings.push_back(warning);
  }

  std::size_t count() const { return anatomy_.fingers.size(); }

  std::string describe(int finger) const {
    const std::vector<int>& joints = anatomy_.fingers[finger].joints;
    return anatomy_.tree.joints[joints.front()].name + " .. " + anatomy_.tree.joints[joints.back()].name;
  }

  /// The finger of which the config names a joint; -1 when it says that there is none.
  int find_stated_finger(const std::string& joint_name, const std::string& key) const {
    if (joint_name.empty()) return -1;
    const int joint = find_joint(anatomy_.tree, joint_name, config_, key, "no finger has a joint");
    int found = -1;
    for (std::size_t i = 0; i < count(); ++i) {
      if (std::ranges::find(anatomy_.fingers[i].joints, joint) == anatomy_.fingers[i].joints.end()) continue;
      if (found >= 0)
        refuse_config(config_, key, "several fingers have the joint \"" + joint_name + "\"",
                      "name a joint further out");
      found = static_cast<int>(i);
    }
    if (found < 0)
      refuse_config(config_, key, "\"" + joint_name + "\" only drives joints of fingers", "name a joint of a finger");
    return found;
  }

  void find_chains() {
    const FingerChains found = find_finger_chains(model_, config_);
    anatomy_ = make_palm_tree(model_, found, config_);
    if (!config_.joint_limits.empty())
      note("joint_limits", count_joints(config_.joint_limits.size()) + " narrowed", kStatedInConfig, 1);
    note("palm_link", anatomy_.palm_link,
         config_.palm_link ? kStatedInConfig : "the lowest group of links in which all long chains of joints meet",
         config_.palm_link ? 1 : found.palm_margin);
    const std::string fingers = std::to_string(count()) + " fingers";
    if (!config_.fingers.empty()) return note("fingers", fingers, kStatedInConfig, 1);
    note("fingers", fingers,
         "branches of movable joints from the palm, each as long as a finger" +
             std::string(anatomy_.other_joints.empty() ? ""
                                                       : "; " + std::to_string(anatomy_.other_joints.size()) +
                                                             " other joints are above the palm or too short"),
         0.4 + 0.6 * found.chain_margin);
  }

  void find_tips() {
    stated_tips_ = find_stated_fingertips(anatomy_, config_);
    double confidence = 1;
    std::string reason = kStatedInConfig;
    for (std::size_t i = 0; i < count(); ++i) {
      FingerAnatomy& finger = anatomy_.fingers[i];
      const Fingertip tip = find_fingertip(model_, anatomy_, finger, stated_tips_[i]);
      finger.tip_link = tip.link;
      finger.p_tip_link = tip.p_link;
      if (tip.confidence < confidence) reason = tip.reason;
      confidence = std::min(confidence, tip.confidence);
    }
    note("fingertips", "one a finger", reason, confidence);
  }

  /// Everything at mid range, but for the joints that the config sets.
  void start_pose() {
    const KinematicTree& tree = anatomy_.tree;
    const std::vector<std::optional<double>> stated = resolve_joint_values(tree, config_.q_open, config_, "q_open");
    for (std::size_t i = 0; i < stated.size(); ++i) {
      held_.push_back(stated[i].has_value());
      q_.push_back(stated[i].value_or(mid_range(tree.joints[i])));
    }
    apply_mimics(tree, q_);
  }

  void find_motion() {
    Vector3d center;
    for (const FingerAnatomy& finger : anatomy_.fingers) {
      flexions_.push_back(find_flexion(anatomy_, finger));
      center += flexion_origin(anatomy_, finger, flexions_.back()) / static_cast<double>(count());
      const double length = finger_length(anatomy_, finger);
      if (!(length > 0))
        throw Error(ErrorCode::invalid_hand, "",
                    "the finger of joint '" + anatomy_.tree.joints[finger.joints.back()].name +
                        "' has no length: its tip lies on its joints",
                    "give its last link geometry, or name the joints of each finger by \"fingers\" in a hand config");
      mean_length_ += length / static_cast<double>(count());
    }
    zero_is_straight_ = are_straight_at_zero();
    for (std::size_t i = 0; i < count(); ++i)
      find_closing_side(anatomy_, anatomy_.fingers[i], center, zero_is_straight_, flexions_[i]);
    agree_on_closing_side(anatomy_, flexions_);
    slab_ = find_palm_slab(model_, anatomy_, center);
    extend_fingers();
  }

  /// Straightens every finger for the present values of its side joints; what several fingers share stands in the
  /// middle of what they want.
  void extend_fingers() {
    const BaseEvidence evidence = {zero_is_straight_, slab_};
    std::vector<double> sum(q_.size(), 0.0), wanted(q_.size(), 0.0);
    for (std::size_t i = 0; i < count(); ++i) {
      std::vector<double> extended = q_;
      extend_finger(anatomy_, anatomy_.fingers[i], evidence, flexions_[i], extended);
      const int base = anatomy_.fingers[i].joints[flexions_[i].positions.front()];
      if (held_[variable_of(anatomy_.tree, base)]) flexions_[i].base_error = 0, flexions_[i].base_is_guess = false;
      for (int joint : anatomy_.fingers[i].joints) {
        const int variable = variable_of(anatomy_.tree, joint);
        sum[variable] += extended[variable];
        ++wanted[variable];
      }
    }
    for (std::size_t i = 0; i < q_.size(); ++i)
      if (wanted[i] > 0 && !held_[i]) q_[i] = sum[i] / wanted[i];
    apply_mimics(anatomy_.tree, q_);
  }

  /// Whether most of the fingers whose phalanges can tell are straight at zero.
  bool are_straight_at_zero() const {
    int votes = 0;
    for (std::size_t i = 0; i < count(); ++i)
      if (const auto straight = is_straight_at_zero(anatomy_, anatomy_.fingers[i], flexions_[i], q_))
        votes += *straight ? 1 : -1;
    return votes > 0;
  }

  std::vector<FingerPosture> measure_postures() {
    std::vector<FingerPosture> postures;
    for (std::size_t i = 0; i < count(); ++i)
      postures.push_back(measure_posture(anatomy_, anatomy_.fingers[i], flexions_[i], q_, scratch_));
    return postures;
  }

  /// Where the designer put straight fingers at zero, other joints are neutral there too.
  void start_at_zero() {
    const std::vector<Joint>& joints = anatomy_.tree.joints;
    for (std::size_t i = 0; i < q_.size(); ++i)
      if (!held_[i] && joints[i].lower <= 0 && joints[i].upper >= 0) q_[i] = 0;
    extend_fingers();
  }

  /// The palm normal follows from the open fingers, and the open pose from the normal: a few rounds agree.
  void find_open_hand() {
    constexpr int rounds = 3;
    postures_ = measure_postures();
    choose_thumb();

    PalmNormal found = find_palm_normal(postures_, anatomy_.thumb);
    if (found.opposing && zero_is_straight_) {
      start_at_zero();
      postures_ = measure_postures();
      found = find_palm_normal(postures_, anatomy_.thumb);
    }
    if (config_.palm_normal_in_root) found.normal = set_normal(*config_.palm_normal_in_root);
    for (int round = 0; round < rounds && !config_.palm_normal_in_root; ++round) {
      q_ = find_open_pose(anatomy_, flexions_, found, zero_is_straight_, Bases::held, q_, held_);
      extend_fingers();
      postures_ = measure_postures();
      found = find_palm_normal(postures_, anatomy_.thumb);
    }
    turn_thumb_to(found.normal);
    q_ = find_open_pose(anatomy_, flexions_, found, zero_is_straight_, Bases::searched, q_, held_);
    postures_ = measure_postures();
    if (!config_.palm_normal_in_root) set_normal(anatomy_.T_root_palm.rotation * found.normal);
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
      finger.pad_normal_link = stated_tips_[i] && stated_tips_[i]->pad_normal
                                   ? unit_direction(*stated_tips_[i]->pad_normal)
                                   : T_palm_tip.rotation.transposed() * postures_[i].closing;
    }
  }

  /// A thumb closes to the side that faces the palm normal, when that tells more than the ranges of its joints.
  void turn_thumb_to(Vector3d normal) {
    if (anatomy_.thumb < 0) return;
    Flexion& flexion = flexions_[anatomy_.thumb];
    const auto facing = [&] { return dot(measure_postures()[anatomy_.thumb].closing, normal); };
    const double before = facing();
    flexion.closing_sign = -flexion.closing_sign;
    extend_fingers();
    const double gain = (facing() - before) / 2;
    thumb_side_margin_ = std::abs(gain - flexion.evidence);
    if (gain > flexion.evidence) return;
    flexion.closing_sign = -flexion.closing_sign;
    extend_fingers();
  }

  void choose_thumb() {
    const Thumb found = find_thumb(postures_, mean_length_);
    anatomy_.thumb = config_.thumb ? find_stated_finger(*config_.thumb, "thumb") : found.finger;
    const std::string value = anatomy_.thumb < 0 ? "none" : describe(anatomy_.thumb);
    if (config_.thumb) return note("thumb", value, kStatedInConfig, 1);
    note("thumb", value,
         found.finger < 0
             ? "no finger stands apart from a row of like fingers"
             : "without it the others are most alike in direction, closing side and place of their knuckles",
         found.confidence);
  }

  /// Sets the palm normal by its direction in the root frame; returns it in P.
  Vector3d set_normal(Vector3d direction_root) {
    anatomy_.palm_normal_root = unit_direction(direction_root);
    anatomy_.palm_normal_palm = anatomy_.T_root_palm.rotation.transposed() * anatomy_.palm_normal_root;
    return anatomy_.palm_normal_palm;
  }

  void note_normal(const PalmNormal& found) {
    const Vector3d n = anatomy_.palm_normal_root;
    const auto number = [](double component) {
      const double rounded = std::round(1000 * component) / 1000 + 0.0;  // never -0
      return std::to_string(rounded).substr(0, rounded < 0 ? 6 : 5);
    };
    const std::string value = number(n.x) + " " + number(n.y) + " " + number(n.z);
    if (config_.palm_normal_in_root) return note("palm_normal_in_root", value, kStatedInConfig, 1);
    double evidence = 0;
    for (const Flexion& flexion : flexions_) evidence += flexion.evidence / static_cast<double>(count());
    const NormalWitnesses witnesses = {flexions_, postures_, slab_, zero_is_straight_};
    const double error = palm_normal_error(anatomy_, found, witnesses, q_) / kDoubtfulError;
    const double confidence = found.coherence * std::min(1.0, 2 * evidence) / (1 + error * error);
    note("palm_normal_in_root", value,
         found.opposing ? "the axis around which opposing fingers close"
                        : "mean direction in which the fingers close, the side of their larger joint ranges",
         confidence);
  }

  void note_open_pose() {
    double openness = 1;
    for (std::size_t i = 0; i < count(); ++i) {
      if (static_cast<int>(i) == anatomy_.thumb) continue;
      openness = std::min(openness, dot(postures_[i].closing, anatomy_.palm_normal_palm));
    }
    std::size_t independent = 0;
    for (const Joint& joint : anatomy_.tree.joints) independent += joint.mimic_master < 0 ? 1 : 0;
    if (config_.q_open.size() == independent) return note("q_open", "fingers extended", kStatedInConfig, 1);
    note("q_open", "fingers extended",
         "each finger straight in the palm plane with its pad toward the palm normal" +
             (config_.q_open.empty() ? std::string()
                                     : "; " + count_joints(config_.q_open.size()) + " " + kStatedInConfig),
         std::clamp(std::min(openness, thumb_side_margin_ / kClearThumbSide), 0.0, 1.0));
  }

  void name_digits() {
    choose_middle_finger();

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
      reason = kStatedInConfig;
      confidence = 1;
    }
    const char* names[] = {"none", "right", "left"};
    note("handedness", names[static_cast<int>(anatomy_.handedness)], reason, confidence);
  }

  void choose_middle_finger() {
    anatomy_.middle = config_.middle_finger ? find_stated_finger(*config_.middle_finger, "middle_finger")
                                            : find_middle_finger(postures_, anatomy_.thumb, anatomy_.palm_normal_palm);
    if (anatomy_.middle >= 0 && anatomy_.middle == anatomy_.thumb)
      refuse_config(config_, "middle_finger", describe(anatomy_.thumb) + " is the thumb",
                    "name another finger, or set \"thumb\"");
    note("middle_finger", anatomy_.middle < 0 ? "none" : describe(anatomy_.middle),
         config_.middle_finger ? kStatedInConfig
         : anatomy_.middle < 0 ? "a hand without a thumb, or with too few fingers beside it"
                               : "second from the thumb across the palm",
         1);
  }

  /// A continuous joint turns half a turn to both sides of open.
  void finish_limits() {
    for (std::size_t i = 0; i < q_.size(); ++i) {
      Joint& joint = anatomy_.tree.joints[i];
      if (joint.kind != JointKind::continuous || config_.joint_limits.contains(joint.name)) continue;
      joint.lower = q_[i] - std::numbers::pi;
      joint.upper = q_[i] + std::numbers::pi;
    }
  }

  const HandModel& model_;
  const HandConfig& config_;
  Anatomy anatomy_;
  double mean_length_ = 0;                           ///< of the fingers
  std::vector<const StatedFingertip*> stated_tips_;  ///< one a finger; null = inferred
  std::vector<Flexion> flexions_;                    ///< one a finger
  bool zero_is_straight_ = false;                    ///< the hand's designer put straight fingers at zero
  std::optional<PalmSlab> slab_;
  double thumb_side_margin_ = 1;         ///< 0..1: how clearly the thumb closes to one side
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
