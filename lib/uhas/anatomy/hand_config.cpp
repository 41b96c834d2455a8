#include "uhas/anatomy/hand_config.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string_view>
#include <vector>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "uhas-hand-config";
constexpr int kVersion = 1;
constexpr std::array<std::string_view, 8> kKeys = {
    "comment", "format", "handedness", "palm_link", "palm_normal_in_root", "q_closed", "q_open", "version"};

/// Levenshtein distance: how many letters one has to insert, remove or change.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, change});
    }
  }
  return row.back();
}

[[noreturn]] void refuse(const std::string& path, const std::string& problem, const std::string& remedy) {
  throw Error(ErrorCode::invalid_config, path, problem, remedy);
}

void check_keys(const json& document, const std::string& path) {
  for (const auto& [key, value] : document.items()) {
    if (std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end()) continue;
    const auto nearest = std::min_element(kKeys.begin(), kKeys.end(), [&key = key](auto a, auto b) {
      return edit_distance(key, a) < edit_distance(key, b);
    });
    refuse(path, "unknown key \"" + key + "\"", "did you mean \"" + std::string(*nearest) + "\"?");
  }
}

void check_format(const json& document, const std::string& path) {
  if (document.contains("format") && document["format"] != kFormat)
    refuse(path, "\"format\" is not \"" + std::string(kFormat) + "\"", "give a hand config");
  if (document.contains("version") && document["version"] != kVersion)
    throw Error(ErrorCode::unsupported_version, path,
                "hand config version " + document["version"].dump() + ", this program reads version " +
                    std::to_string(kVersion),
                "");
}

/// The string at `key`; empty when the key is absent.
std::string read_string(const json& document, const char* key, const std::string& path) {
  if (!document.contains(key)) return {};
  if (!document[key].is_string()) refuse(path, "\"" + std::string(key) + "\" is not a string", "");
  return document[key].get<std::string>();
}

std::optional<Handedness> read_handedness(const json& document, const std::string& path) {
  const std::string text = read_string(document, "handedness", path);
  if (text.empty()) return std::nullopt;
  if (text == "right") return Handedness::right;
  if (text == "left") return Handedness::left;
  if (text == "none") return Handedness::none;
  refuse(path, "\"handedness\" is \"" + text + "\"", "use \"right\", \"left\" or \"none\"");
}

std::optional<Vector3d> read_direction(const json& document, const char* key, const std::string& path) {
  if (!document.contains(key)) return std::nullopt;
  const json& value = document[key];
  const bool three_numbers =
      value.is_array() && value.size() == 3 &&
      std::all_of(value.begin(), value.end(), [](const json& component) { return component.is_number(); });
  if (!three_numbers) refuse(path, "\"" + std::string(key) + "\" is not a list of three numbers", "");
  const Vector3d direction{value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  if (!is_finite(direction) || !(norm(direction) > 0))
    refuse(path, "\"" + std::string(key) + "\" has no direction", "give a finite vector that is not zero");
  return direction;
}

std::map<std::string, double> read_joint_values(const json& document, const char* key, const std::string& path) {
  std::map<std::string, double> values;
  if (!document.contains(key)) return values;
  const json& object = document[key];
  if (!object.is_object()) refuse(path, "\"" + std::string(key) + "\" is not an object", "map joint names to numbers");
  for (const auto& [joint, value] : object.items()) {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      refuse(path, "\"" + std::string(key) + "\": joint \"" + joint + "\" has no finite number", "");
    values[joint] = value.get<double>();
  }
  return values;
}

const char* name_of(Handedness handedness) {
  switch (handedness) {
    case Handedness::right: return "right";
    case Handedness::left: return "left";
    case Handedness::none: break;
  }
  return "none";
}

}  // namespace

HandConfig read_hand_config(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(ErrorCode::file_unreadable, path, "cannot be read", "check the path and its permissions");
  return parse_hand_config({std::istreambuf_iterator<char>(file), {}}, path);
}

HandConfig parse_hand_config(const std::string& text, const std::string& path) {
  json document;
  try {
    document = json::parse(text);
  } catch (const json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw Error(ErrorCode::syntax, path + ":" + std::to_string(line), "not valid JSON", "");
  } catch (const json::exception&) {
    refuse(path, "a number is beyond the range of double", "");
  }
  if (!document.is_object()) refuse(path, "not a JSON object", "");
  check_keys(document, path);
  check_format(document, path);

  HandConfig config;
  if (const std::string palm_link = read_string(document, "palm_link", path); !palm_link.empty())
    config.palm_link = palm_link;
  config.palm_normal_in_root = read_direction(document, "palm_normal_in_root", path);
  config.handedness = read_handedness(document, path);
  config.q_open = read_joint_values(document, "q_open", path);
  config.q_closed = read_joint_values(document, "q_closed", path);
  return config;
}

std::string to_canonical_json(const HandConfig& config) {
  json document = json::object();  // nlohmann::json keeps keys sorted
  if (config.palm_link) document["palm_link"] = *config.palm_link;
  if (const auto& n = config.palm_normal_in_root) document["palm_normal_in_root"] = {n->x, n->y, n->z};
  if (config.handedness) document["handedness"] = name_of(*config.handedness);
  if (!config.q_open.empty()) document["q_open"] = config.q_open;
  if (!config.q_closed.empty()) document["q_closed"] = config.q_closed;
  return document.dump();
}

}  // namespace uhas
