// uhas.h: observing.
#include "uhas/c/call.hpp"
#include "uhas/runtime/observation.hpp"

using namespace uhas;

struct uhas_observer : c::Both<Observer> {
  using Both::Both;
};

namespace {

ObservationOptions observation_options(const uhas_observation_options* given) {
  const uhas_observation_options options = c::read_options(given, UHAS_OBSERVATION_OPTIONS_INIT);
  if (options.points >> kFingerPoints != 0) c::refuse("points names more than seven", "set bits 0 to 6");
  ObservationOptions result{.pad_directions = options.pad_directions != 0};
  for (int i = 0; i < kFingerPoints; ++i) result.points[i] = (options.points >> i & 1u) != 0;
  return result;
}

template <class Real>
int observe(uhas_observer* handle, const Real* q, std::size_t q_size, const Real* qd, std::size_t qd_size,
            Real* observations, std::size_t observations_size, int* statuses) noexcept {
  if (handle == nullptr || q == nullptr || qd == nullptr || observations == nullptr) return UHAS_WRONG_SIZE;
  Observer<Real>& observer = handle->in<Real>();
  const std::size_t hands = q_size / observer.joint_count();
  return static_cast<int>(observer.observe_batch(std::span(q, q_size), std::span(qd, qd_size),
                                                 std::span(observations, observations_size),
                                                 c::statuses_of(statuses, hands)));
}

}  // namespace

int uhas_observer_create(const uhas_profile* profile, const uhas_observation_options* options, uhas_observer** observer,
                         char* message, size_t message_size) {
  return c::create(observer, {message, message_size},
                   [&] { return new uhas_observer(c::profile_of(profile), observation_options(options)); });
}

void uhas_observer_free(uhas_observer* observer) { delete observer; }

size_t uhas_observer_size(const uhas_observer* observer) { return observer->in_double.size(); }

int uhas_observer_observe(uhas_observer* observer, const double* q, size_t q_size, const double* qd, size_t qd_size,
                          double* observations, size_t observations_size, int* statuses) {
  return observe(observer, q, q_size, qd, qd_size, observations, observations_size, statuses);
}

int uhas_observer_observe_f(uhas_observer* observer, const float* q, size_t q_size, const float* qd, size_t qd_size,
                            float* observations, size_t observations_size, int* statuses) {
  return observe(observer, q, q_size, qd, qd_size, observations, observations_size, statuses);
}
