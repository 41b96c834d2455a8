// uhas.h: solving at scale.
#include <vector>

#include "uhas/c/call.hpp"
#include "uhas/runtime/batch_solver.hpp"

using namespace uhas;

struct uhas_batch : c::Both<BatchSolver> {
  uhas_batch(std::span<const HandProfile> hands, const c::SolveSettings& solve, const BatchOptions& batch)
      : Both(hands, solve.options, batch), driving_vectors(solve.driving_vectors) {}

  int driving_vectors;
};

namespace {

std::vector<HandProfile> profiles_of(const uhas_profile* const* profiles, std::size_t count) {
  if (profiles == nullptr) c::refuse("the array of profiles is NULL", "give at least one profile");
  std::vector<HandProfile> hands;
  for (const uhas_profile* profile : std::span(profiles, count)) hands.push_back(c::profile_of(profile));
  return hands;
}

template <class Real>
int solve(uhas_batch* handle, const Real* values, std::size_t actions_size, const uhas_action_options* options,
          const int* hands, Real* q, std::size_t q_size, int* statuses) noexcept {
  if (handle == nullptr || q == nullptr) return UHAS_WRONG_SIZE;
  BatchSolver<Real>& solver = handle->in<Real>();
  const std::ptrdiff_t rows = c::rows_of(q_size, solver.widest_joint_count());
  if (rows < 0) return UHAS_WRONG_SIZE;
  const c::Actions<Real> actions(values, actions_size, handle->driving_vectors, options, rows);
  if (!actions.fits()) return UHAS_WRONG_SIZE;
  const std::size_t count = rows;
  return static_cast<int>(solver.solve({.count = count,
                                        .values = actions.values(),
                                        .driving_vectors = handle->driving_vectors,
                                        .driving_vectors_phi = actions.angles(),
                                        .normalized = actions.normalized(),
                                        .azimuth_offsets = actions.azimuth_offsets(),
                                        .radial_bounds = actions.radial_bounds(),
                                        .hands = c::array(hands, count)},
                                       std::span(q, q_size), c::statuses_of(statuses, count)));
}

}  // namespace

int uhas_batch_create(const uhas_profile* const* profiles, size_t profile_count, const uhas_solve_options* options,
                      const uhas_batch_options* batch_options, uhas_batch** batch, char* message, size_t message_size) {
  return c::create(batch, {message, message_size}, [&] {
    const BatchOptions settings{.threads = c::read_options(batch_options, UHAS_BATCH_OPTIONS_INIT).threads};
    const std::vector<HandProfile> hands = profiles_of(profiles, profile_count);
    return new uhas_batch(hands, c::solve_settings(options), settings);
  });
}

void uhas_batch_free(uhas_batch* batch) { delete batch; }

size_t uhas_batch_row_size(const uhas_batch* batch) { return batch->in_double.widest_joint_count(); }

int uhas_batch_solve(uhas_batch* batch, const double* actions, size_t actions_size, const uhas_action_options* options,
                     const int* hands, double* q, size_t q_size, int* statuses) {
  return solve(batch, actions, actions_size, options, hands, q, q_size, statuses);
}

int uhas_batch_solve_f(uhas_batch* batch, const float* actions, size_t actions_size, const uhas_action_options* options,
                       const int* hands, float* q, size_t q_size, int* statuses) {
  return solve(batch, actions, actions_size, options, hands, q, q_size, statuses);
}
