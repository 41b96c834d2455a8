// How one field of the profile lies in a dataset: which numbers, in which trailing shape.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "uhas/base/homogeneous_matrix.hpp"

namespace uhas {

static_assert(sizeof(int) == sizeof(std::int32_t));

/// `Number`: the number stored; `shape`: trailing dimensions; `store` fills, `load` reads as many numbers as the shape
/// has elements; `load` is false when they are no value of `T`.
template <class T>
struct Element;

template <>
struct Element<double> {
  using Number = double;
  static constexpr std::array<std::uint64_t, 0> shape{};
  static void store(double value, Number* numbers) { *numbers = value; }
  static bool load(const Number* numbers, double& value) {
    value = *numbers;
    return true;
  }
};

template <class T>
requires std::same_as<T, int> || std::is_enum_v<T>
struct Element<T> {
  using Number = std::int32_t;
  static constexpr std::array<std::uint64_t, 0> shape{};
  static void store(T value, Number* numbers) { *numbers = static_cast<Number>(value); }
  static bool load(const Number* numbers, T& value) {
    value = static_cast<T>(*numbers);
    return true;
  }
};

template <>
struct Element<bool> {
  using Number = std::uint8_t;
  static constexpr std::array<std::uint64_t, 0> shape{};
  static void store(bool value, Number* numbers) { *numbers = value; }
  static bool load(const Number* numbers, bool& value) {
    value = *numbers != 0;
    return *numbers <= 1;
  }
};

template <std::size_t count>
struct Element<std::array<bool, count>> {
  using Number = std::uint8_t;
  static constexpr std::array<std::uint64_t, 1> shape{count};
  static void store(const std::array<bool, count>& value, Number* numbers) {
    std::copy(value.begin(), value.end(), numbers);
  }
  static bool load(const Number* numbers, std::array<bool, count>& value) {
    bool is_valid = true;
    for (std::size_t i = 0; i < count; ++i) is_valid &= Element<bool>::load(numbers + i, value[i]);
    return is_valid;
  }
};

template <>
struct Element<Vector3d> {
  using Number = double;
  static constexpr std::array<std::uint64_t, 1> shape{3};
  static void store(const Vector3d& a, Number* numbers) { numbers[0] = a.x, numbers[1] = a.y, numbers[2] = a.z; }
  static bool load(const Number* numbers, Vector3d& a) {
    a = {numbers[0], numbers[1], numbers[2]};
    return true;
  }
};

/// A homogeneous matrix, row-major.
template <>
struct Element<RigidTransformd> {
  using Number = double;
  static constexpr std::array<std::uint64_t, 2> shape{4, 4};
  static void store(const RigidTransformd& T, Number* numbers) {
    const std::array<double, 16> matrix = homogeneous_matrix(T);
    std::copy(matrix.begin(), matrix.end(), numbers);
  }
  static bool load(const Number* m, RigidTransformd& T) {
    T.rotation = {{m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}};
    T.translation = {m[3], m[7], m[11]};
    return m[12] == 0 && m[13] == 0 && m[14] == 0 && m[15] == 1;
  }
};

/// Numbers in one element of `T`.
template <class T>
constexpr std::size_t element_size() {
  std::size_t size = 1;
  for (const std::uint64_t extent : Element<T>::shape) size *= extent;
  return size;
}

/// A row that holds a list is stored as one flat dataset and the offsets of the rows in it.
template <class T>
inline constexpr bool is_list = false;
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

/// A dataset of a table: its name, the unit of its numbers ("" where none applies) and the member of a row
/// that it holds.
template <class Projection>
struct Column {
  const char* name;
  const char* units;
  Projection projection;

  template <class Row>
  using Value = std::remove_cvref_t<std::invoke_result_t<Projection, Row&>>;
};
template <class Projection>
Column(const char*, const char*, Projection) -> Column<Projection>;  // which Clang 14 does not find by itself

}  // namespace uhas
