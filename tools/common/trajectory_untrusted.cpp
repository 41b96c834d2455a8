#include "common/trajectory_untrusted.hpp"

#include <algorithm>
#include <cstring>

#include "common/trajectory_hdf5.hpp"
#include "common/trajectory_json.hpp"
#include "uhas/base/child_process.hpp"

namespace uhas::tools {
namespace {

/// Frames that are all in memory, one after another.
class HeldReader : public TrajectoryReader {
 public:
  HeldReader(TrajectoryHeader header, std::vector<double> values)
      : TrajectoryReader(std::move(header)), values_(std::move(values)) {}

  bool next(std::vector<double>& q) override {
    if (next_ == values_.size()) return false;
    const std::span<const double> frame = std::span(values_).subspan(next_, header().joint_names.size());
    q.assign(frame.begin(), frame.end());
    next_ += frame.size();
    return true;
  }
  double progress() const override { return double(next_) / double(std::max<std::size_t>(values_.size(), 1)); }

 private:
  std::vector<double> values_;  // [frames][joints]
  std::size_t next_ = 0;
};

/// The header as a line of JSON, then the values of all frames.
std::vector<std::byte> to_bytes(TrajectoryReader& reader) {
  const std::string header = to_line(to_json(reader.header()));
  const auto header_bytes = std::as_bytes(std::span(header));
  std::vector<std::byte> bytes(header_bytes.begin(), header_bytes.end());
  for (std::vector<double> q; reader.next(q);) {
    const auto frame = std::as_bytes(std::span(q));
    bytes.insert(bytes.end(), frame.begin(), frame.end());
  }
  return bytes;
}

/// The inverse. Throws Error(syntax) in the name of `path` for bytes that are no trajectory.
std::unique_ptr<TrajectoryReader> from_bytes(std::span<const std::byte> bytes, const std::string& path) {
  const auto line_size = static_cast<std::size_t>(std::ranges::find(bytes, std::byte{'\n'}) - bytes.begin());
  const std::string_view line(reinterpret_cast<const char*>(bytes.data()), line_size);
  std::optional<TrajectoryHeader> header = header_of(parse_json(line, path), path);
  const std::span<const std::byte> frames = bytes.subspan(std::min(line_size + 1, bytes.size()));
  const std::size_t frame_size = header ? header->joint_names.size() * sizeof(double) : 0;
  if (!header || (frame_size == 0 ? !frames.empty() : frames.size() % frame_size != 0))
    throw Error(ErrorCode::syntax, path, "the process that read it handed over no trajectory", "do not trust the file");
  std::vector<double> values(frames.size() / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), frames.data(), frames.size());
  return std::make_unique<HeldReader>(std::move(*header), std::move(values));
}

}  // namespace

std::unique_ptr<TrajectoryReader> open_untrusted_hdf5_trajectory(const std::string& path, std::uint64_t max_bytes) {
  return from_bytes(
      in_child({}, ErrorCode::syntax, path, [&] { return to_bytes(*open_hdf5_trajectory(path, max_bytes)); }), path);
}

}  // namespace uhas::tools
