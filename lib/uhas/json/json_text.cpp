#include "uhas/json/json_text.hpp"

#include <algorithm>
#include <array>

#include "uhas/base/errors.hpp"
#include "uhas/files/file_bytes.hpp"

namespace uhas {
namespace {

constexpr std::size_t kLineWidth = 110;
constexpr int kMaxDepth = 8;
constexpr int kMaxKeys = 10'000;  // of an object

std::string dump(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

bool is_flat(const Json& value) {
  return std::ranges::none_of(value, [](const Json& element) { return element.is_structured(); });
}

/// `value` in one line, with a space after each comma and colon.
std::string one_line(const Json& value) {
  if (!value.is_structured()) return dump(value);
  std::string text;
  for (const auto& [key, element] : value.items()) {
    if (!text.empty()) text += ", ";
    if (value.is_object()) text += dump(key) + ": ";
    text += one_line(element);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// Appends `value` in one line when it fits or is a list of numbers or words, else one element a line. `split` demands
/// the latter, for the document as a whole.
void append(const Json& value, std::size_t indent, bool split, std::string& out) {
  if (!split) {
    const std::string line = one_line(value);
    if (indent + line.size() <= kLineWidth || (!value.is_object() && is_flat(value))) {
      out += line;
      return;
    }
  }
  const std::string margin(indent + 2, ' ');
  const char* separator = "\n";
  out += value.is_object() ? "{" : "[";
  for (const auto& [key, element] : value.items()) {
    out += separator + margin;
    if (value.is_object()) out += dump(key) + ": ";
    append(element, indent + 2, false, out);
    separator = ",\n";
  }
  out += "\n" + std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

/// Looks on as a document is parsed. Throws Error(syntax) for too many levels, and for too many keys: a document that
/// keeps their order compares each new key of an object with all before it.
class Bounds {
 public:
  explicit Bounds(const std::string& file) : file_(file) {}

  bool accept(int depth, Json::parse_event_t event) {
    if (depth > kMaxDepth) refuse("nested more than " + std::to_string(kMaxDepth) + " levels deep", "use fewer levels");
    if (event == Json::parse_event_t::object_start) keys_[depth + 1] = 0;
    if (event == Json::parse_event_t::key && ++keys_[depth] > kMaxKeys)
      refuse("an object has more than " + std::to_string(kMaxKeys) + " keys", "use fewer keys");
    return true;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    throw Error(ErrorCode::syntax, file_, problem, remedy);
  }

  const std::string& file_;
  std::array<int, kMaxDepth + 2> keys_{};  // of the object that is open at each depth
};

/// The part of nlohmann's message that says what is wrong, without the exception's name and the place.
std::string problem_of(const nlohmann::json::exception& error) {
  const std::string text = error.what();
  const std::size_t place = text.find("column ");
  const std::size_t start = place == std::string::npos ? text.find("] ") : text.find(": ", place);
  return start == std::string::npos ? text : text.substr(start + 2);
}

}  // namespace

Json new_document(const std::string& format) { return {{"format", format}, {"version", kJsonVersion}}; }

Json to_json(Vector3d v) { return {v.x, v.y, v.z}; }

Json to_json(const Rotationd& R) {
  return {{R.m[0], R.m[1], R.m[2]}, {R.m[3], R.m[4], R.m[5]}, {R.m[6], R.m[7], R.m[8]}};
}

std::string to_text(const Json& document) {
  std::string text;
  append(document, 0, true, text);
  return text + "\n";
}

std::string to_line(const Json& document) { return dump(document) + "\n"; }

std::string to_canonical_text(const Json& document) {
  return nlohmann::json(document).dump();  // which keeps keys sorted
}

Json parse_json(std::string_view text, const std::string& file) {
  Bounds bounds(file);
  const auto look_on = [&](int depth, Json::parse_event_t event, const Json&) { return bounds.accept(depth, event); };
  try {
    return Json::parse(text, look_on);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw Error(ErrorCode::syntax, file.empty() ? "" : file + ":" + std::to_string(line),
                "not JSON: " + problem_of(error), "correct the syntax");
  } catch (const nlohmann::json::exception& error) {  // a number beyond the range of double
    throw Error(ErrorCode::syntax, file, problem_of(error), "write numbers within the range of double");
  }
}

Json read_json_file(const std::string& path, std::uint64_t max_bytes, const std::string& remedy) {
  const std::vector<std::byte> bytes = read_file(path, max_bytes, remedy);
  return parse_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path);
}

}  // namespace uhas
