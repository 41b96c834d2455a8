#include "uhas/model/meshes/collada_bounds.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

#include "uhas/base/errors.hpp"
#include "uhas/model/urdf/xml_markup.hpp"

namespace uhas {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr std::array<std::string_view, 5> kIndexLists{"p", "h", "v", "vcount", "int_array"};

/// "p" of "<p>" and "<p a='b'>".
std::string_view name_of(std::string_view tag) {
  tag.remove_prefix(1);
  return tag.substr(0, tag.find_first_of(" \t\r\n/>"));
}

/// The value of the attribute `count` in its quotes, empty when the tag has none.
std::string_view count_of(std::string_view tag) {
  for (std::size_t at = tag.find("count"); at != std::string_view::npos; at = tag.find("count", at + 1)) {
    if (at == 0 || kSpace.find(tag[at - 1]) == std::string_view::npos) continue;
    std::string_view rest = tag.substr(at + std::string_view("count").size());
    const auto skip_space = [&] { rest.remove_prefix(std::min(rest.find_first_not_of(kSpace), rest.size())); };
    skip_space();
    if (!rest.starts_with('=')) continue;
    rest.remove_prefix(1);
    skip_space();
    const std::size_t end = rest.empty() ? rest.npos : rest.find(rest.front(), 1);
    return rest.substr(0, end == rest.npos ? end : end + 1);
  }
  return {};
}

/// Whether `quoted` is a plain number of at most `most`.
bool is_count(std::string_view quoted, std::size_t most) {
  if (quoted.size() < 3) return false;
  const std::string_view digits = quoted.substr(1, quoted.size() - 2);
  std::size_t count = 0;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), count);
  return failure == std::errc() && end == digits.data() + digits.size() && count <= most;
}

}  // namespace

void check_collada_bounds(std::string_view text, const std::string& file) {
  bool in_index_list = false;
  for (XmlMarkup markup(text, file); markup.next();) {
    const bool has_element = markup.is_tag() && !markup.closes(), has_text = markup.piece().starts_with("<![CDATA[");
    if (in_index_list && (has_element || has_text ||
                          markup.text_before().find_first_not_of("-+0123456789 \t\r\n") != std::string_view::npos))
      throw Error(ErrorCode::invalid_mesh, markup.place(), "a list of indices holds something else",
                  "export the mesh again");
    if (!markup.is_tag()) continue;
    in_index_list = markup.opens() && std::ranges::find(kIndexLists, name_of(markup.piece())) != kIndexLists.end();
    // whatever is counted takes a character at least
    if (const std::string_view count = count_of(markup.piece()); !count.empty() && !is_count(count, text.size()))
      throw Error(ErrorCode::limit_exceeded, markup.place(),
                  "count=" + std::string(count) + " is no number of elements that this file can hold",
                  "export the mesh again");
  }
}

}  // namespace uhas
