// Writes the datasets that `visit_layout` shows into an open HDF5 file.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "uhas/hdf5/handle.hpp"
#include "uhas/profile_io/layout/element.hpp"

namespace uhas {

class LayoutWriter {
 public:
  /// `path` is for error messages: Error(write_failed).
  LayoutWriter(hid_t file, const std::string& path);

  template <class Column, class Row>
  void value(const char* group, const Column& column, const Row& row) {
    write_column(group, column, std::span(&row, 1), {});
  }

  template <class Row, class... Columns>
  void table(const char* group, const std::vector<Row>& rows, const Columns&... columns) {
    (write_column(group, columns, std::span(rows), {rows.size()}), ...);
  }

 private:
  using Shape = std::vector<hsize_t>;

  /// `leading` is the dimension of rows: one number, or none for a single value.
  template <class Column, class Row>
  void write_column(const std::string& group, const Column& column, std::span<const Row> rows, Shape leading) {
    using Value = typename Column::template Value<const Row>;
    const std::string name = group + "/" + column.name;
    if constexpr (std::is_same_v<Value, std::string>) {
      std::vector<std::string> texts;
      for (const Row& row : rows) texts.push_back(std::invoke(column.projection, row));
      write_strings(name, leading, texts);
    } else if constexpr (is_list<Value>) {
      Value flat;
      std::vector<std::int32_t> offsets{0};
      for (const Row& row : rows) {
        const Value& list = std::invoke(column.projection, row);
        flat.insert(flat.end(), list.begin(), list.end());
        offsets.push_back(static_cast<std::int32_t>(flat.size()));
      }
      write_numbers(name, column.units, {flat.size()}, flat);
      write_numbers(name + "_offsets", "", {offsets.size()}, offsets);
    } else {
      using Number = typename Element<Value>::Number;
      std::vector<Number> numbers(rows.size() * element_size<Value>());
      for (std::size_t i = 0; i < rows.size(); ++i)
        Element<Value>::store(std::invoke(column.projection, rows[i]), numbers.data() + i * element_size<Value>());
      leading.insert(leading.end(), Element<Value>::shape.begin(), Element<Value>::shape.end());
      write_numbers(name, column.units, leading, numbers);
    }
  }

  template <class Number>
  void write_numbers(const std::string& name, const char* units, const Shape& shape,
                     const std::vector<Number>& numbers) {
    write_dataset(name, units, shape, stored_type<Number>(), memory_type<Number>(), numbers.data());
  }
  void write_strings(const std::string& name, const Shape& shape, const std::vector<std::string>& texts);
  void write_dataset(const std::string& name, const char* units, const Shape& shape, hid_t stored, hid_t memory,
                     const void* data);
  void require_group(const std::string& name);
  void require(bool succeeded, const std::string& name) const;

  hid_t file_;
  const std::string& path_;
};

/// Attaches a fixed-length string to an object of the file; false when HDF5 fails.
bool write_string_attribute(hid_t object, const char* name, const std::string& text);

}  // namespace uhas
