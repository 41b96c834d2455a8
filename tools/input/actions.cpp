#include "input/actions.hpp"

#include <algorithm>
#include <filesystem>

#include "uhas/base/errors.hpp"

namespace uhas::tools {
namespace {

constexpr std::size_t kMaxActionSize = kSlotCount * (1 + kMaxDrivingVectors);

/// Says where a problem is: the file and, within it, the action.
struct Place {
  std::string file, item;

  Error error(const std::string& problem, const std::string& remedy) const {
    return {ErrorCode::invalid_action, file, item.empty() ? problem : item + ": " + problem, remedy};
  }
};

std::string excerpt(const Json& value) {
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

/// `of_what` says which part of the item the list is: empty, or " of radial".
std::vector<double> numbers(const Json& list, const std::string& of_what, const Place& place) {
  std::vector<double> values;
  for (const Json& element : list) {
    if (!element.is_number())
      throw place.error("element " + std::to_string(values.size()) + of_what + " is " + excerpt(element),
                        "write a number");
    values.push_back(element.get<double>());
  }
  return values;
}

/// The array of numbers at `key`.
std::vector<double> numbers_at(const Json& object, const char* key, const Place& place) {
  const Json& list = object[key];
  if (!list.is_array()) throw place.error(std::string(key) + " is not an array", "write an array of numbers");
  return numbers(list, std::string(" of ") + key, place);
}

void refuse_unknown_keys(const Json& object, std::span<const char* const> known, const Place& place) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    std::string list;
    for (const char* name : known) list += (list.empty() ? "" : ", ") + std::string(name);
    throw place.error("unknown key " + excerpt(key), "the keys are " + list);
  }
}

/// {"lateral": [5], "radial": [[V] x 5]} as the flat action.
std::vector<double> action_from_object(const Json& object, const Place& place) {
  refuse_unknown_keys(object, std::array{"lateral", "radial"}, place);
  if (!object.contains("lateral") || !object.contains("radial"))
    throw place.error("lateral or radial is missing",
                      "write {\"lateral\": [5 numbers], \"radial\": [5 arrays of V numbers]}");
  std::vector<double> values = numbers_at(object, "lateral", place);
  const Json& radial = object["radial"];
  if (values.size() != kSlotCount || !radial.is_array() || radial.size() != kSlotCount)
    throw place.error("lateral or radial does not have 5 elements",
                      "write one for each of pinky, ring, middle, index, thumb");
  for (const Json& plane : radial) {
    if (!plane.is_array()) throw place.error("an element of radial is not an array", "write V numbers for each plane");
    const std::vector<double> displacements = numbers(plane, " of a plane of radial", place);
    if (plane.size() != radial.front().size())
      throw place.error("the planes of radial differ in length", "write as many numbers for each plane");
    values.insert(values.end(), displacements.begin(), displacements.end());
  }
  return values;
}

std::vector<double> to_action(const Json& value, const Place& place) {
  if (!value.is_structured()) throw place.error("is " + excerpt(value), "write an array or an object");
  const std::vector<double> values = value.is_object() ? action_from_object(value, place) : numbers(value, "", place);
  if (values.size() % kSlotCount != 0 || values.size() < 2 * kSlotCount || values.size() > kMaxActionSize)
    throw place.error("has " + std::to_string(values.size()) + " numbers",
                      "write 5 + 5 V numbers for V = 1 to 4 driving vectors, 15 for the usual two");
  return values;
}

/// Length of an action for these driving-vector angles; 0 when none are given.
std::size_t action_size_for(std::span<const double> driving_vectors_phi, const Place& place) {
  const std::size_t n = driving_vectors_phi.size();
  if (n == 0) return 0;
  if (n <= kMaxDrivingVectors) return kSlotCount * (1 + n);
  if (n % kSlotCount == 0 && n <= kSlotCount * kMaxDrivingVectors) return kSlotCount + n;
  throw place.error("driving_vectors_phi has " + std::to_string(n) + " numbers",
                    "write V numbers, or 5 V, for V = 1 to 4");
}

SolveOptions convention_named(const Json& name, const Place& place) {
  for (const NamedConvention& convention : kConventions)
    if (name == convention.name) return convention.options;
  throw place.error("convention is " + excerpt(name), "write \"uhas\" or \"uhas-sim\"");
}

}  // namespace

ActionsDocument read_actions(const std::string& path, const Limits& limits) {
  const Json json = read_json_file(path, limits.json_bytes, "split it, or " + raise_limit(&Limits::json_bytes));
  const Place place{path, ""};
  if (!json.is_object() || json.value("format", Json()) != "uhas-actions")
    throw place.error("is not a file of actions: no \"format\": \"uhas-actions\"", "see schemas/actions.schema.json");
  if (const Json version = json.value("version", Json()); version != 1)
    throw Error(ErrorCode::unsupported_version, path, "version is " + excerpt(version) + ", this tool reads 1",
                "write \"version\": 1");
  refuse_unknown_keys(
      json, std::array{"format", "version", "profile", "convention", "driving_vectors_phi", "normalized", "actions"},
      place);

  ActionsDocument document;
  if (json.contains("profile")) {
    if (!json["profile"].is_string()) throw place.error("profile is not a string", "write the path of a hand profile");
    document.profile = std::filesystem::path(path).parent_path() / json["profile"].get<std::string>();
  }
  if (json.contains("driving_vectors_phi"))
    document.driving_vectors_phi = numbers_at(json, "driving_vectors_phi", place);
  if (json.contains("normalized")) {
    if (!json["normalized"].is_boolean()) throw place.error("normalized is not true or false", "write true or false");
    document.normalized = json["normalized"].get<bool>();
  }

  if (json.contains("convention")) document.convention = convention_named(json["convention"], place);

  if (!json.contains("actions") || !json["actions"].is_array())
    throw place.error("actions is missing or not an array", "write \"actions\": [[15 numbers], ...]");
  if (const std::size_t count = json["actions"].size(); count > limits.actions)
    throw Error(ErrorCode::limit_exceeded, path,
                "has " + std::to_string(count) + " actions, more than the bound of " + std::to_string(limits.actions) +
                    " for a file",
                "stream them through uhas-solve -, which takes any number, or " + raise_limit(&Limits::actions));
  std::size_t size = action_size_for(document.driving_vectors_phi, place);
  for (const Json& value : json["actions"]) {
    const Place here{path, "action " + std::to_string(document.actions.size())};
    document.actions.push_back(to_action(value, here));
    const std::size_t found = document.actions.back().size();
    if (size == 0) size = found;
    if (found != size)
      throw here.error("has " + std::to_string(found) + " numbers, not " + std::to_string(size),
                       "give all actions of a file the same number of driving vectors");
  }
  return document;
}

std::vector<double> action_of(const Json& value) { return to_action(value, {"", "action"}); }

}  // namespace uhas::tools
