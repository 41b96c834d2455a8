// The runtime as a WebAssembly module, one instance a hand; page/hand_solver.js is its other half. It imports nothing.
// The caller asks for the address of a buffer, writes, calls, and reads from the address of a result; memory may move
// at each call. Set-up that fails stops the instance (a trap) and leaves its sentence in `message`.
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "uhas/base/errors.hpp"
#include "uhas/base/homogeneous_matrix.hpp"
#include "uhas/kinematics/forward_kinematics.hpp"
#include "uhas/profile_io/flat_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/deformation_field.hpp"

#define UHAS_EXPORT(name) __attribute__((export_name(#name)))

using namespace uhas;

namespace {

struct Hand {
  HandProfile profile;
  CascadeSolver<double> solver;
  DeformationField field;
  std::vector<double> q;                       // [joint] solved
  std::vector<std::uint8_t> at_limit, closed;  // [joint]
  SolveReport report;
  std::vector<double> q_shown;     // [joint] to be posed
  std::vector<float> T_palm_link;  // [link] matrices, column-major

  explicit Hand(HandProfile p)
      : profile(std::move(p)),
        solver(profile),
        field(profile),
        q(profile.tree.joints.size()),
        at_limit(q.size()),
        closed(q.size()),
        report{.residual_rms = 0, .at_limit = at_limit, .closed = closed},
        q_shown(q.size()),
        T_palm_link(16 * profile.links.size()) {}
};

std::string sentence;
std::vector<std::byte> image_bytes;
std::vector<double> action_values, action_phi;
std::vector<Spherical<double>> sphere_points;
std::optional<Hand> hand;

Action<double> current_action() { return {.values = action_values, .driving_vectors_phi = action_phi}; }

void write_matrix(const RigidTransformd& T, float* column_major) {
  const std::array<float, 16> row_major = homogeneous_matrix<float>(T);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) column_major[4 * j + i] = row_major[4 * i + j];
}

}  // namespace

// What is thrown is an Error (base/errors.hpp); nothing is caught here.
extern "C" void* __cxa_allocate_exception(std::size_t size) { return std::malloc(size); }
extern "C" void __cxa_throw(void* error, void*, void (*)(void*)) {
  sentence = static_cast<const Error*>(error)->what();
  __builtin_trap();
}

UHAS_EXPORT(message) const char* message() { return sentence.c_str(); }  ///< empty, or why the instance stopped
UHAS_EXPORT(status_text) const char* status_text(int status) { return to_string(static_cast<Status>(status)); }

UHAS_EXPORT(image) std::byte* image(std::size_t size) {
  image_bytes.resize(size);
  return image_bytes.data();
}

/// The hand of the flat profile in `image`.
UHAS_EXPORT(open_hand) void open_hand() { hand.emplace(unflatten_profile(image_bytes)); }

UHAS_EXPORT(joint_count) std::size_t joint_count() { return hand->q.size(); }
UHAS_EXPORT(link_count) std::size_t link_count() { return hand->profile.links.size(); }

/// Numbers as in SolveOptions.
UHAS_EXPORT(set_options) void set_options(int rule, int closing, int field, int passes) {
  hand->solver = CascadeSolver<double>(hand->profile, {.rule = static_cast<CascadeRule>(rule),
                                                       .closing = static_cast<CascadeClosing>(closing),
                                                       .field = static_cast<FieldReading>(field),
                                                       .passes = passes});
}

/// The action of the next call, and its driving angles (none: the default ones).
UHAS_EXPORT(action) double* action(std::size_t size) {
  action_values.resize(size);
  return action_values.data();
}
UHAS_EXPORT(driving_vectors_phi) double* driving_vectors_phi(std::size_t size) {
  action_phi.resize(size);
  return action_phi.data();
}

/// A Status; on ok the results below are those of the action.
UHAS_EXPORT(solve) int solve() { return static_cast<int>(hand->solver.solve(current_action(), hand->q, hand->report)); }
UHAS_EXPORT(q) const double* q() { return hand->q.data(); }
UHAS_EXPORT(residual_rms) double residual_rms() { return hand->report.residual_rms; }
UHAS_EXPORT(at_limit) const std::uint8_t* at_limit() { return hand->at_limit.data(); }
UHAS_EXPORT(closed) const std::uint8_t* closed() { return hand->closed.data(); }

/// Points to be moved, and the Status of moving them by the action: azimuth, polar angle and radius each.
UHAS_EXPORT(points) double* points(std::size_t count) {
  static_assert(sizeof(Spherical<double>) == 3 * sizeof(double));
  sphere_points.resize(count);
  return &sphere_points.data()->azimuth;
}
UHAS_EXPORT(deform) int deform() { return static_cast<int>(hand->field.deform(current_action(), sphere_points)); }

/// Joint values to be posed, and the transforms of the links in the palm's frame at these.
UHAS_EXPORT(q_shown) double* q_shown() { return hand->q_shown.data(); }
UHAS_EXPORT(pose) const float* pose() {
  float* const matrices = hand->T_palm_link.data();
  const std::vector<RigidTransformd> poses = link_poses(hand->profile.tree, hand->profile.links, hand->q_shown);
  for (std::size_t i = 0; i < poses.size(); ++i) write_matrix(poses[i], matrices + 16 * i);
  return matrices;
}
