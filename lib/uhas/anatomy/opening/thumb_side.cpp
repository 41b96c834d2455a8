#include "uhas/anatomy/opening/thumb_side.hpp"

#include <cmath>
#include <utility>

namespace uhas {

TurnedThumb turn_thumb(const HandSkeleton& hand, const HandMotion& motion, const ExtendedHand& extended, int thumb,
                       Vector3d palm_normal) {
  if (thumb < 0) return {motion, extended};

  // the same hand with a thumb that closes to the other side
  HandMotion other_motion = motion;
  other_motion.flexions[thumb].closing.sign *= -1;
  ExtendedHand other = extend_hand(hand, other_motion, extended.q);

  // what its pad gains in facing the normal, -1..1, against what the ranges of its joints say for this side, 0..1
  const auto facing = [&](const ExtendedHand& of) { return dot(of.postures[thumb].closing, palm_normal); };
  const double gain = (facing(other) - facing(extended)) / 2;
  const double evidence = motion.flexions[thumb].closing.evidence, margin = std::abs(gain - evidence);
  if (gain > evidence) return {std::move(other_motion), std::move(other), margin};
  return {motion, extend_hand(hand, motion, other.q), margin};
}

}  // namespace uhas
