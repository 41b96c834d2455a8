// Random hands that know their own anatomy: nearly all are read right, and no miss is silent: the hand carries a
// warning that names a key, or the class that is wrong has a small margin. UHAS_SEEDS and UHAS_FIRST_SEED choose
// others; every miss prints its seed.
#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "support/environment.hpp"
#include "support/random_hand.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/classification/closed_pose.hpp"
#include "uhas/classification/closed_pose_finding.hpp"
#include "uhas/classification/joint_classes.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr double kNormalTolerance = 15 * std::numbers::pi / 180;

/// A class with a smaller margin is a doubtful one: either answer is defensible.
constexpr double kDoubtfulMargin = 0.2;

class Judge {
 public:
  explicit Judge(const RandomHand& hand) : hand_(hand) {
    try {
      anatomy_ = infer_anatomy(hand.model);
      findings_ = anatomy_.findings;
      frame_ = compute_sphere_frame(anatomy_);
    } catch (const Error& error) {  // an error is not silent
      misses_ = std::string(" ") + error.what();
      return;
    }
    const std::vector<double> q_closed = find_closed_pose(anatomy_, frame_);
    classes_ = classify_joints(anatomy_, frame_, q_closed);
    findings_.push_back(explain_closed_pose(anatomy_, frame_, classes_, q_closed));
    judge();
  }

  const std::string& misses() const { return misses_; }         ///< in words; empty = all right
  const std::string& silent_misses() const { return silent_; }  ///< those that no doubt goes with
  bool warns() const {
    return !anatomy_.warnings.empty() ||
           std::ranges::any_of(findings_, [](const HandFinding& f) { return f.confidence < 0.5; });
  }

 private:
  void add(const std::string& miss, bool is_doubtful = false) {
    misses_ += " " + miss;
    if (!is_doubtful && !warns()) silent_ += " " + miss;
  }

  /// For each finger of the truth, the finger that has its chain; -1 = none.
  void match_fingers() {
    for (const RandomFinger& truth : hand_.fingers) {
      match_.push_back(-1);
      for (std::size_t j = 0; j < anatomy_.fingers.size(); ++j) {
        std::vector<std::string> chain;
        for (int joint : anatomy_.fingers[j].joints) chain.push_back(anatomy_.tree.joints[joint].name);
        if (chain == truth.joints) match_.back() = static_cast<int>(j);
      }
    }
  }

  void judge() {
    match_fingers();
    const Vector3d normal = anatomy_.T_root_palm.rotation * anatomy_.palm_normal_palm;
    if (dot(normal, hand_.normal_root) < std::cos(kNormalTolerance)) add("normal");
    if (anatomy_.fingers.size() != match_.size() || std::count(match_.begin(), match_.end(), -1) > 0)
      return add("fingers");
    if (hand_.has_thumb && anatomy_.thumb != (*hand_.has_thumb ? match_.back() : -1)) add("thumb");
    if (hand_.handedness && anatomy_.handedness != *hand_.handedness) add("handedness");
    for (std::size_t i = 0; i < match_.size(); ++i) {
      const RandomFinger& truth = hand_.fingers[i];
      if (truth.slot && !frame_.slots[match_[i]][*truth.slot]) add("slot " + std::to_string(*truth.slot));
      for (std::size_t k = 0; k < truth.joints.size(); ++k) {
        const JointClassification& found = classes_[anatomy_.fingers[match_[i]].joints[k]];
        if (truth.classes[k] && found.joint_class != *truth.classes[k])
          add("class of " + truth.joints[k], found.margin < kDoubtfulMargin);
      }
    }
  }

  const RandomHand& hand_;
  Anatomy anatomy_;
  SphereFrame frame_;
  std::vector<JointClassification> classes_;
  std::vector<HandFinding> findings_;
  std::vector<int> match_;
  std::string misses_, silent_;
};

}  // namespace

TEST_CASE("random hands") {
  const std::uint64_t count = number_from_environment("UHAS_SEEDS", 500);
  const std::uint64_t first = number_from_environment("UHAS_FIRST_SEED", 0);
  std::uint64_t missed = 0, silent = 0, falsely_warned = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const RandomHand hand = make_random_hand(seed);
    const Judge judge(hand);
    if (judge.misses().empty()) {
      falsely_warned += judge.warns() ? 1 : 0;
      continue;
    }
    ++missed;
    if (!judge.silent_misses().empty()) ++silent;
    const std::string silence = judge.silent_misses().empty() ? "" : "; silently:" + judge.silent_misses();
    MESSAGE("seed ", seed, ":", judge.misses(), silence);
  }
  MESSAGE(missed, " of ", count, " missed, ", silent, " silently; ", falsely_warned, " right ones carry a warning");
  CHECK(missed * 20 <= count);
  CHECK(silent == 0);
}
