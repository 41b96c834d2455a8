// Completion scripts for shells, written from what the parser knows.
#include <algorithm>
#include <sstream>
#include <string_view>

#include "command_line/command_line.hpp"
#include "text/words.hpp"

namespace uhas::tools {
namespace {

/// `text` with a backslash before each of `characters`.
std::string escaped(const std::string& text, std::string_view characters) {
  std::string result;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

/// In single quotes, for a POSIX shell: it's -> 'it'\''s'.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "'\\''" : std::string(1, c);
  return result + "'";
}

/// A name that shells take for a function: uhas_solve.
std::string function_name(const CommandLine& command_line) {
  std::string name = command_line.tool;
  std::ranges::replace(name, '-', '_');
  return name;
}

/// Whether more follows the words of an option, as a value behind NAME=.
bool wants_more(const OptionDescription& option) { return option.words.front().ends_with('='); }

/// How zsh completes one of a few words.
std::string zsh_words(const OptionDescription& option) {
  const std::string words = join(option.words, " ");
  return wants_more(option) ? "{compadd -S \"\" -- " + words + "}" : "(" + words + ")";
}

/// How zsh completes an argument: message and action.
std::string zsh_argument(const OptionDescription& option) {
  const std::string message = ":" + escaped(option.argument, ":\\");
  switch (option.kind) {
    case ArgumentKind::none: return "";
    case ArgumentKind::words: return message + ":" + zsh_words(option);
    case ArgumentKind::file: return message + ":_files";
    case ArgumentKind::other: break;
  }
  return message + ": ";
}

std::string fish_argument(const OptionDescription& option) {
  switch (option.kind) {
    case ArgumentKind::none: return "";
    case ArgumentKind::words: return " -x -a " + quoted(join(option.words, " "));
    case ArgumentKind::file: return " -r -F";
    case ArgumentKind::other: break;
  }
  return " -x";
}

}  // namespace

std::string bash_completion(const CommandLine& command_line) {
  std::ostringstream script;
  const std::string function = "_" + function_name(command_line);
  script << function << R"(() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  if [[ $word == = ]]; then
    word=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  case $before in
)";
  std::vector<std::string> names;
  for (const OptionDescription& option : command_line.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (option.kind == ArgumentKind::none) continue;
    script << "    " << join(option.names, " | ") << ") ";
    if (option.kind == ArgumentKind::words)
      script << (wants_more(option) ? "compopt -o nospace; " : "") << "COMPREPLY=($(compgen -W "
             << quoted(join(option.words, " ")) << " -- \"$word\")); ";
    if (option.kind == ArgumentKind::other) script << "compopt +o default; ";
    script << "return ;;\n";
  }
  script << "  esac\n  if [[ $word == -* ]]; then\n    COMPREPLY=($(compgen -W " << quoted(join(names, " "))
         << " -- \"$word\"))\n  fi\n}\n";
  // without words of the function, bash completes file names
  script << "complete -o default -F " << function << " " << command_line.tool << "\n";
  return script.str();
}

std::string zsh_completion(const CommandLine& command_line) {
  std::ostringstream script;
  script << "#compdef " << command_line.tool << "\n_arguments -S";
  for (const OptionDescription& option : command_line.options) {
    const std::string text = "[" + escaped(option.text, "[]\\:") + "]" + zsh_argument(option);
    for (const std::string& name : option.names) {
      const std::string prefix = option.repeatable ? "*" : "(" + join(option.names, " ") + ")";
      const bool takes_equals = option.kind != ArgumentKind::none && name.starts_with("--");
      script << " \\\n  " << quoted(prefix + name + (takes_equals ? "=" : "") + text);
    }
  }
  for (const OptionDescription& positional : command_line.positionals)
    script << " \\\n  "
           << quoted((positional.repeatable ? "*:" : ":") + escaped(join(positional.names, ""), ":\\") + ":_files");
  script << "\n";
  return script.str();
}

std::string fish_completion(const CommandLine& command_line) {
  std::ostringstream script;
  for (const OptionDescription& option : command_line.options) {
    script << "complete -c " << command_line.tool;
    for (const std::string& name : option.names)
      script << (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1));
    script << fish_argument(option) << " -d " << quoted(escaped(option.text, "\\")) << "\n";
  }
  return script.str();
}

}  // namespace uhas::tools
