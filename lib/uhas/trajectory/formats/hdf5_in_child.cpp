#include "uhas/trajectory/formats/hdf5_in_child.hpp"

#include <cstring>
#include <optional>
#include <span>

#include "uhas/base/errors.hpp"
#include "uhas/trajectory/formats/hdf5_reader.hpp"
#include "uhas/trajectory/trajectory_json.hpp"

namespace uhas {
namespace {

constexpr std::size_t kBlockValues = 1u << 14;

/// What the child does: hands over the header as JSON, then blocks of frames, each with the progress so far before its
/// values; a block without a frame is the end.
class Sender {
 public:
  Sender(std::string path, std::uint64_t max_bytes) : path_(std::move(path)), max_bytes_(max_bytes) {}

  std::vector<std::byte> operator()(std::size_t i) {
    if (i > 0) return block();
    reader_ = open_hdf5_trajectory(path_, max_bytes_);
    const std::string header = to_line(to_json(reader_->header()));
    const auto bytes = std::as_bytes(std::span(header));
    return {bytes.begin(), bytes.end()};
  }

 private:
  std::vector<std::byte> block() {
    std::vector<double> values{0};
    std::vector<double> q;
    while (values.size() < kBlockValues && reader_->next(q)) values.insert(values.end(), q.begin(), q.end());
    values[0] = reader_->progress();
    const auto bytes = std::as_bytes(std::span(values));
    return {bytes.begin(), bytes.end()};
  }

  std::string path_;
  std::uint64_t max_bytes_;
  std::shared_ptr<TrajectoryReader> reader_;
};

class ChildReader : public TrajectoryReader {
 public:
  ChildReader(TrajectoryHeader header, std::unique_ptr<ChildProcess> child, std::string path)
      : TrajectoryReader(std::move(header)), child_(std::move(child)), path_(std::move(path)) {}

  bool next(std::vector<double>& q) override {
    const std::size_t joints = header().joint_names.size();
    if (next_ == block_.size()) receive(joints);
    if (next_ == block_.size()) return false;
    const auto frame = std::span(block_).subspan(next_, joints);
    q.assign(frame.begin(), frame.end());
    next_ += joints;
    return true;
  }
  double progress() const override { return block_[0]; }

 private:
  void receive(std::size_t joints) {
    const std::vector<std::byte> bytes = child_->next(path_);
    const std::size_t values = bytes.size() / sizeof(double);
    if (values == 0 || bytes.size() % sizeof(double) != 0 || joints == 0 || (values - 1) % joints != 0)
      throw Error(ErrorCode::syntax, path_, "the process that read it handed over no frames", "do not trust the file");
    block_.resize(values);
    std::memcpy(block_.data(), bytes.data(), bytes.size());
    next_ = 1;
  }

  std::unique_ptr<ChildProcess> child_;
  std::string path_;
  std::vector<double> block_{0};  // progress, then [frames][joints]
  std::size_t next_ = 1;          // index into it
};

}  // namespace

std::unique_ptr<TrajectoryReader> open_hdf5_trajectory_in_child(const std::string& path, std::uint64_t max_bytes,
                                                                const ChildLimits& limits) {
  auto child = std::make_unique<ChildProcess>(limits, ErrorCode::syntax, path, SIZE_MAX, Sender(path, max_bytes));
  const std::vector<std::byte> bytes = child->next(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::optional<TrajectoryHeader> header = header_of(parse_json(text, path), path);
  if (!header)
    throw Error(ErrorCode::syntax, path, "the process that read it handed over no trajectory", "do not trust the file");
  return std::make_unique<ChildReader>(std::move(*header), std::move(child), path);
}

}  // namespace uhas
