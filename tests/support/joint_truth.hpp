// What is true of a joint by the rule that the real hands' truth.json follows: the part of the fingertip's squared
// speed that goes around the palm normal. It shares no code with the classification under test.
#pragma once

#include <optional>
#include <string>

#include "support/random_hand.hpp"

namespace uhas::test {

/// Mean of the fingers' first joint origins with every joint at zero, in the root frame (m).
Vector3d palm_center(const HandModel& model, const RandomHand& hand);

/// The fingertip with every joint at zero, in the root frame (m).
Vector3d tip_at_zero(const HandModel& model, const RandomFinger& finger);

/// The class of `joint` on a hand that is open at zero, or nothing where either is right. The share is averaged over a
/// sweep of 0.5 rad to both sides: lateral above 0.6, encompassing under 0.4. A joint that moves its tip at less than
/// 0.2 times its distance is judged with the joints further out flexed to 30 % of their limits, from 0.4 on with them
/// straight; between these both must agree. A joint whose axis goes through its fingertip has no class.
/// @param normal  palm normal in the root frame
std::optional<JointClass> class_at_zero(const HandModel& model, const RandomHand& hand, const std::string& joint,
                                        Vector3d normal);

}  // namespace uhas::test
