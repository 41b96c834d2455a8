/* The runtime library for C and for whatever can call C (C99, no other header).
 *
 *   uhas_profile* profile;
 *   uhas_solver* solver;
 *   char message[256];
 *   if (uhas_profile_load("hand.h5", &profile, message, sizeof message) != UHAS_OK) ...
 *   if (uhas_solver_create(profile, NULL, &solver, message, sizeof message) != UHAS_OK) ...
 *   int status = uhas_solver_solve(solver, action, 15, NULL, q, joints, NULL);
 *
 * Conventions
 *   units       metres, radians, seconds, sphere radii, as everywhere
 *   results     functions that can fail return an int: 0 is UHAS_OK
 *   set-up      load and create return a uhas_error and write one line on it into `message`, if that is not NULL:
 *               cut to `message_size` bytes, the ending zero included. They may allocate and read files. On failure the
 *               handle becomes NULL. Profiles are copied: they may be freed as soon as nothing more is created from them
 *   real time   all other calls that return an int return a uhas_status and keep what C++ keeps: no allocation, lock or
 *               clock; on any status but UHAS_OK the output is untouched, unless the call says otherwise
 *   arrays      are the caller's, contiguous, and come with their number of elements. One call serves N hands, row after
 *               row: N follows from the sizes, which must agree, and the arrays of a report have N rows too. NULL stands
 *               for an array that is not wanted, where the call says so, and is UHAS_WRONG_SIZE elsewhere
 *   float       a call that ends in _f is the one above it in single precision
 *   options     structs open with their size: initialise them with their _INIT, so that a program outlives its header.
 *               NULL stands for the defaults. A library that is older than the struct refuses it
 *   threads     a profile serves any number of threads; give each thread its own solver, observer, ...
 *   freeing     NULL is freed without effect
 */
#ifndef UHAS_H
#define UHAS_H

#include <stddef.h>
#include <stdint.h>

