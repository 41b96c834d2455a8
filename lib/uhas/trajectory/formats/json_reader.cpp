#include "uhas/trajectory/formats/json_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "uhas/base/errors.hpp"
#include "uhas/json/json_lines.hpp"
#include "uhas/trajectory/trajectory_json.hpp"

namespace uhas {
namespace {

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

/// The documents of a file of JSON Lines, with their places.
class LinesOfFile {
 public:
  explicit LinesOfFile(const std::string& path) : path_(path), file_(path, std::ios::binary), lines_(file_) {
    std::error_code ignored;
    if (!file_ || !std::filesystem::is_regular_file(path, ignored))
      throw Error(ErrorCode::file_unreadable, path, "cannot be opened as a file", "check the path and its permissions");
    size_ = double(std::filesystem::file_size(path, ignored));
  }

  /// The document of the next line; nothing at the end.
  std::optional<Json> next() {
    if (!lines_.next()) return std::nullopt;
    try {
      return lines_.document();
    } catch (const Error& error) {
      const bool too_long = error.code() == ErrorCode::limit_exceeded;
      throw Error(ErrorCode::syntax, place(), error.what(), too_long ? "write one frame a line" : "");
    }
  }
  std::string place() const { return path_ + ":" + std::to_string(lines_.number()); }
  double progress() const { return size_ > 0 ? std::min(double(lines_.bytes_read()) / size_, 1.0) : 1; }

 private:
  std::string path_;
  std::ifstream file_;
  JsonLines lines_;
  double size_ = 0;  // bytes
};

class JsonLinesReader : public TrajectoryReader {
 public:
  JsonLinesReader(std::unique_ptr<LinesOfFile> lines, TrajectoryHeader header)
      : TrajectoryReader(std::move(header)), lines_(std::move(lines)) {}

  bool next(std::vector<double>& q) override {
    std::optional<Json> line = lines_->next();
    if (line && line->is_object() && line->contains("summary")) line = lines_->next();  // the last line of such a file
    if (line) q = frame_of(*line, header().joint_names.size(), lines_->place());
    return line.has_value();
  }
  double progress() const override { return lines_->progress(); }

 private:
  std::unique_ptr<LinesOfFile> lines_;
};

}  // namespace

std::unique_ptr<TrajectoryReader> open_json_trajectory(const std::string& path, std::uint64_t max_bytes) {
  Json document = read_json_file(path, max_bytes, "split it, or raise TrajectoryLimits::max_json_bytes");
  const std::optional<TrajectoryHeader> header = header_of(document, path);
  if (!header || !document.contains("q") || !document["q"].is_array())
    throw Error(ErrorCode::syntax, path, "is not a trajectory: no \"joint_names\" or no \"q\"",
                "see schemas/trajectory.schema.json");
  return std::make_unique<JsonReader>(path, *header, std::move(document["q"]));
}

std::unique_ptr<TrajectoryReader> open_json_lines_trajectory(const std::string& path) {
  auto lines = std::make_unique<LinesOfFile>(path);
  const std::optional<Json> first = lines->next();
  const std::optional<TrajectoryHeader> header = first ? header_of(*first, lines->place()) : std::nullopt;
  if (!header)
    throw Error(ErrorCode::syntax, path, "does not open with the order of the joints",
                R"(write a first line {"format": "uhas-trajectory", "version": 1, "joint_names": [...]})");
  return std::make_unique<JsonLinesReader>(std::move(lines), *header);
}

}  // namespace uhas
