#include "command_line/tool.hpp"

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>

#include "command_line/command_line.hpp"
#include "command_line/library_versions.hpp"
#include "command_line/option_names.hpp"
#include "text/terminal.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {
namespace {

/// "uhas-solve 0.1.0", then the versions of the formats and, when asked for, of the libraries.
std::string version_text(const std::string& tool, bool with_libraries) {
  std::string text = tool + " " UHAS_VERSION "\nhand profile format " + std::to_string(kProfileVersionMajor) + "." +
                     std::to_string(kProfileVersionMinor) + "\nJSON formats " + std::to_string(kJsonVersion);
  if (with_libraries)
    for (const std::string& library : library_versions()) text += "\n" + library;
  return text;
}

/// What the parser knows, in the form of this name: a document or a completion script. Empty for other names.
std::string description(const CLI::App& app, std::string_view form) {
  const CommandLine command_line = describe_command_line(app);
  if (form == "json") return to_text(command_line_json(command_line));
  if (form == "bash") return bash_completion(command_line);
  if (form == "zsh") return zsh_completion(command_line);
  if (form == "fish") return fish_completion(command_line);
  return "";
}

}  // namespace

Tool::Tool(std::string name, int argc, char** argv)
    : name_(std::move(name)), app_("", name_), argc_(argc), argv_(argv) {}

CLI::Option* Tool::add_output(const std::string& option, std::string& path, FileKind kind,
                              const std::string& description) {
  CLI::Option* added = app_.add_option(option, path, description)->type_name("FILE");
  outputs_.emplace_back(added, kind);
  return added;
}

void Tool::parse() {
  // added last, so that --help lists them after the tool's own options
  app_.option_defaults()->group("Common options");
  add_limit_option(app_, limits_);
  if (!outputs_.empty()) app_.add_flag("--force", force_, "Replace files of another kind, and read-only ones, too");
  app_.add_flag("--json", json_, "Print the result as JSON");
  app_.add_flag("-q,--quiet", quiet_, "Print no warnings and no progress");
  app_.add_flag("-v,--verbose", verbose_, "Say on stderr what is being done");
  app_.set_version_flag(  // CLI11 has read --verbose by then, wherever it stands
      "-V,--version", [this] { return version_text(name_, verbose_); },
      "Print the version and exit; with --verbose those of the libraries, too");
  app_.set_help_flag("-h,--help", "Print this help and exit");
  app_.footer("Exit codes: 0 done, 1 the input or the run failed, 2 wrong usage.");
  if (argc_ == 3 && std::string_view(argv_[1]) == "--describe") {  // for the build and the tests; not in --help
    const std::string text = description(app_, argv_[2]);
    if (text.empty()) throw wrong_usage("--describe", "takes json, bash, zsh or fish");
    std::cout << text << std::flush;
    throw CLI::Success();
  }
  app_.parse(argc_, argv_);
  if (quiet_ && verbose_) throw wrong_usage("--verbose", "excludes --quiet");
  guard_files();
}

void Tool::guard_files() {
  if (force_) files_.force();
  for (const CLI::Option* option : app_.get_options())
    if (std::ranges::find(outputs_, option, &decltype(outputs_)::value_type::first) == outputs_.end() &&
        names_file(*option))
      for (const std::string& path : option->results()) files_.read(path);
  for (const auto& [option, kind] : outputs_)
    for (const std::string& path : option->results()) files_.write(path, kind);
}

void Tool::warn(std::span<const std::string> warnings) const {
  if (quiet_) return;
  for (const std::string& warning : warnings)
    std::cerr << name_ << ": " << toned(std::cerr, "warning:", Tone::warning) << ' ' << warning << '\n';
}

void Tool::log(const std::string& text) const {
  if (verbose_) std::cerr << name_ << ": " << text << '\n';
}

void Tool::report_error(const std::string& text) const {
  std::cerr << name_ << ": " << toned(std::cerr, "error:", Tone::error) << ' ' << text << '\n';
}

CLI::ParseError Tool::wrong_usage(const std::string& option, const std::string& problem) {
  return CLI::ValidationError(option, problem);
}

int run_tool(const std::string& name, int argc, char** argv, const std::function<ExitCode(Tool&)>& body) {
  Tool tool(name, argc, argv);
  ExitCode code = ExitCode::run_failed;
  try {
    const ExitCode result = body(tool);
    // a full disk must not pass for success
    if (!std::cout.flush())
      throw Error(ErrorCode::write_failed, "standard output", "cannot be written", "free some space");
    code = result;
  } catch (const CLI::Success& request) {  // --help, --version, --describe
    return tool.options().exit(request);
  } catch (const CLI::ParseError& error) {
    tool.report_error(std::string(error.what()) + "; see " + name + " --help");
    code = ExitCode::wrong_usage;
  } catch (const std::bad_alloc&) {
    tool.report_error("out of memory");
  } catch (const std::exception& error) {
    tool.report_error(with_option_names(error.what()));
  }
  return static_cast<int>(code);
}

}  // namespace uhas::tools
