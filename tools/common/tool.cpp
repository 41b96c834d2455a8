#include "common/tool.hpp"

#include <exception>
#include <iostream>
#include <map>
#include <new>

#include "common/command_line.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/profile/hand_profile.hpp"

namespace uhas::tools {
namespace {

/// "uhas-solve 0.1.0", then the versions of the formats.
std::string version_text(const std::string& tool) {
  return tool + " " UHAS_VERSION "\nhand profile format " + std::to_string(kProfileVersionMajor) + "." +
         std::to_string(kProfileVersionMinor) + "\nJSON formats " + std::to_string(kJsonVersion);
}

/// For the build and the tests, not for people: --describe prints what the parser knows.
void add_describe_option(CLI::App& app) {
  const std::map<std::string, std::function<std::string(const CommandLine&)>> forms{
      {"json", [](const CommandLine& line) { return to_text(command_line_json(line)); }},
      {"bash", bash_completion},
      {"zsh", zsh_completion},
      {"fish", fish_completion}};
  const auto print = [&app, forms](const std::string& form) {
    std::cout << forms.at(form)(describe_command_line(app)) << std::flush;
    throw CLI::Success();
  };
  app.add_option_function<std::string>("--describe", print, "Print the options as a document or completion script")
      ->check(CLI::IsMember({"json", "bash", "zsh", "fish"}).description(""))
      ->type_name("json|bash|zsh|fish")
      ->group("")
      ->trigger_on_parse();
}

}  // namespace

Tool::Tool(std::string name, int argc, char** argv)
    : name_(std::move(name)), app_("", name_), argc_(argc), argv_(argv) {}

void Tool::parse() {
  // added last, so that --help lists them after the tool's own options
  app_.option_defaults()->group("Common options");
  app_.add_flag("--json", json_, "Print the result as JSON");
  app_.add_flag("--quiet", quiet_, "Print no warnings and no progress");
  app_.add_flag("--verbose", verbose_, "Say on stderr what is being done");
  app_.set_version_flag("--version", version_text(name_), "Print the version and exit");
  app_.set_help_flag("-h,--help", "Print this help and exit");
  add_describe_option(app_);
  app_.footer("Exit codes: 0 done, 1 the input or the run failed, 2 wrong usage.");
  app_.parse(argc_, argv_);
  if (quiet_ && verbose_) throw wrong_usage("--verbose", "excludes --quiet");
}

void Tool::warn(std::span<const std::string> warnings) const {
  if (quiet_) return;
  for (const std::string& warning : warnings) std::cerr << name_ << ": warning: " << warning << '\n';
}

void Tool::log(const std::string& text) const {
  if (verbose_) std::cerr << name_ << ": " << text << '\n';
}

void Tool::report_error(const std::string& text) const { std::cerr << name_ << ": error: " << text << '\n'; }

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
    tool.report_error(error.what());
  }
  return static_cast<int>(code);
}

}  // namespace uhas::tools
