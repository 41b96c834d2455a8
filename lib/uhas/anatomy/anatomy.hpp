// Anatomy: which parts of a kinematic tree are palm, fingers, fingertips, thumb; how the open hand stands
// (docs/method.md#anatomy).
// From here on every stage works in the frame P of the palm link with the joints of the fingers only.
#pragma once

#include <string>
#include <vector>

#include "uhas/anatomy/hand_config.hpp"
#include "uhas/model/hand_model.hpp"

namespace uhas {

/// One finger, root to tip.
struct FingerAnatomy {
  std::vector<int> joints;   ///< indices into `Anatomy::tree`, root to tip, mimic followers and shared joints included
  int tip_link = -1;         ///< index into `Anatomy::links`
  Vector3d p_tip_link;       ///< fingertip in the tip link's frame (m)
  Vector3d pad_normal_link;  ///< outward normal of the pad, unit, tip link's frame
};

/// The hand, seen from its palm.
struct Anatomy {
  std::string hand;
  std::string root_link, palm_link;
  RigidTransformd T_root_palm;  ///< non-finger joints at zero clipped to their limits

  KinematicTree tree;  ///< joints of the fingers and the masters they mimic, in the model's order; root frame P.
                       ///< Every limit is finite: a continuous joint has q_open -+ pi
  std::vector<std::string> other_joints;  ///< every other movable joint of the URDF
  std::vector<ProfileLink> links;         ///< links carried by the palm or by a joint of `tree`
  std::vector<int> model_links;           ///< links[i] is HandModel::links[model_links[i]]

  std::vector<FingerAnatomy> fingers;
  int thumb = -1;   ///< index into `fingers`; -1 = no thumb
  int middle = -1;  ///< index into `fingers`; -1 = no middle finger
  Handedness handedness = Handedness::none;
  Vector3d palm_normal_palm;   ///< outward palm normal, unit, in P
  Vector3d palm_normal_root;   ///< the same in the root link's frame, of which palm_normal_palm is computed
  std::vector<double> q_open;  ///< one value a joint of `tree`: fingers extended, pads toward the palm normal

  std::vector<HandFinding> findings;
  std::vector<std::string> warnings;
};

/// Infers the anatomy; `config` overrides item by item.
/// Throws Error(invalid_hand) when no hand can be found, Error(invalid_config) when the config names what the model
/// lacks or what is no hand.
Anatomy infer_anatomy(const HandModel& model, const HandConfig& config = {});

}  // namespace uhas
