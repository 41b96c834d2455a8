#include "json/json_value.hpp"

#include <charconv>
#include <vector>

#include "text/words.hpp"
#include "uhas/base/errors.hpp"

namespace uhas::tools {
namespace {

/// The element that `key` opens with, and the rest of `key` behind its dot. Of several names that fit the
/// longest is meant.
struct Step {
  const Json* value = nullptr;
  std::string rest;
};

Step step_into(const Json& value, const std::string& key) {
  for (std::size_t end = key.size(); end != std::string::npos && end > 0; end = key.rfind('.', end - 1)) {
    const std::string name = key.substr(0, end);
    const std::string rest = end < key.size() ? key.substr(end + 1) : std::string();
    if (value.is_object() && value.contains(name)) return {&value.at(name), rest};
    std::size_t position = 0;
    const auto parsed = std::from_chars(name.data(), name.data() + name.size(), position);
    if (value.is_array() && parsed.ec == std::errc() && parsed.ptr == name.data() + name.size() &&
        position < value.size())
      return {&value.at(position), rest};
  }
  return {};
}

std::string what_is_there(const Json& value) {
  if (value.is_array()) return value.empty() ? "an empty list" : "0 to " + std::to_string(value.size() - 1);
  if (!value.is_object()) return "a single value";
  std::vector<std::string> names;
  for (const auto& [name, element] : value.items()) names.push_back(name);
  return join(names, ", ");
}

}  // namespace

const Json& value_at(const Json& document, const std::string& key) {
  const Json* value = &document;
  std::string rest = key;
  while (!rest.empty()) {
    const Step step = step_into(*value, rest);
    if (!step.value)
      throw Error(ErrorCode::invalid_option, "", "there is no value " + key,
                  rest == key ? "there are " + what_is_there(*value)
                              : key.substr(0, key.size() - rest.size() - 1) + " holds " + what_is_there(*value));
    value = step.value;
    rest = step.rest;
  }
  return *value;
}

std::string to_plain_line(const Json& value) {
  return value.is_string() ? value.get<std::string>() + "\n" : to_line(value);
}

}  // namespace uhas::tools
