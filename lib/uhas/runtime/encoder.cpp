#include "uhas/runtime/encoder.hpp"

#include <cmath>
#include <string>

#include "uhas/runtime/encoding/encoding.hpp"

namespace uhas {

template <class Real>
struct Encoder<Real>::Model : EncoderModel {
  using EncoderModel::EncoderModel;
};

template <class Real>
struct Encoder<Real>::Scratch : Encoding<Real> {
  using Encoding<Real>::Encoding;
};

template <class Real>
Encoder<Real>::Encoder(const HandProfile& profile, const SolveOptions& options, int driving_vectors) {
  if (driving_vectors < 1 || driving_vectors > kMaxDrivingVectors)
    throw Error(ErrorCode::invalid_action, "", "the number of driving vectors is " + std::to_string(driving_vectors),
                "choose a number from 1 to 4");
  if (options.convention != ActionConvention{})
    throw Error(ErrorCode::invalid_action, "", "actions can be encoded in uhas' own convention only",
                "leave the convention out");
  const CascadeSolver<Real> solver(profile, options);  // validates both
  const CascadeSolver<Real> relaxed_solver(with_wider_limits(profile), options);
  model_ = std::make_shared<const Model>(profile, options, driving_vectors);
  scratch_ = std::make_unique<Scratch>(*model_, solver, relaxed_solver);
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
Status Encoder<Real>::encode_batch(std::span<const Real> q, std::span<Real> actions,
                                   std::span<EncodeReport> reports) noexcept {
  const std::size_t joints = joint_count(), size = action_size(), count = q.size() / joints;
  if (actions.size() != count * size || (!reports.empty() && reports.size() != count)) return Status::wrong_size;
  if (const Status status = check(q); status != Status::ok) return status;
  for (std::size_t n = 0; n < count; ++n) {
    scratch_->run(*model_, q.subspan(n * joints, joints));
    scratch_->write_action(*model_, actions.subspan(n * size, size));
    if (!reports.empty()) reports[n] = scratch_->report(*model_);
  }
  return Status::ok;
}

template <class Real>
Status Encoder<Real>::check(std::span<const Real> q) const noexcept {
  const std::vector<Joint>& joints = model_->tree.joints;
  if (q.size() % joints.size() != 0) return Status::wrong_size;
  for (std::size_t i = 0; i < q.size(); ++i)
    if (joints[i % joints.size()].mimic_master < 0 && !std::isfinite(q[i])) return Status::non_finite_input;
  return Status::ok;
}

template class Encoder<float>;
template class Encoder<double>;

}  // namespace uhas
