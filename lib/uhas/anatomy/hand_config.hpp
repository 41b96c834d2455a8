// The hand config: what a user states about a hand instead of having it inferred (schemas/hand-config.schema.json).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "uhas/base/export.hpp"
#include "uhas/base/vector3.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// The reason of a finding whose item the config states.
inline constexpr const char* kStatedInConfig = "stated in the hand config";

/// The warning about a finding with a confidence below 0.5, which names the key to set; "" for any other.
UHAS_API std::string doubt(const HandFinding& finding);

/// The tip of the finger whose last joint carries `link`.
struct StatedFingertip {
  std::string link;
  std::optional<Vector3d> point;       ///< in the link's frame (m); else the far end of its surface, or its origin
  std::optional<Vector3d> pad_normal;  ///< outward, any length, in the link's frame; else the way the finger closes
};

struct StatedLimits {
  double lower = 0, upper = 0;  ///< rad or m; lower < upper
};

/// Every key is optional and overrides one inferred item; the names are those of the JSON keys and of the findings.
struct HandConfig {
  std::string file;  ///< where it was read: errors begin with it; not part of what is stated

  std::optional<std::string> palm_link;
  std::optional<Vector3d> palm_normal_in_root;    ///< outward, any length; root link frame, non-finger joints at zero
  std::vector<std::vector<std::string>> fingers;  ///< every joint of each finger, root to tip; empty = infer
  std::vector<StatedFingertip> fingertips;        ///< of some fingers or of all, in any order
  std::optional<std::string> thumb;               ///< a joint of that finger alone; "" = the hand has no thumb
  std::optional<std::string> middle_finger;       ///< a joint of that finger alone; "" = the hand has none
  std::optional<Handedness> handedness;
  std::map<std::string, double> q_open;              ///< independent joint -> rad or m
  std::map<std::string, double> q_closed;            ///< independent joint -> rad or m
  std::map<std::string, StatedLimits> joint_limits;  ///< joint -> limits within those of the URDF
};

inline constexpr std::uint64_t kMaxHandConfigBytes = 1u << 20;

/// Reads a hand config from a JSON file of at most `max_bytes`; absent keys, and "" for a link or a
/// handedness, mean "infer".
/// Throws Error: file_unreadable, limit_exceeded, syntax, unsupported_version, invalid_config (an unknown key names the
/// nearest known one).
UHAS_API HandConfig read_hand_config(const std::string& path, std::uint64_t max_bytes = kMaxHandConfigBytes);

/// The same from JSON text; `file` names its source in errors.
UHAS_API HandConfig parse_hand_config(const std::string& text, const std::string& file);

/// The config as canonical JSON text (sorted keys, no white space): part of the profile's settings.
UHAS_API std::string to_canonical_json(const HandConfig& config);

}  // namespace uhas
