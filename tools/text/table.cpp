#include "text/table.hpp"

#include <algorithm>
#include <ostream>

namespace uhas::tools {
namespace {

/// Code points of UTF-8 text: every byte but the continuation bytes 10xxxxxx.
std::size_t width(const std::string& text) {
  return std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
}

}  // namespace

void Table::print(std::ostream& out) const {
  std::vector<std::size_t> widths;
  for (const Column& column : columns_) widths.push_back(width(column.header));
  for (const auto& row : rows_)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i].text));

  const auto print_row = [&](auto&& cell_in) {
    std::string line;
    std::size_t gap = 0;  // blanks before the next cell; none stay at the end of a line
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const Cell cell = cell_in(i);
      const std::size_t padding = widths[i] - width(cell.text);
      if (columns_[i].align == Align::right) gap += padding;
      if (!cell.text.empty()) line += std::string(gap, ' ') + toned(out, cell.text, cell.tone), gap = 0;
      gap += (columns_[i].align == Align::left ? padding : 0) + 2;
    }
    out << line << '\n';
  };
  print_row([&](std::size_t i) { return Cell(columns_[i].header, Tone::heading); });
  for (const auto& row : rows_) print_row([&](std::size_t i) { return row[i]; });
}

}  // namespace uhas::tools