#ifdef __GNUC__
#pragma GCC visibility push(default) /* the library's own build hides the rest */
#endif
#ifdef __cplusplus
extern "C" {
#endif

/* Rises when a declaration below changes its meaning; new ones do not raise it. */
#define UHAS_C_API_VERSION 1

int uhas_c_api_version(void);   /* UHAS_C_API_VERSION of the library that runs */
const char* uhas_version(void); /* of the library that runs, "major.minor.patch" */

/* uhas::Status */
typedef enum uhas_status {
  UHAS_OK = 0,
  UHAS_NON_FINITE_INPUT = 1,        /* NaN or infinity in the input */
  UHAS_WRONG_SIZE = 2,              /* an array of the wrong length */
  UHAS_INVALID_DRIVING_VECTORS = 3, /* driving-vector angles not strictly increasing in (0, pi) */
  UHAS_UNKNOWN_HAND = 4,            /* a row for a hand that the solver does not have */
  UHAS_INVALID_PERIOD = 5,          /* a control period that is not a positive finite number */
  UHAS_INVALID_RADIAL_BOUNDS = 6    /* radial bounds that are not -1e6 <= lower <= 0 <= upper <= 1e6 */
} uhas_status;

/* A short English sentence; never NULL. */
const char* uhas_status_text(int status);

/* uhas::ErrorCode, as far as set-up calls here can meet it, and two of their own */
typedef enum uhas_error {
  UHAS_ERROR_FILE_UNREADABLE = 1,
  UHAS_ERROR_INVALID_PROFILE = 7,     /* damaged, alien or inconsistent */
  UHAS_ERROR_UNSUPPORTED_VERSION = 8, /* a format version that this library does not know */
  UHAS_ERROR_INVALID_ACTION = 9,      /* a number of passes or of driving vectors out of its range */
  UHAS_ERROR_LIMIT_EXCEEDED = 10,     /* a file larger than the library reads */
  UHAS_ERROR_INVALID_OPTION = 12,     /* an option out of its range, or NULL where something is needed */
  UHAS_ERROR_OUT_OF_MEMORY = 100,
  UHAS_ERROR_INTERNAL = 101 /* a defect of the library */
} uhas_error;

/* ---- The hand profile: what is known of a hand. Its joint order is that of every array of joint values. */

typedef struct uhas_profile uhas_profile;

int uhas_profile_load(const char* path, uhas_profile** profile, char* message, size_t message_size);
void uhas_profile_free(uhas_profile* profile);

const char* uhas_profile_hand(const uhas_profile* profile);   /* the robot's name; lives as long as the profile */
double uhas_profile_radius(const uhas_profile* profile);      /* of the sphere, m */
size_t uhas_profile_joint_count(const uhas_profile* profile); /* mimic followers included */
const char* uhas_profile_joint_name(const uhas_profile* profile, size_t joint); /* NULL beyond the last one */

/* rad, m for sliding joints; [joint count] each */
int uhas_profile_joint_limits(const uhas_profile* profile, double* lower, double* upper, size_t joint_count);
int uhas_profile_reference_posture(const uhas_profile* profile, double* q, size_t joint_count);

/* ---- Actions and how they are read. [N][5 + 5 V] numbers, V = 1 to 4 driving vectors; see uhas/runtime/action.hpp. */

typedef struct uhas_action_options {
  size_t struct_size;
  int normalized;                    /* values in [-1, 1]: 0 is undeformed, -1 and 1 are the bounds */
  const double* driving_vectors_phi; /* [V] or [5 V] polar angles; NULL = pi j / (V + 1) */
  size_t driving_vectors_size;
  const double* azimuth_offsets; /* [5] rad: a slot's plane stands this much further; NULL = 0 */
  const double* radial_bounds;   /* [2] -1e6 <= lower <= 0 <= upper <= 1e6; NULL = those of the convention */
} uhas_action_options;
#define UHAS_ACTION_OPTIONS_INIT \
  { sizeof(uhas_action_options), 0, NULL, 0, NULL, NULL }

/* ---- Solving: actions to joint angles, within limits for any finite action. */

enum { UHAS_RULE_CORRESPONDENCE = 0, UHAS_RULE_CONTACT = 1 };
enum { UHAS_CLOSING_FADE = 0, UHAS_CLOSING_HARD = 1 };
enum { UHAS_FIELD_FINGER = 0, UHAS_FIELD_FIELD = 1 };
enum { UHAS_CONVENTION_UHAS = 0, UHAS_CONVENTION_SIM = 1 }; /* what actions mean; the second is uhas::kUhasSim's */

typedef struct uhas_solve_options { /* see uhas/runtime/cascade_solver.hpp */
  size_t struct_size;
  int rule;
  int closing;
  int field;
  int passes; /* 1 to 100 */
  int convention;
} uhas_solve_options;
#define UHAS_SOLVE_OPTIONS_INIT                                                                    \
  {                                                                                                \
    sizeof(uhas_solve_options), UHAS_RULE_CORRESPONDENCE, UHAS_CLOSING_FADE, UHAS_FIELD_FINGER, 1, \
        UHAS_CONVENTION_UHAS                                                                       \
  }
#define UHAS_SIM_SOLVE_OPTIONS_INIT /* uhas::kUhasSim: for policies trained with the authors' released code; unverified */ \
  { sizeof(uhas_solve_options), UHAS_RULE_CONTACT, UHAS_CLOSING_HARD, UHAS_FIELD_FINGER, 1, UHAS_CONVENTION_SIM }

typedef struct uhas_solve_report { /* what a solve found out besides the angles; each array may be NULL */
  size_t struct_size;
  double* residual_rms; /* [N] sphere radii; NaN when every point has been dropped */
  uint8_t* at_limit;    /* [N][joint count] 1 where the fitted angle was held at a limit */
  uint8_t* closed;      /* [N][joint count] 1 where the joint closed because no point was left */
} uhas_solve_report;
#define UHAS_SOLVE_REPORT_INIT \
  { sizeof(uhas_solve_report), NULL, NULL, NULL }

typedef struct uhas_solver uhas_solver;

int uhas_solver_create(const uhas_profile* profile, const uhas_solve_options* options, uhas_solver** solver,
                       char* message, size_t message_size);
void uhas_solver_free(uhas_solver* solver);

/* q: [N][joint count]. Of several actions, one that is refused refuses all. report: may be NULL. Action by action; a
 * uhas_batch is many times faster for many. */
int uhas_solver_solve(uhas_solver* solver, const double* actions, size_t actions_size,
                      const uhas_action_options* options, double* q, size_t q_size, const uhas_solve_report* report);
int uhas_solver_solve_f(uhas_solver* solver, const float* actions, size_t actions_size,
                        const uhas_action_options* options, float* q, size_t q_size, const uhas_solve_report* report);

/* ---- Solving at scale: SIMD over hands, threads, mixed sets of hands; see uhas/runtime/batch_solver.hpp. */

typedef struct uhas_batch_options {
  size_t struct_size;
  int threads; /* 1 to 256, the calling one included; with more than one, a call waits for the others */
} uhas_batch_options;
#define UHAS_BATCH_OPTIONS_INIT \
  { sizeof(uhas_batch_options), 1 }

typedef struct uhas_batch uhas_batch;

/* profiles: [profile_count] the hands that rows may be for. */
int uhas_batch_create(const uhas_profile* const* profiles, size_t profile_count, const uhas_solve_options* options,
                      const uhas_batch_options* batch_options, uhas_batch** batch, char* message, size_t message_size);
void uhas_batch_free(uhas_batch* batch);

size_t uhas_batch_row_size(const uhas_batch* batch); /* the joint count of the hand that has most */

/* q: [N][uhas_batch_row_size]: the angles of the row's own hand, what is left of the row untouched. hands: [N] indices into
 * the profiles, or NULL: all rows are for the first. statuses: [N] out, or NULL: what became of each row. A row that is
 * refused leaves its part of q untouched and hinders no other; the result is that of the first one refused. */
int uhas_batch_solve(uhas_batch* batch, const double* actions, size_t actions_size, const uhas_action_options* options,
                     const int* hands, double* q, size_t q_size, int* statuses);
int uhas_batch_solve_f(uhas_batch* batch, const float* actions, size_t actions_size, const uhas_action_options* options,
                       const int* hands, float* q, size_t q_size, int* statuses);

/* ---- The sphere controller: actions to joint targets, period by period; see uhas/runtime/sphere_controller.hpp. */

typedef struct uhas_controller_options {
  size_t struct_size;
  double velocity_scale;           /* > 0: share of the velocity limits that targets may use */
  double range_scale;              /* (0, 1]: share of each joint's range that targets are led to */
  double time_constant;            /* s, >= 0: of first-order smoothing; 0 = none */
  const uhas_solve_options* solve; /* NULL = the defaults */
} uhas_controller_options;
#define UHAS_CONTROLLER_OPTIONS_INIT \
  { sizeof(uhas_controller_options), 1, 1, 0, NULL }

typedef struct uhas_controller uhas_controller;

int uhas_controller_create(const uhas_profile* profile, const uhas_controller_options* options,
                           uhas_controller** controller, char* message, size_t message_size);
void uhas_controller_free(uhas_controller* controller);

/* Begins at postures q, usually measured ones. q and targets: [N][joint count]; they may be one array. */
int uhas_controller_reset(uhas_controller* controller, const double* q, size_t q_size, double* targets,
                          size_t targets_size);
int uhas_controller_reset_f(uhas_controller* controller, const float* q, size_t q_size, float* targets,
                            size_t targets_size);

/* One period of dt seconds moves the targets [N][joint count], which are all the state there is. The targets of a hand whose
 * action is refused are held, the other hands move; the result is that of the first hand refused. */
int uhas_controller_update(uhas_controller* controller, const double* actions, size_t actions_size,
                           const uhas_action_options* options, double dt, double* targets, size_t targets_size);
int uhas_controller_update_f(uhas_controller* controller, const float* actions, size_t actions_size,
                             const uhas_action_options* options, float dt, float* targets, size_t targets_size);

/* The same toward solutions [N][joint count] that are there already, those of a uhas_batch. */
int uhas_controller_approach(uhas_controller* controller, const double* solutions, size_t solutions_size, double dt,
                             double* targets, size_t targets_size);
int uhas_controller_approach_f(uhas_controller* controller, const float* solutions, size_t solutions_size, float dt,
                               float* targets, size_t targets_size);

/* ---- Observing: joint angles and velocities to the homogeneous observation; see uhas/runtime/observation.hpp. */

typedef struct uhas_observation_options {
  size_t struct_size;
  unsigned points;    /* bit i: point i of a finger's seven, root to tip */
  int pad_directions; /* append each slot's pad direction */
} uhas_observation_options;
#define UHAS_OBSERVATION_OPTIONS_INIT \
  { sizeof(uhas_observation_options), 1u << 3 | 1u << 6, 0 }

typedef struct uhas_observer uhas_observer;

int uhas_observer_create(const uhas_profile* profile, const uhas_observation_options* options, uhas_observer** observer,
                         char* message, size_t message_size);
void uhas_observer_free(uhas_observer* observer);

size_t uhas_observer_size(const uhas_observer* observer); /* numbers of one hand's observation */

/* q, qd: [N][joint count] rad, rad/s (m, m/s); observations: [N][uhas_observer_size]. A bad number refuses all. */
int uhas_observer_observe(uhas_observer* observer, const double* q, size_t q_size, const double* qd, size_t qd_size,
                          double* observations, size_t observations_size);
int uhas_observer_observe_f(uhas_observer* observer, const float* q, size_t q_size, const float* qd, size_t qd_size,
                            float* observations, size_t observations_size);

/* ---- Encoding: joint angles to the action whose solve comes nearest; see uhas/runtime/encoder.hpp. */

typedef struct uhas_encode_report { /* how far that solve stays away, over the independent joints */
  double residual_max;              /* rad; sphere radii for a sliding joint */
  double residual_rms;
} uhas_encode_report;

typedef struct uhas_encoder uhas_encoder;

int uhas_encoder_create(const uhas_profile* profile, const uhas_solve_options* options, int driving_vectors,
                        uhas_encoder** encoder, char* message, size_t message_size);
void uhas_encoder_free(uhas_encoder* encoder);

/* q: [N][joint count]; actions: [N][5 + 5 V], not normalised; reports: [N] or NULL. A bad number refuses all. */
int uhas_encoder_encode(uhas_encoder* encoder, const double* q, size_t q_size, double* actions, size_t actions_size,
                        uhas_encode_report* reports);
int uhas_encoder_encode_f(uhas_encoder* encoder, const float* q, size_t q_size, float* actions, size_t actions_size,
                          uhas_encode_report* reports);

/* ---- Retargeting: the postures of one hand on another; see uhas/runtime/retarget.hpp. */

typedef struct uhas_retargeter uhas_retargeter;

int uhas_retargeter_create(const uhas_profile* from, const uhas_profile* to, const uhas_solve_options* options,
                           int driving_vectors, uhas_retargeter** retargeter, char* message, size_t message_size);
void uhas_retargeter_free(uhas_retargeter* retargeter);

/* q_from: [N][joints of from]; q_to: [N][joints of to]; reports: [N] or NULL: what `from` lost. A bad number refuses all. */
int uhas_retargeter_retarget(uhas_retargeter* retargeter, const double* q_from, size_t q_from_size, double* q_to,
                             size_t q_to_size, uhas_encode_report* reports);
int uhas_retargeter_retarget_f(uhas_retargeter* retargeter, const float* q_from, size_t q_from_size, float* q_to,
                               size_t q_to_size, uhas_encode_report* reports);

#ifdef __cplusplus
}
#endif
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
