#include "uhas/trajectory/formats/json_writer.hpp"

#include <ostream>

#include "uhas/base/errors.hpp"
#include "uhas/json/json_text.hpp"
#include "uhas/trajectory/trajectory_json.hpp"

namespace uhas {
namespace {

constexpr std::size_t kBufferedBytes = 1u << 16;

class JsonWriter : public TrajectoryWriter {
 public:
  JsonWriter(TextTarget target, const TrajectoryHeader& header)
      : target_(std::move(target)), document_(to_json(header)) {
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
    target_.write(to_text(document_));
    target_.finish();
  }

 private:
  TextTarget target_;
  Json document_, q_, residual_max_, residual_rms_;
};

class JsonLinesWriter : public TrajectoryWriter {
 public:
  JsonLinesWriter(TextTarget target, const TrajectoryHeader& header)
      : target_(std::move(target)), buffer_(to_line(to_json(header))) {}

  void write(std::span<const double> q, const EncodeReport& report) override {
    buffer_ += to_line(to_json(q, report));
    if (buffer_.size() > kBufferedBytes) empty_buffer();
  }
  void finish(const TrajectorySummary& summary) override {
    buffer_ += to_line({{"summary", to_json(summary)}});
    empty_buffer();
    target_.finish();
  }

 private:
  void empty_buffer() {
    target_.write(buffer_);
    buffer_.clear();
  }

  TextTarget target_;
  std::string buffer_;
};

}  // namespace

void TextTarget::write(std::string_view text) {
  if (file_)
    file_->write(std::as_bytes(std::span(text)));
  else if (!(*stream_ << text))
    throw Error(ErrorCode::write_failed, "the output", "cannot be written", "free some space");
}

void TextTarget::finish() {
  if (file_) file_->commit();
}

std::unique_ptr<TrajectoryWriter> write_json_trajectory(TextTarget target, const TrajectoryHeader& header) {
  return std::make_unique<JsonWriter>(std::move(target), header);
}

std::unique_ptr<TrajectoryWriter> write_json_lines_trajectory(TextTarget target, const TrajectoryHeader& header) {
  return std::make_unique<JsonLinesWriter>(std::move(target), header);
}

}  // namespace uhas
