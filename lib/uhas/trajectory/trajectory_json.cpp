#include "uhas/trajectory/trajectory_json.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "uhas/json/json_lines.hpp"
#include "output/output.hpp"
#include "uhas/base/errors.hpp"
#include "uhas/files/file_replacement.hpp"

namespace uhas {
namespace {

constexpr const char* kFormat = "uhas-trajectory";
constexpr std::size_t kBufferedBytes = 1u << 16;

Error wrong(const std::string& place, const std::string& problem, const std::string& remedy) {
  return {ErrorCode::syntax, place, problem, remedy};
}

class JsonReader : public TrajectoryReader {
 public:
  JsonReader(std::string path, TrajectoryHeader header, Json frames)
      : TrajectoryReader(std::move(header)), path_(std::move(path)), frames_(std::move(frames)) {}

  bool next(std::vector<double>& q) override {
    if (next_ == frames_.size()) return false;
    q = frame_of(frames_[next_], header().joint_names.size(), path_ + ": frame " + std::to_string(next_));
    ++next_;
    return true;
  }
  double progress() const override { return double(next_) / double(std::max<std::size_t>(frames_.size(), 1)); }

 private:
  std::string path_;
  Json frames_;
  std::size_t next_ = 0;
};

/// The lines of a file, with their places; blank ones are passed over.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    std::error_code ignored;
    if (!file_ || !std::filesystem::is_regular_file(path, ignored))
      throw Error(ErrorCode::file_unreadable, path, "cannot be opened as a file", "check the path and its permissions");
    size_ = double(std::filesystem::file_size(path, ignored));
  }

  /// The JSON of the next line; nothing at the end.
  std::optional<Json> next() {
    while (read_line(file_, line_)) {
      ++number_;
      read_ += double(line_.size() + 1);
      if (line_.size() > kMaxLineBytes) throw wrong(place(), "the line is longer than 1 MiB", "write one frame a line");
      if (line_.find_first_not_of(" \t\r") != std::string::npos) return parse();
    }
    return std::nullopt;
  }
  std::string place() const { return path_ + ":" + std::to_string(number_); }
  double progress() const { return size_ > 0 ? std::min(read_ / size_, 1.0) : 1; }

 private:
  Json parse() const {
    try {
      return parse_json(line_, "");
    } catch (const Error& error) {
      throw wrong(place(), error.what(), "");
    }
  }

  std::string path_, line_;
  std::ifstream file_;
  std::size_t number_ = 0;
  double read_ = 0, size_ = 0;  // bytes
};

class JsonLinesReader : public TrajectoryReader {
 public:
  JsonLinesReader(Lines lines, TrajectoryHeader header)
      : TrajectoryReader(std::move(header)), lines_(std::move(lines)) {}

  bool next(std::vector<double>& q) override {
    std::optional<Json> line = lines_.next();
    if (line && line->is_object() && line->contains("summary")) line = lines_.next();  // the last line of such a file
    if (line) q = frame_of(*line, header().joint_names.size(), lines_.place());
    return line.has_value();
  }
  double progress() const override { return lines_.progress(); }

 private:
  Lines lines_;
};

class JsonWriter : public TrajectoryWriter {
 public:
  JsonWriter(std::string path, const TrajectoryHeader& header) : path_(std::move(path)), document_(to_json(header)) {
    for (Json* list : {&q_, &residual_max_, &residual_rms_}) *list = Json::array();
  }

  void write(std::span<const double> q, const EncodeReport& report) override {
    q_.push_back(std::vector<double>(q.begin(), q.end()));
    residual_max_.push_back(report.residual_max);
    residual_rms_.push_back(report.residual_rms);
  }
  void finish(const TrajectorySummary& summary) override {
    document_["summary"] = to_json(summary);
    document_["q"] = std::move(q_);
    document_["residual_max"] = std::move(residual_max_);
    document_["residual_rms"] = std::move(residual_rms_);
    write_result(path_, to_text(document_));
  }

 private:
  std::string path_;
  Json document_, q_, residual_max_, residual_rms_;
};

class JsonLinesWriter : public TrajectoryWriter {
 public:
  JsonLinesWriter(const std::string& path, const TrajectoryHeader& header) {
    if (!path.empty()) file_.emplace(path);
    buffer_ = to_line(to_json(header));
  }

  void write(std::span<const double> q, const EncodeReport& report) override {
    buffer_ += to_line(to_json(q, report));
    if (buffer_.size() > kBufferedBytes) empty_buffer();
  }
  void finish(const TrajectorySummary& summary) override {
    buffer_ += to_line({{"summary", to_json(summary)}});
    empty_buffer();
    if (file_) file_->commit();
  }

