#include "uhas/anatomy/nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace uhas {
namespace {

/// Levenshtein distance: how many letters one has to insert, remove or change.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, change});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string_view> known) {
  const auto difference = [name](std::string_view candidate) {
    const bool begins_alike = !name.empty() && (candidate.starts_with(name) || name.starts_with(candidate));
    return std::pair(!begins_alike, edit_distance(name, candidate));
  };
  const auto nearest = std::ranges::min_element(known, {}, difference);
  return nearest == known.end() ? std::string() : std::string(*nearest);
}

std::string did_you_mean(std::string_view name, std::span<const std::string_view> known) {
  return known.empty() ? std::string() : "did you mean \"" + nearest_name(name, known) + "\"?";
}

}  // namespace uhas
