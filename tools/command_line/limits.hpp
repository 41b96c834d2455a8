// Bounds on what is read, which options raise.
#pragma once

#include <cstdint>
#include <string>

#include "command_line/tool.hpp"

namespace uhas::tools {

/// Binds `bound`, which holds its default, to an option of the group "Limits".
inline CLI::Option* add_limit(CLI::App& app, const std::string& option, std::uint64_t& bound, const std::string& text) {
  return app.add_option(option, bound, text + " [" + std::to_string(bound) + "]")
      ->check(CLI::PositiveNumber.description(""))
      ->type_name("N")
      ->group("Limits");
}

}  // namespace uhas::tools
