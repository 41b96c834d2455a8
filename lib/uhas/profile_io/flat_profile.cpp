// The bytes are those of `visit_layout`'s datasets in turn. Numbers are little-endian; a text, a list and a table open
// with their length. A table follows dataset by dataset, as in the file.
#include "uhas/profile_io/flat_profile.hpp"

#include <array>
#include <bit>
#include <functional>
#include <string>

#include "uhas/base/errors.hpp"
#include "uhas/profile_io/layout/layout.hpp"

namespace uhas {
namespace {

using Length = std::uint32_t;

constexpr std::array<std::uint8_t, 8> kSignature{'u', 'h', 'a', 's', 'f', 'l', 'a', 't'};

/// The unsigned integer of a number's size.
template <class Number>
using Word = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
                                std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint8_t>>;

class FlatWriter {
 public:
  FlatWriter() { put_all(kSignature); }

  template <class Column, class Row>
  void value(const char*, const Column& column, const Row& row) {
    put_value(std::invoke(column.projection, row));
  }

  template <class Row, class... Columns>
  void table(const char*, const std::vector<Row>& rows, const Columns&... columns) {
    put_length(rows.size());
    const auto put_column = [&](const auto& column) {
      for (const Row& row : rows) put_value(std::invoke(column.projection, row));
    };
    (put_column(columns), ...);
  }

  std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  template <class Value>
  void put_value(const Value& value) {
    if constexpr (std::is_same_v<Value, std::string> || is_list<Value>) {
      put_length(value.size());
      put_all(value);
    } else {
      std::array<typename Element<Value>::Number, element_size<Value>()> numbers;
      Element<Value>::store(value, numbers.data());
      put_all(numbers);
    }
  }

  void put_length(std::size_t length) { put_number(static_cast<Length>(length)); }

  template <class Numbers>
  void put_all(const Numbers& numbers) {
    for (const auto& number : numbers) put_number(number);
  }

  template <class Number>
  void put_number(Number number) {
    const auto word = std::bit_cast<Word<Number>>(number);
    for (std::size_t i = 0; i < sizeof word; ++i) bytes_.push_back(static_cast<std::byte>(word >> (8 * i)));
  }

  std::vector<std::byte> bytes_;
};

class FlatReader {
 public:
  explicit FlatReader(std::span<const std::byte> bytes) : bytes_(bytes) {
    std::array<std::uint8_t, kSignature.size()> signature;
    get_all(signature);
    if (signature != kSignature) refuse("does not begin as one");
  }

  template <class Column, class Row>
  void value(const char*, const Column& column, Row& row) {
    get_value(std::invoke(column.projection, row));
  }

  template <class Row, class... Columns>
  void table(const char*, std::vector<Row>& rows, const Columns&... columns) {
    rows.resize(get_length((smallest_size<typename Columns::template Value<Row>>() + ...)));
    const auto get_column = [&](const auto& column) {
      for (Row& row : rows) get_value(std::invoke(column.projection, row));
    };
    (get_column(columns), ...);
  }

  void finish() const {
    if (!bytes_.empty()) refuse("has bytes beyond its end");
  }

 private:
  /// The fewest bytes that a value takes.
  template <class Value>
  static constexpr std::size_t smallest_size() {
    if constexpr (std::is_same_v<Value, std::string> || is_list<Value>)
      return sizeof(Length);
    else
      return element_size<Value>() * sizeof(typename Element<Value>::Number);
  }

  template <class Value>
  void get_value(Value& value) {
    if constexpr (std::is_same_v<Value, std::string> || is_list<Value>) {
      value.resize(get_length(sizeof(typename Value::value_type)));
      get_all(value);
    } else {
      std::array<typename Element<Value>::Number, element_size<Value>()> numbers;
      get_all(numbers);
      if (!Element<Value>::load(numbers.data(), value)) refuse("holds a value that its meaning does not allow");
    }
  }

  /// A number of items of `item_size` bytes or more, which must all be there.
  std::size_t get_length(std::size_t item_size) {
    Length length{};
    get_number(length);
    if (length > bytes_.size() / item_size) refuse("is cut short");
    return length;
  }

  template <class Numbers>
  void get_all(Numbers& numbers) {
    for (auto& number : numbers) get_number(number);
  }

  template <class Number>
  void get_number(Number& number) {
    if (bytes_.size() < sizeof number) refuse("is cut short");
    Word<Number> word{};
    for (std::size_t i = 0; i < sizeof word; ++i)
      word |= static_cast<Word<Number>>(std::to_integer<Word<Number>>(bytes_[i]) << (8 * i));
    number = std::bit_cast<Number>(word);
    bytes_ = bytes_.subspan(sizeof word);
  }

  [[noreturn]] static void refuse(const char* problem) {
    throw Error(ErrorCode::invalid_profile, "", std::string("the flat hand profile ") + problem, "write it again");
  }

  std::span<const std::byte> bytes_;  // those to come
};

}  // namespace

std::vector<std::byte> flatten_profile(const HandProfile& profile) {
  FlatWriter writer;
  visit_layout(writer, profile);
  return writer.take();
}

HandProfile unflatten_profile(std::span<const std::byte> bytes) {
  HandProfile profile;
  FlatReader reader(bytes);
  visit_layout(reader, profile);
  reader.finish();
  validate_profile(profile, "");
  return profile;
}

}  // namespace uhas
