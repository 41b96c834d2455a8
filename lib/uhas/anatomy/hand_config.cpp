#include "uhas/anatomy/hand_config.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "uhas/anatomy/nearest_name.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/json/json_text.hpp"

namespace uhas {
namespace {

constexpr const char* kFormat = "uhas-hand-config";
constexpr int kVersion = 1;
constexpr std::array<std::string_view, 13> kKeys = {
    "format",        "version",    "comment", "palm_link", "palm_normal_in_root", "fingers", "fingertips", "thumb",
    "middle_finger", "handedness", "q_open",  "q_closed",  "joint_limits"};
constexpr std::array<std::string_view, 3> kFingertipKeys = {"link", "point", "pad_normal"};

/// Reads the keys of one document; every problem is an Error that names the file and the key.
class ConfigReader {
 public:
  ConfigReader(const Json& document, const std::string& file) : document_(document), file_(file) {
    if (!document.is_object()) refuse("not a JSON object", "");
    check_keys(document, kKeys, "");
    check_format();
  }

  HandConfig read() const {
    HandConfig config;
    config.file = file_;
    if (const std::string palm_link = read_string("palm_link"); !palm_link.empty()) config.palm_link = palm_link;
    if (const Json* normal = find("palm_normal_in_root"))
      config.palm_normal_in_root = to_direction(*normal, "\"palm_normal_in_root\"");
    config.fingers = read_fingers();
    config.fingertips = read_fingertips();
    config.thumb = read_finger_name("thumb");
    config.middle_finger = read_finger_name("middle_finger");
    config.handedness = read_handedness();
    for (const auto& [joint, value] : read_joint_map("q_open"))
      config.q_open[joint] = to_number(value, in_joint("q_open", joint));
    for (const auto& [joint, value] : read_joint_map("q_closed"))
      config.q_closed[joint] = to_number(value, in_joint("q_closed", joint));
    for (const auto& [joint, value] : read_joint_map("joint_limits"))
      config.joint_limits[joint] = to_limits(value, in_joint("joint_limits", joint));
    return config;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    throw Error(ErrorCode::invalid_config, file_, problem, remedy);
  }

  void check_keys(const Json& object, std::span<const std::string_view> known, const std::string& place) const {
    for (const auto& [key, value] : object.items())
      if (std::ranges::find(known, key) == known.end())
        refuse(place + "unknown key \"" + key + "\"", did_you_mean(key, known));
  }

  void check_format() const {
    if (const Json* format = find("format"); format && *format != kFormat)
      refuse("\"format\" is not \"" + std::string(kFormat) + "\"", "give a hand config");
    if (const Json* version = find("version"); version && *version != kVersion)
      throw Error(ErrorCode::unsupported_version, file_,
                  "hand config version " + version->dump() + ", this program reads version " + std::to_string(kVersion),
                  "");
  }

  /// The value at `key`; null pointer when the key is absent.
  const Json* find(const char* key) const {
    const auto entry = document_.find(key);
    return entry == document_.end() ? nullptr : &*entry;
  }

  static std::string quoted(const std::string& key) { return "\"" + key + "\""; }
  static std::string in_joint(const std::string& key, const std::string& joint) {
    return quoted(key) + ": joint " + quoted(joint);
  }

  std::string to_name(const Json& value, const std::string& what) const {
    if (!value.is_string()) refuse(what + " is not a string", "");
    return value.get<std::string>();
  }

  double to_number(const Json& value, const std::string& what) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) refuse(what + " has no finite number", "");
    return value.get<double>();
  }

