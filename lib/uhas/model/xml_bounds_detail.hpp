// Bounds on the shape of an XML text, checked before a parser that recurses sees it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace uhas::detail {

/// A tag as it is written: <a b="c">, </a> or <a/>.
struct XmlTag {
  std::string_view text;
  std::size_t position = 0;  ///< in the file

  bool closes() const { return text.starts_with("</"); }
  bool is_empty() const { return text.ends_with("/>"); }
};

/// Calls `visit` for each tag of `text` in order; comments, declarations and CDATA are passed over.
/// Throws Error(syntax), naming `file` and the line, for text that ends inside a tag, and what `visit` throws.
void for_each_tag(std::string_view text, const std::string& file, const std::function<void(const XmlTag&)>& visit);

/// XML parsers recurse once a level of elements and search the attributes of a tag linearly; this refuses, in one pass,
/// what would exhaust the stack or the user's patience, and text that ends inside a tag.
/// Throws Error: limit_exceeded, syntax; both name `file` and the line.
void check_xml_bounds(std::string_view text, const std::string& file);

}  // namespace uhas::detail
