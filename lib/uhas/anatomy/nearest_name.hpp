// A suggestion for a name that is not known.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace uhas {

/// The most similar of `known`: one that begins like `name` comes before others, then the fewest changed letters
/// decide, then the order. Empty when `known` is.
std::string nearest_name(std::string_view name, std::span<const std::string_view> known);

/// `did you mean "x"?` with the nearest of `known`: the remedy of an error. Empty when `known` is.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

}  // namespace uhas
