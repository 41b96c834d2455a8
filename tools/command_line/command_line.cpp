#include "command_line/command_line.hpp"

#include <algorithm>
#include <array>
#include <sstream>

#include "command_line/limits.hpp"

namespace uhas::tools {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// The argument as --help writes it.
std::string argument_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  return option.get_option_text().empty() ? option.get_type_name() : option.get_option_text();
}

/// An argument is a file when it is called FILE or like one: hand.urdf, report.html.
ArgumentKind kind_of(const std::string& argument) {
  if (argument.empty()) return ArgumentKind::none;
  if (argument == kLimitArgument) return ArgumentKind::words;
  if (argument.find('|') != std::string::npos) return ArgumentKind::words;
  return argument == "FILE" || argument.find('.') != std::string::npos ? ArgumentKind::file : ArgumentKind::other;
}

std::vector<std::string> words_of(const std::string& argument) {
  if (argument != kLimitArgument) return split(argument, '|');
  std::vector<std::string> words;
  for (const NamedLimit& limit : named_limits()) words.push_back(limit.name + std::string("="));
  return words;
}

OptionDescription describe(const CLI::Option& option) {
  OptionDescription result;
  result.argument = argument_of(option);
  result.kind = kind_of(result.argument);
  if (result.kind == ArgumentKind::words) result.words = words_of(result.argument);
  result.text = option.get_description();
  std::ranges::replace(result.text, '\n', ' ');
  result.required = option.get_required();
  result.repeatable = option.get_expected_max() > 1;
  if (option.get_positional()) {
    result.names = {option.get_name(true)};
  } else {
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  }
  return result;
}

Json to_json(const OptionDescription& option) {
  constexpr std::array kinds{"none", "words", "file", "other"};
  Json result;
  result["names"] = option.names;
  result["argument"] = option.argument;
  result["kind"] = kinds[static_cast<std::size_t>(option.kind)];
  result["words"] = option.words;
  result["text"] = option.text;
  result["required"] = option.required;
  result["repeatable"] = option.repeatable;
  return result;
}

Json to_json(const std::vector<OptionDescription>& options) {
  Json list = Json::array();
  for (const OptionDescription& option : options) list.push_back(to_json(option));
  return list;
}

}  // namespace

bool names_file(const CLI::Option& option) { return kind_of(argument_of(option)) == ArgumentKind::file; }

CommandLine describe_command_line(const CLI::App& app) {
  CommandLine result{.tool = app.get_name(), .text = app.get_description(), .positionals = {}, .options = {}};
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? result.positionals : result.options).push_back(describe(*option));
  return result;
}

Json command_line_json(const CommandLine& command_line) {
  Json document = new_document("uhas-command-line");
  document["tool"] = command_line.tool;
  document["text"] = command_line.text;
  document["positionals"] = to_json(command_line.positionals);
  document["options"] = to_json(command_line.options);
  document["limits"] = Json::object();
  for (const NamedLimit& limit : named_limits()) document["limits"][limit.name] = Limits{}.*limit.value;
  return document;
}

}  // namespace uhas::tools
