#include "uhas/runtime/encoder.hpp"

#include <cmath>
#include <string>

#include "uhas/base/each_row.hpp"
#include "uhas/runtime/encoding/encoding.hpp"

namespace uhas {

template <class Real>
struct Encoder<Real>::Model : EncoderModel {
  using EncoderModel::EncoderModel;
};

template <class Real>
struct Encoder<Real>::Scratch : Encoding {
  using Encoding::Encoding;
};

template <class Real>
Encoder<Real>::Encoder(const HandProfile& profile, const SolveOptions& options, int driving_vectors) {
  if (driving_vectors < 1 || driving_vectors > kMaxDrivingVectors)
    throw Error(ErrorCode::invalid_option, "", "driving_vectors is " + std::to_string(driving_vectors),
                "choose a number from 1 to 4");
  if (options.convention != ActionConvention{})
    throw Error(ErrorCode::invalid_option, "", "convention is not uhas' own, and no other can be encoded",
                "leave it out");
  const CascadeSolver<double> solver(profile, options);  // validates both
  model_ = std::make_shared<const Model>(profile, options, driving_vectors, solver);
  scratch_ = std::make_unique<Scratch>(*model_, solver);
}

template <class Real>
Encoder<Real>::Encoder(const Encoder& other)
    : model_(other.model_), scratch_(std::make_unique<Scratch>(*other.scratch_)) {}

template <class Real>
Encoder<Real>& Encoder<Real>::operator=(const Encoder& other) {
  return *this = Encoder(other);
}

template <class Real>
Encoder<Real>::Encoder(Encoder&&) noexcept = default;
template <class Real>
Encoder<Real>& Encoder<Real>::operator=(Encoder&&) noexcept = default;
template <class Real>
Encoder<Real>::~Encoder() = default;

template <class Real>
int Encoder<Real>::joint_count() const noexcept {
  return static_cast<int>(model_->tree.joints.size());
}

template <class Real>
int Encoder<Real>::action_size() const noexcept {
  return kSlotCount * (1 + model_->driving_vectors);
}

template <class Real>
Status Encoder<Real>::encode(std::span<const Real> q, std::span<Real> action, EncodeReport& report) noexcept {
  if (q.size() != std::size_t(joint_count())) return Status::wrong_size;
  return encode_batch(q, action, {&report, 1});
}

template <class Real>
Status Encoder<Real>::encode_batch(std::span<const Real> q, std::span<Real> actions, std::span<EncodeReport> reports,
                                   std::span<Status> statuses) noexcept {
  const std::vector<Joint>& joints = model_->tree.joints;
  const std::size_t size = action_size(), count = q.size() / joints.size();
  if (q.size() != count * joints.size() || actions.size() != count * size ||
      (!reports.empty() && reports.size() != count) || !holds_statuses(statuses, count))
    return Status::wrong_size;
  return each_row(count, statuses, [&](std::size_t row) {
    const std::span<const Real> posture = q.subspan(row * joints.size(), joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (joints[i].mimic_master < 0 && !std::isfinite(posture[i])) return Status::non_finite_input;
    scratch_->run(*model_, posture);
    scratch_->write_action(*model_, actions.subspan(row * size, size));
    if (!reports.empty()) reports[row] = scratch_->report(*model_);
    return Status::ok;
  });
}

template class Encoder<float>;
template class Encoder<double>;

}  // namespace uhas
