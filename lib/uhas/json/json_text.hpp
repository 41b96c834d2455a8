// JSON in and out: documents that keep the order of their keys, read within bounds, printed for people and machines alike.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "uhas/base/rigid_transform.hpp"

namespace uhas {

using Json = nlohmann::ordered_json;

inline constexpr int kJsonVersion = 1;  ///< of every JSON format that uhas writes

/// A document of `format`, version kJsonVersion; every document opens so.
Json new_document(const std::string& format);

Json to_json(Vector3d v);          ///< [x, y, z]
Json to_json(const Rotationd& R);  ///< three rows

/// Indented text: what fits in a line stays in one, lists of numbers too. Numbers round-trip; NaN is null.
/// Bytes that are not UTF-8 become U+FFFD. Ends with a line break.
std::string to_text(const Json& document);

/// The same in one line, for JSON Lines.
std::string to_line(const Json& document);

/// The same with sorted keys and without blanks: documents that are equal have the same text, whatever order their keys
/// came in. Text must be UTF-8: throws nlohmann::json::type_error.
std::string to_canonical_text(const Json& document);

/// Parses `text`. Throws Error(syntax) naming `file` and the line; also for more than 8 levels of nesting, and for an
/// object of more than 10,000 keys.
Json parse_json(std::string_view text, const std::string& file);

/// Reads and parses a file of at most `max_bytes`. Throws Error: file_unreadable; limit_exceeded, with `remedy`; syntax.
Json read_json_file(const std::string& path, std::uint64_t max_bytes, const std::string& remedy);

}  // namespace uhas
