// What all tools share: the common options, messages on stderr, and errors turned into one line and an exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "command_line/exit_code.hpp"
#include "command_line/file_guard.hpp"
#include "command_line/limits.hpp"

namespace uhas::tools {

/// A running tool: its command line and its voice.
class Tool {
 public:
  Tool(std::string name, int argc, char** argv);

  /// The command line, for the options of this tool.
  CLI::App& options() { return app_; }

  /// An option that names a file to write. A tool with one has --force, too.
  CLI::Option* add_output(const std::string& option, std::string& path, FileKind kind, const std::string& description);

  /// Adds --limit, --json, --quiet, --verbose, --version and --help, then reads the command line into the variables the
  /// options were bound to. Throws CLI::ParseError; Error(write_failed) as `FileGuard`.
  void parse();

  /// Has the files that the options name; what is found out later is to be told to it.
  FileGuard& files() { return files_; }

  bool json() const { return json_; }
  bool quiet() const { return quiet_; }
  bool verbose() const { return verbose_; }

  const Limits& limits() const { return limits_; }

  /// `name: warning: text` on stderr for each, unless --quiet.
  void warn(std::span<const std::string> warnings) const;

  /// `name: text` on stderr, with --verbose only.
  void log(const std::string& text) const;

  /// `name: error: text` on stderr.
  void report_error(const std::string& text) const;

  /// Wrong usage that only shows once the options have been read; `run_tool` catches it.
  static CLI::ParseError wrong_usage(const std::string& option, const std::string& problem);

 private:
  void guard_files();

  std::string name_;
  CLI::App app_;
  int argc_;
  char** argv_;
  bool json_ = false, quiet_ = false, verbose_ = false, force_ = false;
  Limits limits_;
  std::vector<std::pair<const CLI::Option*, FileKind>> outputs_;
  FileGuard files_;
};

/// Runs `body`, which adds its options, parses, does the work and prints. An exception becomes one line on stderr.
/// Returns the exit code of the process.
int run_tool(const std::string& name, int argc, char** argv, const std::function<ExitCode(Tool&)>& body);

/// Binds `target` to an option that takes one of a few words.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Value& target,
                        const std::vector<std::pair<std::string, Value>>& choices, const std::string& description) {
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) words.push_back(word);
  const auto assign = [&target, choices](const std::string& chosen) {
    for (const auto& [word, value] : choices)
      if (word == chosen) target = value;
  };
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : "|") + word;
  return app.add_option_function<std::string>(option, assign, description)
      ->check(CLI::IsMember(words).description(""))
      ->type_name(list);
}

}  // namespace uhas::tools
