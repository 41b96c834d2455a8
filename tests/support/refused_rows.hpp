// The rule of refusal of every call for many hands, from C++ and from C: row by row.
#pragma once

#include <doctest/doctest.h>

#include <limits>
#include <span>
#include <vector>

#include "uhas/base/errors.hpp"

namespace uhas::test {

/// Has `run` treat rows, and then the same with some of them changed. The output of every other row must stay the same
/// bit for bit, that of a refused row as it was, and each row's status must be told.
/// @param input    rows, more than 20 and a multiple of no number of lanes; the first number of each is one that is read
/// @param outputs  numbers in a row of output
/// @param run      run(input, output, statuses): the Status of a call
template <class Real, class Run>
void check_refused_rows(std::vector<Real> input, std::size_t rows, std::size_t outputs, Run run) {
  const std::size_t inputs = input.size() / rows;
  REQUIRE(inputs * rows == input.size());
  std::vector<Real> expected(rows * outputs, Real(77)), output = expected;
  std::vector<Status> statuses(rows, Status::wrong_size);
  REQUIRE(run(std::span<const Real>(input), std::span(expected), std::span(statuses)) == Status::ok);
  CHECK(statuses == std::vector<Status>(rows, Status::ok));

  constexpr std::size_t huge = 7, refused[] = {4, 13, 20};
  input[huge * inputs] = Real(1e4);  // no joint angle that wide kernels take: is treated by itself, and not refused
  for (std::size_t row : refused) input[row * inputs] = std::numeric_limits<Real>::quiet_NaN();
  CHECK(run(std::span<const Real>(input), std::span(output), std::span(statuses)) == Status::non_finite_input);
  for (std::size_t row = 0; row < rows; ++row) {
    CAPTURE(row);
    const bool is_refused = row == refused[0] || row == refused[1] || row == refused[2];
    CHECK(statuses[row] == (is_refused ? Status::non_finite_input : Status::ok));
    if (row == huge) continue;
    for (std::size_t i = row * outputs; i < (row + 1) * outputs; ++i)
      CHECK(output[i] == (is_refused ? Real(77) : expected[i]));
  }

  // no statuses are wanted
  output.assign(output.size(), Real(77));
  CHECK(run(std::span<const Real>(input), std::span(output), std::span<Status>()) == Status::non_finite_input);
  CHECK(output[0] == expected[0]);
}

}  // namespace uhas::test