  Vector3d to_vector(const Json& value, const std::string& what) const {
    const auto is_number = [](const Json& component) { return component.is_number(); };
    if (!value.is_array() || value.size() != 3 || !std::ranges::all_of(value, is_number))
      refuse(what + " is not a vector", "give three numbers, [x, y, z]");
    const Vector3d vector{value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
    if (!is_finite(vector)) refuse(what + " is not finite", "give three finite numbers");
    return vector;
  }

  Vector3d to_direction(const Json& value, const std::string& what) const {
    const Vector3d direction = to_vector(value, what);
    if (!(norm(direction) > 0)) refuse(what + " has no direction", "give a vector that is not zero");
    return direction;
  }

  StatedLimits to_limits(const Json& value, const std::string& what) const {
    if (!value.is_array() || value.size() != 2) refuse(what + " has no limits", "give two numbers, [lower, upper]");
    const StatedLimits limits{to_number(value[0], what), to_number(value[1], what)};
    if (!(limits.lower < limits.upper)) refuse(what + ": the lower limit is not below the upper", "");
    return limits;
  }

  /// The string at `key`; empty when the key is absent.
  std::string read_string(const char* key) const {
    const Json* value = find(key);
    return value ? to_name(*value, quoted(key)) : std::string();
  }

  std::optional<Handedness> read_handedness() const {
    const std::string text = read_string("handedness");
    if (text.empty()) return std::nullopt;
    if (text == "right") return Handedness::right;
    if (text == "left") return Handedness::left;
    if (text == "none") return Handedness::none;
    refuse("\"handedness\" is \"" + text + "\"", "use \"right\", \"left\" or \"none\"");
  }

  /// A joint's name; "" for null, which says that there is no such finger.
  std::optional<std::string> read_finger_name(const char* key) const {
    const Json* value = find(key);
    if (!value) return std::nullopt;
    if (value->is_null()) return std::string();
    if (!value->is_string() || value->get<std::string>().empty())
      refuse(quoted(key) + " names no joint", "name a joint of that finger, or give null when the hand has none");
    return value->get<std::string>();
  }

  std::vector<std::vector<std::string>> read_fingers() const {
    std::vector<std::vector<std::string>> fingers;
    const Json* list = find("fingers");
    if (!list) return fingers;
    const auto is_list = [](const Json& value) { return value.is_array() && !value.empty(); };
    if (!is_list(*list) || !std::ranges::all_of(*list, is_list))
      refuse("\"fingers\" is not a list of lists", "list the joints of each finger, root to tip");
    for (const Json& chain : *list) {
      std::vector<std::string>& finger = fingers.emplace_back();
      for (const Json& joint : chain) finger.push_back(to_name(joint, "a joint in \"fingers\""));
    }
    return fingers;
  }

  std::vector<StatedFingertip> read_fingertips() const {
    std::vector<StatedFingertip> fingertips;
    const Json* list = find("fingertips");
    if (!list) return fingertips;
    const auto is_object = [](const Json& value) { return value.is_object(); };
    if (!list->is_array() || !std::ranges::all_of(*list, is_object))
      refuse("\"fingertips\" is not a list of objects", "give [{\"link\": ...}, ...]");
    for (const Json& value : *list) {
      check_keys(value, kFingertipKeys, "\"fingertips\": ");
      if (!value.contains("link")) refuse("\"fingertips\": an element has no \"link\"", "name the link of the tip");
      StatedFingertip& tip = fingertips.emplace_back();
      tip.link = to_name(value.at("link"), "\"link\" of a fingertip");
      if (value.contains("point")) tip.point = to_vector(value["point"], "\"point\" of fingertip " + quoted(tip.link));
      if (value.contains("pad_normal"))
        tip.pad_normal = to_direction(value["pad_normal"], "\"pad_normal\" of fingertip " + quoted(tip.link));
    }
    return fingertips;
  }

  std::map<std::string, Json> read_joint_map(const char* key) const {
    const Json* object = find(key);
    if (!object) return {};
    if (!object->is_object()) refuse(quoted(key) + " is not an object", "map joint names to values");
    return object->get<std::map<std::string, Json>>();
  }

  const Json& document_;
  const std::string& file_;
};

const char* name_of(Handedness handedness) {
  switch (handedness) {
    case Handedness::right: return "right";
    case Handedness::left: return "left";
    case Handedness::none: break;
  }
  return "none";
}

Json to_json(const std::string& finger_name) { return finger_name.empty() ? Json(nullptr) : Json(finger_name); }

Json to_json(const StatedFingertip& tip) {
  Json object = {{"link", tip.link}};
  if (tip.point) object["point"] = to_json(*tip.point);
  if (tip.pad_normal) object["pad_normal"] = to_json(*tip.pad_normal);
  return object;
}

}  // namespace

std::string doubt(const HandFinding& finding) {
  if (finding.confidence >= 0.5) return "";
  return "doubtful " + finding.item + ": " + finding.value + " (" + finding.reason + "); set \"" + finding.item +
         "\" in a hand config if it is wrong";
}

HandConfig read_hand_config(const std::string& path, std::uint64_t max_bytes) {
  const char* remedy = "make sure that it is a hand config, or raise the max_bytes of read_hand_config";
  return ConfigReader(read_json_file(path, max_bytes, remedy), path).read();
}

HandConfig parse_hand_config(const std::string& text, const std::string& file) {
  return ConfigReader(parse_json(text, file), file).read();
}

std::string to_canonical_json(const HandConfig& config) {
  Json document = Json::object();
  if (config.palm_link) document["palm_link"] = *config.palm_link;
  if (config.palm_normal_in_root) document["palm_normal_in_root"] = to_json(*config.palm_normal_in_root);
  if (!config.fingers.empty()) document["fingers"] = config.fingers;
  for (const StatedFingertip& tip : config.fingertips) document["fingertips"].push_back(to_json(tip));
  if (config.thumb) document["thumb"] = to_json(*config.thumb);
  if (config.middle_finger) document["middle_finger"] = to_json(*config.middle_finger);
  if (config.handedness) document["handedness"] = name_of(*config.handedness);
  if (!config.q_open.empty()) document["q_open"] = config.q_open;
  if (!config.q_closed.empty()) document["q_closed"] = config.q_closed;
  for (const auto& [joint, limits] : config.joint_limits)
    document["joint_limits"][joint] = {limits.lower, limits.upper};
  return to_canonical_text(document);
}

}  // namespace uhas
