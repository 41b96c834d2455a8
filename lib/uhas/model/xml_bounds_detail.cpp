#include "uhas/model/xml_bounds_detail.hpp"

#include <algorithm>
#include <cstddef>

#include "uhas/base/errors.hpp"

namespace uhas::detail {
namespace {

constexpr int max_nesting = 100;
constexpr std::size_t max_tag_length = 16384;

int line_of(std::string_view text, std::size_t position) {
  return 1 + static_cast<int>(std::ranges::count(text.substr(0, position), '\n'));
}

// Position just after the markup that starts at `start` ("<..."), npos when it does not end.
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

void for_each_tag(std::string_view text, const std::string& file, const std::function<void(const XmlTag&)>& visit) {
  for (std::size_t start = text.find('<'); start != std::string_view::npos; start = text.find('<', start)) {
    const std::size_t end = end_of_markup(text, start);
    if (end == std::string_view::npos)
      throw Error(ErrorCode::syntax, file + ":" + std::to_string(line_of(text, start)),
                  "the XML ends inside a tag or comment", "complete the file");
    const XmlTag tag{text.substr(start, end - start), start};
    start = end;
    if (!tag.text.starts_with("<!") && !tag.text.starts_with("<?")) visit(tag);
  }
}

void check_xml_bounds(std::string_view text, const std::string& file) {
  int depth = 0;
  for_each_tag(text, file, [&](const XmlTag& tag) {
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
      throw Error(ErrorCode::limit_exceeded, file + ":" + std::to_string(line_of(text, tag.position)), problem, remedy);
    };
    if (tag.text.size() > max_tag_length)
      refuse("a tag is longer than " + std::to_string(max_tag_length) + " characters", "shorten it");
    if (tag.closes())
      --depth;
    else if (!tag.is_empty())
      ++depth;
    if (depth > max_nesting)
      refuse("elements are nested more than " + std::to_string(max_nesting) + " deep", "flatten the file");
  });
}

}  // namespace uhas::detail
