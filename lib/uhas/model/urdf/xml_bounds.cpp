#include "uhas/model/urdf/xml_bounds.hpp"

#include <cstddef>

#include "uhas/base/errors.hpp"
#include "uhas/model/urdf/xml_markup.hpp"

namespace uhas {
namespace {

constexpr int max_nesting = 100;
constexpr std::size_t max_tag_length = 16384;

}  // namespace

void check_xml_bounds(std::string_view text, const std::string& file) {
  int depth = 0;
  for (XmlMarkup markup(text, file); markup.next();) {
    if (!markup.is_tag()) continue;
    if (markup.piece().size() > max_tag_length)
      throw Error(ErrorCode::limit_exceeded, markup.place(),
                  "a tag is longer than " + std::to_string(max_tag_length) + " characters", "shorten it");
    depth += markup.opens() ? 1 : markup.closes() ? -1 : 0;
    if (depth > max_nesting)
      throw Error(ErrorCode::limit_exceeded, markup.place(),
                  "elements are nested more than " + std::to_string(max_nesting) + " deep", "flatten the file");
  }
}

}  // namespace uhas
