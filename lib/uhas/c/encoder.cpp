// uhas.h: encoding and retargeting.
#include "uhas/c/call.hpp"
#include "uhas/runtime/retarget.hpp"

using namespace uhas;

struct uhas_encoder : c::Both<Encoder> {
  uhas_encoder(const HandProfile& profile, const c::SolveSettings& solve)
      : Both(profile, solve.options, solve.driving_vectors) {}
};

struct uhas_retargeter : c::Both<Retargeter> {
  uhas_retargeter(const HandProfile& from, const HandProfile& to, const c::SolveSettings& solve)
      : Both(from, to, solve.options, solve.driving_vectors) {}
};

namespace {

uhas_encode_report c_report(const EncodeReport& report) {
  uhas_encode_report told{report.residual_max, report.residual_rms, {}, {}};
  for (int f = 0; f < kSlotCount; ++f) {
    told.finger_residual[f] = report.fingers[f].residual;
    told.finger_joint[f] = report.fingers[f].joint;
  }
  return told;
}

/// Posture after posture from q [N][from] to out [N][to] by `run`.
template <class Real, class Run>
int each_posture(std::span<const Real> q, std::size_t from, std::span<Real> out, std::size_t to,
                 uhas_encode_report* reports, int* statuses, Run&& run) noexcept {
  const std::ptrdiff_t hands = c::rows_of(q.size(), from);
  if (hands < 0 || out.size() != hands * to) return UHAS_WRONG_SIZE;
  return static_cast<int>(each_row(hands, c::statuses_of(statuses, hands), [&](std::size_t n) {
    EncodeReport report;
    const Status status = run(q.subspan(n * from, from), out.subspan(n * to, to), report);
    if (status == Status::ok && reports != nullptr) reports[n] = c_report(report);
    return status;
  }));
}

template <class Real>
int encode(uhas_encoder* handle, const Real* q, std::size_t q_size, Real* actions, std::size_t actions_size,
           uhas_encode_report* reports, int* statuses) noexcept {
  if (handle == nullptr || q == nullptr || actions == nullptr) return UHAS_WRONG_SIZE;
  Encoder<Real>& encoder = handle->in<Real>();
  return each_posture<Real>({q, q_size}, encoder.joint_count(), {actions, actions_size}, encoder.action_size(), reports,
                            statuses,
                            [&](auto from, auto to, EncodeReport& report) { return encoder.encode(from, to, report); });
}

template <class Real>
int retarget(uhas_retargeter* handle, const Real* q_from, std::size_t q_from_size, Real* q_to, std::size_t q_to_size,
             uhas_encode_report* reports, int* statuses) noexcept {
  if (handle == nullptr || q_from == nullptr || q_to == nullptr) return UHAS_WRONG_SIZE;
  Retargeter<Real>& retargeter = handle->in<Real>();
  return each_posture<Real>(
      {q_from, q_from_size}, retargeter.joint_count_from(), {q_to, q_to_size}, retargeter.joint_count_to(), reports,
      statuses, [&](auto from, auto to, EncodeReport& report) { return retargeter.retarget(from, to, report); });
}

}  // namespace

int uhas_encoder_create(const uhas_profile* profile, const uhas_solve_options* options, uhas_encoder** encoder,
                        char* message, size_t message_size) {
  return c::create(encoder, {message, message_size},
                   [&] { return new uhas_encoder(c::profile_of(profile), c::solve_settings(options)); });
}

void uhas_encoder_free(uhas_encoder* encoder) { delete encoder; }

int uhas_encoder_encode(uhas_encoder* encoder, const double* q, size_t q_size, double* actions, size_t actions_size,
                        uhas_encode_report* reports, int* statuses) {
  return encode(encoder, q, q_size, actions, actions_size, reports, statuses);
}

int uhas_encoder_encode_f(uhas_encoder* encoder, const float* q, size_t q_size, float* actions, size_t actions_size,
                          uhas_encode_report* reports, int* statuses) {
  return encode(encoder, q, q_size, actions, actions_size, reports, statuses);
}

int uhas_retargeter_create(const uhas_profile* from, const uhas_profile* to, const uhas_solve_options* options,
                           uhas_retargeter** retargeter, char* message, size_t message_size) {
  return c::create(retargeter, {message, message_size}, [&] {
    return new uhas_retargeter(c::profile_of(from), c::profile_of(to), c::solve_settings(options));
  });
}

void uhas_retargeter_free(uhas_retargeter* retargeter) { delete retargeter; }

int uhas_retargeter_retarget(uhas_retargeter* retargeter, const double* q_from, size_t q_from_size, double* q_to,
                             size_t q_to_size, uhas_encode_report* reports, int* statuses) {
  return retarget(retargeter, q_from, q_from_size, q_to, q_to_size, reports, statuses);
}

int uhas_retargeter_retarget_f(uhas_retargeter* retargeter, const float* q_from, size_t q_from_size, float* q_to,
                               size_t q_to_size, uhas_encode_report* reports, int* statuses) {
  return retarget(retargeter, q_from, q_from_size, q_to, q_to_size, reports, statuses);
}
