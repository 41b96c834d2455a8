// The markup of an XML text, piece by piece, without recursion: for checks before a parser sees the text.
#pragma once

#include <string>
#include <string_view>

namespace uhas {

/// Runs over the tags, comments, CDATA sections and declarations of a text.
class XmlMarkup {
 public:
  /// `text` and `file` must outlive the object; `file` is for error messages.
  XmlMarkup(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  /// Goes on to the next piece; false at the end of the text. Throws Error: syntax when the text ends inside it.
  bool next();

  std::string_view piece() const { return text_.substr(start_, end_ - start_); }            ///< "<...>", as it stands
  std::string_view text_before() const { return text_.substr(before_, start_ - before_); }  ///< since the last piece

  bool is_tag() const { return !piece().starts_with("<!") && !piece().starts_with("<?"); }
  bool opens() const { return is_tag() && !piece().starts_with("</") && !piece().ends_with("/>"); }
  bool closes() const { return piece().starts_with("</"); }

  std::string place() const;  ///< "file:line" of the piece

 private:
  std::string_view text_;
  const std::string& file_;
  std::size_t before_ = 0, start_ = 0, end_ = 0;
};

}  // namespace uhas
