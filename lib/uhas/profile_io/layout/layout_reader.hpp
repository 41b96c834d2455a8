// Reads the datasets that `visit_layout` shows from an open HDF5 file, each only if its type and shape
// are the format's.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "uhas/hdf5/handle.hpp"
#include "uhas/profile_io/layout/element.hpp"

namespace uhas {

class LayoutReader {
 public:
  /// `path` is for error messages: Error(invalid_profile).
  LayoutReader(hid_t file, const std::string& path);

  template <class Column, class Row>
  void value(const char* group, const Column& column, Row& row) const {
    read_column(group, column, std::span(&row, 1), {});
  }

  /// The first column, which is never a list, says how many rows there are.
  template <class Row, class... Columns>
  void table(const char* group, std::vector<Row>& rows, const Columns&... columns) const {
    const auto& first = std::get<0>(std::tie(columns...));
    rows.resize(row_count(std::string(group) + "/" + first.name));
    (read_column(group, columns, std::span(rows), {rows.size()}), ...);
  }

 private:
  using Shape = std::vector<hsize_t>;

  /// `leading` is the dimension of rows: one number, or none for a single value.
  template <class Column, class Row>
  void read_column(const std::string& group, const Column& column, std::span<Row> rows, Shape leading) const {
    using Value = typename Column::template Value<Row>;
    const std::string name = group + "/" + column.name;
    if constexpr (std::is_same_v<Value, std::string>) {
      const std::vector<std::string> texts = read_strings(name, leading, rows.size());
      for (std::size_t i = 0; i < rows.size(); ++i) std::invoke(column.projection, rows[i]) = texts[i];
    } else if constexpr (is_list<Value>) {
      const std::vector<std::int32_t> offsets = read_offsets(name + "_offsets", rows.size());
      const auto flat_size = static_cast<std::size_t>(offsets.back());
      const auto flat = read_numbers<typename Value::value_type>(name, {flat_size}, flat_size);
      for (std::size_t i = 0; i < rows.size(); ++i)
        std::invoke(column.projection, rows[i]).assign(flat.begin() + offsets[i], flat.begin() + offsets[i + 1]);
    } else {
      leading.insert(leading.end(), Element<Value>::shape.begin(), Element<Value>::shape.end());
      constexpr std::size_t size = element_size<Value>();
      const auto numbers = read_numbers<typename Element<Value>::Number>(name, leading, rows.size() * size);
      for (std::size_t i = 0; i < rows.size(); ++i)
        if (!Element<Value>::load(numbers.data() + i * size, std::invoke(column.projection, rows[i])))
          refuse(name, "holds a value that its meaning does not allow");
    }
  }

  template <class Number>
  std::vector<Number> read_numbers(const std::string& name, const Shape& shape, std::size_t count) const {
    const Hdf5Handle dataset = open_dataset(name, shape);
    require_type(dataset.id(), stored_type<Number>(), name);
    std::vector<Number> numbers(count);
    read_dataset(dataset.id(), memory_type<Number>(), numbers.data(), name);
    return numbers;
  }

  std::size_t row_count(const std::string& name) const;
  std::vector<std::int32_t> read_offsets(const std::string& name, std::size_t rows) const;
  std::vector<std::string> read_strings(const std::string& name, const Shape& shape, std::size_t count) const;

  Hdf5Handle open_dataset(const std::string& name) const;
  Hdf5Handle open_dataset(const std::string& name, const Shape& expected) const;
  void require_type(hid_t dataset, hid_t expected, const std::string& name) const;
  void read_dataset(hid_t dataset, hid_t memory, void* data, const std::string& name) const;
  [[noreturn]] void refuse(const std::string& name, const std::string& problem) const;

  hid_t file_;
  const std::string& path_;
};

}  // namespace uhas
