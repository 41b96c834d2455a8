#include "uhas/model/urdf/xml_markup.hpp"

#include <algorithm>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

/// Position just after the markup that starts at `start` ("<..."), npos when it does not end.
std::size_t end_of_markup(std::string_view text, std::size_t start) {
  const auto after = [&](std::string_view terminator) {
    const std::size_t found = text.find(terminator, start);
    return found == std::string_view::npos ? found : found + terminator.size();
  };
  const std::string_view markup = text.substr(start);
  if (markup.starts_with("<!--")) return after("-->");
  if (markup.starts_with("<![CDATA[")) return after("]]>");
  if (markup.starts_with("<?")) return after("?>");
  char quote = 0;
  for (std::size_t i = start; i < text.size(); ++i) {
    if (quote != 0) {
      if (text[i] == quote) quote = 0;
    } else if (text[i] == '"' || text[i] == '\'') {
      quote = text[i];
    } else if (text[i] == '>') {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

}  // namespace

bool XmlMarkup::next() {
  before_ = end_;
  start_ = std::min(text_.find('<', end_), text_.size());
  if (start_ == text_.size()) return false;
  end_ = end_of_markup(text_, start_);
  if (end_ == std::string_view::npos)
    throw Error(ErrorCode::syntax, place(), "the XML ends inside a tag or comment", "complete the file");
  return true;
}

std::string XmlMarkup::place() const {
  return file_ + ":" + std::to_string(1 + std::ranges::count(text_.substr(0, start_), '\n'));
}

}  // namespace uhas
