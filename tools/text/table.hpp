// Text in aligned columns.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "text/terminal.hpp"

namespace uhas::tools {

enum class Align { left, right };

/// Rows of cells under a header; columns are as wide as their widest cell.
class Table {
 public:
  struct Column {
    std::string header;
    Align align = Align::left;
  };

  struct Cell {
    std::string text;
    Tone tone = Tone::plain;

    Cell(std::string text_, Tone tone_ = Tone::plain) : text(std::move(text_)), tone(tone_) {}
    Cell(const char* text_) : text(text_) {}
  };

  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// One cell a column.
  void add_row(std::vector<Cell> cells) { rows_.push_back(std::move(cells)); }

  void print(std::ostream& out) const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace uhas::tools
