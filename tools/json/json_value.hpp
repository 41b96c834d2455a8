// One value out of a JSON document, for scripts.
#pragma once

#include <string>

#include "uhas/json/json_text.hpp"

namespace uhas::tools {

/// The value at `key`: names and list positions joined by dots, as in sphere.radius or fingers.0.name; a name may hold
/// dots itself. Throws Error(invalid_option) that lists what there is where the path leaves the document.
const Json& value_at(const Json& document, const std::string& key);

/// A line: text without quotes, anything else as JSON.
std::string to_plain_line(const Json& value);

}  // namespace uhas::tools
