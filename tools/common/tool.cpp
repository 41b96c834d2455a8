#include "common/tool.hpp"

#include <exception>
#include <iostream>
#include <new>

#include "common/terminal.hpp"
#include "uhas/base/errors.hpp"

namespace uhas::tools {

Tool::Tool(std::string name, int argc, char** argv)
    : name_(std::move(name)), app_("", name_), argc_(argc), argv_(argv) {}

void Tool::parse() {
  // added last, so that --help lists them after the tool's own options
  app_.option_defaults()->group("Common options");
  app_.add_flag("--untrusted", untrusted_, "Read profiles and meshes in child processes, under limits of time and memory");
  app_.add_flag("--json", json_, "Print the result as JSON");
  app_.add_flag("--quiet", quiet_, "Print no warnings and no progress");
  app_.add_flag("--verbose", verbose_, "Say on stderr what is being done");
  app_.set_version_flag("--version", name_ + " " UHAS_VERSION, "Print the version and exit");
  app_.set_help_flag("-h,--help", "Print this help and exit");
  app_.footer("Exit codes: 0 done, 1 the input or the run failed, 2 wrong usage.");
  app_.parse(argc_, argv_);
  if (quiet_ && verbose_) throw wrong_usage("--verbose", "excludes --quiet");
}

void Tool::warn(std::span<const std::string> warnings) const {
  if (quiet_) return;
  for (const std::string& warning : warnings) std::cerr << name_ << ": " << toned(std::cerr, "warning:", Tone::warning) << ' ' << warning << '\n';
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
  } catch (const CLI::Success& request) {  // --help and --version
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
