// The hand config: what a user states about a hand instead of having it inferred (schemas/hand-config.schema.json).
#pragma once

#include <map>
#include <optional>
#include <string>

#include "uhas/base/vector3.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// Every key is optional and overrides one inferred item.
struct HandConfig {
  std::optional<std::string> palm_link;
  std::optional<Vector3d> palm_normal_in_root;  ///< outward, any length; root link frame, non-finger joints at zero
  std::optional<Handedness> handedness;
  std::map<std::string, double> q_open;    ///< joint name -> rad or m
  std::map<std::string, double> q_closed;  ///< joint name -> rad or m
};

/// Reads a hand config from a JSON file; "" and absent keys mean "infer".
/// Throws Error: file_unreadable, syntax, invalid_config (an unknown key names the nearest known one).
HandConfig read_hand_config(const std::string& path);

/// The same from JSON text; `file` names its source in errors.
HandConfig parse_hand_config(const std::string& text, const std::string& file);

/// The config as canonical JSON text (sorted keys, no white space): part of the profile's settings.
std::string to_canonical_json(const HandConfig& config);

}  // namespace uhas
