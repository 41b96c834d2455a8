// What a tool's parser knows of its own command line, for the test of the man pages and for completion in shells.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "uhas/json/json_text.hpp"

namespace uhas::tools {

/// What can stand in an argument's place.
enum class ArgumentKind { none, words, file, other };

struct OptionDescription {
  std::vector<std::string> names;  ///< "-o", "--output"; for a positional argument its one name, without dashes
  std::string argument;            ///< as --help shows it, "" for a flag: "FILE", "visual|collision|both", "N"
  ArgumentKind kind = ArgumentKind::none;
  std::vector<std::string> words;  ///< of ArgumentKind::words; one that ends in '=' wants more behind it
  std::string text;                ///< one line
  bool required = false, repeatable = false;
};

struct CommandLine {
  std::string tool, text;
  std::vector<OptionDescription> positionals, options;
};

/// Whether the argument of an option is a file.
bool names_file(const CLI::Option& option);

/// Of a parser that has all its options.
CommandLine describe_command_line(const CLI::App& app);

/// {"format": "uhas-command-line", ...} (schemas/command-line.schema.json).
Json command_line_json(const CommandLine& command_line);

/// Completion scripts: a file for `complete` of bash, a function for zsh's `compinit`, commands for fish.
std::string bash_completion(const CommandLine& command_line);
std::string zsh_completion(const CommandLine& command_line);
std::string fish_completion(const CommandLine& command_line);

}  // namespace uhas::tools