 private:
  void empty_buffer() {
    if (file_)
      file_->write(std::as_bytes(std::span(buffer_)));
    else if (!(std::cout << buffer_))
      throw Error(ErrorCode::write_failed, "standard output", "cannot be written", "");
    buffer_.clear();
  }

  std::optional<FileReplacement> file_;  // none: standard output
  std::string buffer_;
};

}  // namespace

std::unique_ptr<TrajectoryReader> open_json_trajectory(const std::string& path, std::uint64_t max_bytes) {
  Json document = read_json_file(path, max_bytes);
  const std::optional<TrajectoryHeader> header = header_of(document, path);
  if (!header || !document.contains("q") || !document["q"].is_array())
    throw wrong(path, "is not a trajectory: no \"joint_names\" or no \"q\"", "see schemas/trajectory.schema.json");
  return std::make_unique<JsonReader>(path, *header, std::move(document["q"]));
}

std::unique_ptr<TrajectoryReader> open_json_lines_trajectory(const std::string& path) {
  Lines lines(path);
  const std::optional<Json> first = lines.next();
  const std::optional<TrajectoryHeader> header = first ? header_of(*first, lines.place()) : std::nullopt;
  if (!header)
    throw wrong(path, "does not open with the order of the joints",
                R"(write a first line {"format": "uhas-trajectory", "version": 1, "joint_names": [...]})");
  return std::make_unique<JsonLinesReader>(std::move(lines), *header);
}

std::unique_ptr<TrajectoryWriter> create_json_trajectory(const std::string& path, const TrajectoryHeader& header) {
  return std::make_unique<JsonWriter>(path, header);
}

std::unique_ptr<TrajectoryWriter> create_json_lines_trajectory(const std::string& path,
                                                               const TrajectoryHeader& header) {
  return std::make_unique<JsonLinesWriter>(path, header);
}

Json to_json(const TrajectoryHeader& header) {
  Json document = new_document(kFormat);
  document["hand"] = header.hand;
  document["joint_names"] = header.joint_names;
  return document;
}

std::optional<TrajectoryHeader> header_of(const Json& value, const std::string& place) {
  if (!value.is_object() || (!value.contains("format") && !value.contains("joint_names"))) return std::nullopt;
  if (value.value("format", Json()) != kFormat)
    throw wrong(place, "is not a trajectory: no \"format\": \"uhas-trajectory\"", "see schemas/trajectory.schema.json");
  if (const Json version = value.value("version", Json()); version != 1)
    throw Error(ErrorCode::unsupported_version, place, "version is " + version.dump() + ", this tool reads 1",
                "write \"version\": 1");
  const Json names = value.value("joint_names", Json());
  const Json hand = value.value("hand", Json(""));
  const auto is_text = [](const Json& element) { return element.is_string(); };
  if (!names.is_array() || !std::ranges::all_of(names, is_text) || !hand.is_string())
    throw wrong(place, "joint_names is not an array of names, or hand is not a name",
                "name the joints in the order of the values");
  return TrajectoryHeader{hand.get<std::string>(), names.get<std::vector<std::string>>()};
}

std::vector<double> frame_of(const Json& value, std::size_t joints, const std::string& place) {
  const Json& q = value.is_object() && value.contains("q") ? value["q"] : value;
  const auto is_number = [](const Json& element) { return element.is_number(); };
  if (!q.is_array() || !std::ranges::all_of(q, is_number))
    throw wrong(place, "is not a frame", R"(write an array of numbers, or {"q": [numbers]})");
  if (q.size() != joints)
    throw wrong(place, "has " + std::to_string(q.size()) + " values for " + std::to_string(joints) + " joints",
                "write one for each joint of joint_names");
  return q.get<std::vector<double>>();
}

Json to_json(std::span<const double> q, const EncodeReport& report) {
  return {{"q", std::vector<double>(q.begin(), q.end())},
          {"residual_max", report.residual_max},
          {"residual_rms", report.residual_rms}};
}

Json to_json(const TrajectorySummary& summary) {
  return {{"frames", summary.frames},
          {"off_manifold", summary.off_manifold},
          {"tolerance", TrajectorySummary::kTolerance},
          {"residual_rms", summary.residual_rms()},
          {"residual_max", summary.residual_max},
          {"worst_frame", summary.frames == 0 ? Json() : Json(summary.worst_frame)}};
}

}  // namespace uhas
