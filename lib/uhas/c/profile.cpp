// uhas.h: versions, statuses, the hand profile.
#include "uhas/c/call.hpp"
#include "uhas/profile_io/read_profile.hpp"

using namespace uhas;

static_assert(UHAS_OK == int(Status::ok) && UHAS_NON_FINITE_INPUT == int(Status::non_finite_input) &&
              UHAS_WRONG_SIZE == int(Status::wrong_size) &&
              UHAS_INVALID_DRIVING_VECTORS == int(Status::invalid_driving_vectors) &&
              UHAS_UNKNOWN_HAND == int(Status::unknown_hand) && UHAS_INVALID_PERIOD == int(Status::invalid_period) &&
              UHAS_INVALID_RADIAL_BOUNDS == int(Status::invalid_radial_bounds));
static_assert(UHAS_ERROR_FILE_UNREADABLE == int(ErrorCode::file_unreadable) &&
              UHAS_ERROR_INVALID_PROFILE == int(ErrorCode::invalid_profile) &&
              UHAS_ERROR_UNSUPPORTED_VERSION == int(ErrorCode::unsupported_version) &&
              UHAS_ERROR_LIMIT_EXCEEDED == int(ErrorCode::limit_exceeded) &&
              UHAS_ERROR_INVALID_OPTION == int(ErrorCode::invalid_option));

int uhas_c_api_version(void) { return UHAS_C_API_VERSION; }
const char* uhas_version(void) { return UHAS_VERSION; }
const char* uhas_status_text(int status) { return to_string(static_cast<Status>(status)); }

int uhas_profile_load(const char* path, uhas_profile** profile, char* message, size_t message_size) {
  return c::create(profile, {message, message_size}, [&] {
    if (path == nullptr) c::refuse("the path is NULL", "name a hand profile");
    return new uhas_profile{read_profile(path)};
  });
}

void uhas_profile_free(uhas_profile* profile) { delete profile; }

const char* uhas_profile_hand(const uhas_profile* profile) { return profile->profile.hand.c_str(); }
double uhas_profile_radius(const uhas_profile* profile) { return profile->profile.radius; }
size_t uhas_profile_joint_count(const uhas_profile* profile) { return profile->profile.tree.joints.size(); }

const char* uhas_profile_joint_name(const uhas_profile* profile, size_t joint) {
  const std::vector<Joint>& joints = profile->profile.tree.joints;
  return joint < joints.size() ? joints[joint].name.c_str() : nullptr;
}

int uhas_profile_joint_limits(const uhas_profile* profile, double* lower, double* upper, size_t joint_count) {
  if (profile == nullptr || lower == nullptr || upper == nullptr) return UHAS_WRONG_SIZE;
  const std::vector<Joint>& joints = profile->profile.tree.joints;
  if (joint_count != joints.size()) return UHAS_WRONG_SIZE;
  for (const Joint& joint : joints) *lower++ = joint.lower, *upper++ = joint.upper;
  return UHAS_OK;
}

int uhas_profile_reference_posture(const uhas_profile* profile, double* q, size_t joint_count) {
  if (profile == nullptr || q == nullptr) return UHAS_WRONG_SIZE;
  const std::vector<JointTraits>& traits = profile->profile.joint_traits;
  if (joint_count != traits.size()) return UHAS_WRONG_SIZE;
  for (const JointTraits& joint : traits) *q++ = joint.q_sphere;
  return UHAS_OK;
}
