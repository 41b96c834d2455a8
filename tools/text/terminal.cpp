#include "text/terminal.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace uhas::tools {
namespace {

/// "Select Graphic Rendition" of ECMA-48; the sixteen colours that every theme sets.
const char* code_of(Tone tone) {
  switch (tone) {
    case Tone::plain: return "";
    case Tone::heading: return "\033[1m";
    case Tone::dim: return "\033[2m";
    case Tone::lateral: return "\033[36m";
    case Tone::encompassing: return "\033[32m";
    case Tone::warning: return "\033[1;33m";
    case Tone::error: return "\033[1;31m";
  }
  return "";
}

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

bool has_colour(const std::ostream& out) {
  const int descriptor = &out == &std::cout ? STDOUT_FILENO : &out == &std::cerr ? STDERR_FILENO : -1;
  return descriptor >= 0 && ::isatty(descriptor) && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
}

std::string toned(const std::ostream& out, const std::string& text, Tone tone) {
  return tone != Tone::plain && has_colour(out) ? code_of(tone) + text + "\033[0m" : text;
}

}  // namespace uhas::tools
