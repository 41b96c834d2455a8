#include "tables/table.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
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

std::string fixed(double value, int decimals) {
  std::array<char, 400> text{};  // the largest double has 309 digits before the point
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  std::string result = text.data();
  const bool is_zero = result.find_first_of("123456789in") == std::string::npos;  // "in": inf and nan
  return is_zero && result[0] == '-' ? result.substr(1) : result;
}

std::string degrees(double radians) { return fixed(radians * 180 / std::numbers::pi, 1); }

std::string millimetres(double metres) { return fixed(metres * 1000, 1); }

std::string join(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i > 0 ? separator : "") + words[i];
  return text;
}

}  // namespace uhas::tools
