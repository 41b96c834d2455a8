#include "command_line/option_names.hpp"

#include "command_line/limits.hpp"

namespace uhas::tools {
namespace {

struct Wording {
  std::string of_library, of_tools;
};

std::vector<Wording> wordings() {
  std::vector<Wording> list = {
      {"by ModelLoadOptions::packages", "by --package NAME=DIR"},
      {"set ModelLoadOptions::allow_outside", "pass --allow-outside"},
      {"those of GeometrySource::collision", "with --geometry collision"},
  };
  for (const NamedLimit& limit : named_limits())
    if (limit.field) list.push_back({"raise " + std::string(limit.field), raise_limit(limit.value)});
  return list;
}

}  // namespace

std::string with_option_names(std::string message) {
  for (const auto& [of_library, of_tools] : wordings())
    if (const std::size_t at = message.find(of_library); at != std::string::npos)
      message.replace(at, of_library.size(), of_tools);
  return message;
}

}  // namespace uhas::tools
