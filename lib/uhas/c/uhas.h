/* uhas for C and for whatever can call C: C99, no other header, and nothing to read but this one.
 *
 * A hand profile (one file, made by uhas-build-profile) is what is known of a hand. With it, an action becomes joint
 * angles, joint angles become an observation or an action, and a posture of one hand becomes that of another:
 *
 *   uhas_profile* profile;
 *   uhas_solver* solver;
 *   char message[256];
 *   double action[15] = {0}, q[16];
 *   if (uhas_profile_load("hand.h5", &profile, message, sizeof message) != UHAS_OK) ...
 *   if (uhas_solver_create(profile, NULL, &solver, message, sizeof message) != UHAS_OK) ...
 *   if (uhas_solver_solve(solver, action, 15, NULL, q, 16, NULL, NULL) != UHAS_OK) ...
 *   uhas_solver_free(solver);
 *   uhas_profile_free(profile);
 *
 * WHAT HOLDS FOR ALL FUNCTIONS
 *
 * Units. Metres, radians, seconds; for what is measured on the sphere, sphere radii. Joint values are rad and rad/s,
 * of sliding joints m and m/s. They stand in the order of uhas_profile_joint_name, mimic followers included: [joint
 * count] numbers.
 *
 * Many. Each call serves N hands: its arrays are N rows, row after row without gaps, and their sizes, which count
 * numbers and not rows or bytes, say what N is. Sizes that disagree are UHAS_WRONG_SIZE; nothing is guessed. N = 0 is
 * allowed, but arrays are not NULL.
 *
 * Arrays are the caller's, in and out, aligned as their type is. The library keeps no pointer to one after a call.
 * Arrays of one call must not overlap, unless it says so. NULL stands for an array that is not wanted, where a call
 * says so; elsewhere it is UHAS_WRONG_SIZE.
 *
 * Set-up: functions that load or create return a uhas_error. They allocate, and may read files. On failure *handle
 * becomes NULL, and `message`, if not NULL, gets one line of UTF-8 that says what is wrong and what to do, cut to
 * `message_size` bytes, the ending zero included; on success it is left alone.
 *
 * Real time: all other functions that return an int return a uhas_status. They allocate nothing, take no lock, read
 * no clock and do not depend on locale or environment; a uhas_batch of several threads alone waits, for these.
 *
 * Refusal goes row by row. A row that is refused (a NaN, say) leaves its part of every output untouched and hinders
 * no other row. `statuses`, [N] or NULL, gets what became of each row, and the call returns that of the first row
 * refused, UHAS_OK if there is none. What all rows share, as a period, refuses each of them. UHAS_WRONG_SIZE alone
 * refuses the call as a whole: then nothing is written, the statuses neither.
 *
 * Precision. A call that ends in _f is the one above it in single precision. A handle serves both.
 *
 * Options are structs that open with their size: initialise them by their _INIT, so that a program outlives its
 * header. NULL stands for the defaults, which _INIT states. A library that is older than the struct refuses it. They
 * are copied.
 *
 * Ownership. A handle that a function creates is the caller's to free, once; freeing NULL does nothing. Handles do
 * not refer to each other: a profile may be freed as soon as nothing more is created from it. Handles passed to
 * functions that return no int must not be NULL.
 *
 * Threads. A profile serves any number of threads at once. Any other handle holds scratch memory: it may pass from
 * thread to thread, but is used by one at a time; give each thread its own. Handles are independent of each other.
 *
 * Fork. After fork() the child has a copy of every handle, and all work there as in the parent, with one exception: a
 * uhas_batch of several threads, whose threads exist in the parent only. In the child, neither use it, for a call would
 * wait for ever, nor free it, for that would crash: create another. Do not fork while a thread is in a set-up function.
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

/* UHAS_C_API_VERSION of the library that runs: a program may compare it with that of its header. */
int uhas_c_api_version(void);

/* Version of the library that runs, "major.minor.patch"; lives for ever. */
const char* uhas_version(void);

/* What became of a real-time call, or of a row of one. The numbers stay. */
typedef enum uhas_status {
  UHAS_OK = 0,
  UHAS_NON_FINITE_INPUT = 1,        /* NaN or infinity in the row's input */
  UHAS_WRONG_SIZE = 2,              /* sizes that disagree, NULL, options of a newer header: nothing is written */
  UHAS_INVALID_DRIVING_VECTORS = 3, /* driving-vector angles not strictly increasing in (0, pi) */
  UHAS_UNKNOWN_HAND = 4,            /* a row for a hand that the batch does not have */
  UHAS_INVALID_PERIOD = 5,          /* a control period that is not a positive finite number */
  UHAS_INVALID_RADIAL_BOUNDS = 6    /* radial bounds that are not -1e6 <= lower <= 0 <= upper <= 1e6 */
} uhas_status;

/* A short English sentence; never NULL, whatever the number; lives for ever. */
const char* uhas_status_text(int status);

/* Why a set-up function failed. The numbers stay. UHAS_OK is 0 here too. */
typedef enum uhas_error {
  UHAS_ERROR_FILE_UNREADABLE = 1,     /* missing, not a regular file, no permission */
  UHAS_ERROR_INVALID_PROFILE = 7,     /* damaged, no hand profile, or inconsistent */
  UHAS_ERROR_UNSUPPORTED_VERSION = 8, /* a format version that this library does not know */
  UHAS_ERROR_LIMIT_EXCEEDED = 10,     /* a file larger than the library reads */
  UHAS_ERROR_INVALID_OPTION = 12,     /* an option out of its range, which the message names, or an unwanted NULL */
  UHAS_ERROR_OUT_OF_MEMORY = 100,
  UHAS_ERROR_INTERNAL = 101 /* the system refused something, as a thread; or a defect of the library */
} uhas_error;

/* ==== The hand profile ========================================================================================== */

typedef struct uhas_profile uhas_profile;

/* Reads a profile, whose length, hash and content are checked.
 *
 * path      of a file of up to 256 MiB, in the file system's encoding
 * profile   out
 * Several threads may load at once; they take turns. The check finds damage, not malice: load what you trust.
 */
int uhas_profile_load(const char* path, uhas_profile** profile, char* message, size_t message_size);
void uhas_profile_free(uhas_profile* profile);

/* The robot's name in its URDF, UTF-8; lives as long as the profile. */
const char* uhas_profile_hand(const uhas_profile* profile);

/* Radius of the sphere, m. */
double uhas_profile_radius(const uhas_profile* profile);

/* Number of joints, mimic followers included: of numbers in a row of joint values. */
size_t uhas_profile_joint_count(const uhas_profile* profile);

/* Name of joint 0 .. joint count - 1 in the URDF, UTF-8; lives as long as the profile. NULL beyond the last one. */
const char* uhas_profile_joint_name(const uhas_profile* profile, size_t joint);

/* lower, upper   [joint count] out: limits in rad, of sliding joints m */
int uhas_profile_joint_limits(const uhas_profile* profile, double* lower, double* upper, size_t joint_count);

/* The posture that wraps the undeformed sphere: what an action of zeros solves to, and a good start of an episode.
 *
 * q   [joint count] out: rad, m
 */
int uhas_profile_reference_posture(const uhas_profile* profile, double* q, size_t joint_count);

/* ==== Actions ======================================================================================================
 *
 * An action deforms the sphere, alike for every hand. It is a row of 5 + 5 V numbers, V driving vectors a finger (2
 * unless `driving_vectors` of the solve options says otherwise: 15 numbers), for the five slots pinky, ring, middle,
 * index, thumb:
 *
 *   [0 .. 4]        d_theta of each slot: the finger's plane turns about the palm's normal by so much, rad. Positive is
 *                   from the thumb's side to the pinky's, on right and left hands. Clamped to what the finger can do.
 *   [5 + V s + j]   d_r of slot s at its driving vector j = 0 .. V - 1, palm to fingertip: the sphere bulges by so
 *                   much, sphere radii. Negative draws it in, and the finger closes. Clamped to [-2, 2].
 *
 * Zeros leave the sphere as it is. A finger of a hand with fewer than five owns several slots and takes their mean.
 * Any finite number is allowed.
 */

/* How the numbers of a call's actions are read, the same for all its rows.
 *
 * normalized             not 0: numbers are in [-1, 1]; 0 stays 0, and -1 and 1 become the bounds
 * driving_vectors_phi    where the driving vectors stand: polar angles, rad, 0 at the palm, near pi / 2 at the
 *                        fingertips, strictly increasing in (0, pi); [V] for all slots, or [5 V] slot by slot.
 *                        NULL: pi j / (V + 1), j = 1 .. V
 * driving_vectors_size   V or 5 V; 0 with NULL
 * azimuth_offsets        [5] rad: a slot's plane stands so much further, and its finger turns along. NULL: 0
 * radial_bounds          [2] bounds of d_r: -1e6 <= lower <= 0 <= upper <= 1e6. NULL: -2, 2
 */
typedef struct uhas_action_options {
  size_t struct_size;
  int normalized;
  const double* driving_vectors_phi;
  size_t driving_vectors_size;
  const double* azimuth_offsets;
  const double* radial_bounds;
} uhas_action_options;
/* clang-format off */
#define UHAS_ACTION_OPTIONS_INIT { sizeof(uhas_action_options), 0, NULL, 0, NULL, NULL }
/* clang-format on */

/* ==== Solving: actions to joint angles ========================================================================== */

/* How a joint angle follows from the deformed sphere.
 *
 * CORRESPONDENCE   least squares over points of the hand's surface: use this when nothing speaks against it
 * CONTACT          a joint turns until the next one meets the deformed sphere: use this for policies trained so
 */
enum { UHAS_RULE_CORRESPONDENCE = 0, UHAS_RULE_CONTACT = 1 };

/* What a joint does as the sphere vanishes under its finger.
 *
 * FADE   closes gradually as the radius falls from 0.5 to 0: use this for motion without jumps
 * HARD   closes at once, as in the paper: use this for policies trained so, and to compare with the paper
 */
enum { UHAS_CLOSING_FADE = 0, UHAS_CLOSING_HARD = 1 };

/* Which deformation a point of the surface takes.
 *
 * FINGER   that of its own finger: use this when each finger is to do what its numbers say, and nothing else
 * FIELD    that between the fingers' planes, at its own azimuth, as in the paper: use this to compare with the paper;
 *          neighbours pull at each other near the palm
 */
enum { UHAS_FIELD_FINGER = 0, UHAS_FIELD_FIELD = 1 };

/* What the numbers of an action mean.
 *
 * UHAS   displacements, as above: use this for all that is new
 * SIM    what they mean in the authors' released simulation code, by its description, unverified: d_r is a radius (1 =
 *        undeformed), the first one holds from the palm on, azimuth has the other sign. Use this for policies trained
 *        with that code, by way of UHAS_SIM_SOLVE_OPTIONS_INIT, with a profile built with --radius-scale 0.8
 */
enum { UHAS_CONVENTION_UHAS = 0, UHAS_CONVENTION_SIM = 1 };

/* How actions are solved.
 *
 * rule, closing, field, convention   one of the values above
 * passes                             1 to 100: sweeps over each finger. One is smooth and fast; more come nearer to the
 *                                    least squares
 * driving_vectors                    V, 1 to 4: actions are [N][5 + 5 V]
 */
typedef struct uhas_solve_options {
  size_t struct_size;
  int rule;
  int closing;
  int field;
  int passes;
  int convention;
  int driving_vectors;
} uhas_solve_options;
/* clang-format off */
#define UHAS_SOLVE_OPTIONS_INIT \
  { sizeof(uhas_solve_options), UHAS_RULE_CORRESPONDENCE, UHAS_CLOSING_FADE, UHAS_FIELD_FINGER, 1, \
    UHAS_CONVENTION_UHAS, 2 }
/* for policies trained with the authors' code: the convention of that name, and the rule and closing that go with it */
#define UHAS_SIM_SOLVE_OPTIONS_INIT \
  { sizeof(uhas_solve_options), UHAS_RULE_CONTACT, UHAS_CLOSING_HARD, UHAS_FIELD_FINGER, 1, \
    UHAS_CONVENTION_SIM, 2 }
/* clang-format on */

/* What a solve found out besides the angles: arrays that it writes, each NULL if not wanted. A row that is refused
 * leaves its part of them untouched. To ask for any of them takes several times as long as the solve.
 *
 * residual_rms   [N] how far the surface stays from where it should be, sphere radii; NaN when all of it has vanished
 * at_limit       [N][joint count] 1 where a joint would go further if it had no limit, else 0
 * closed         [N][joint count] 1 where a joint closed because the sphere has vanished, else 0
 * clamped        [N] 1 where a number of the action was beyond its bounds, else 0
 */
typedef struct uhas_solve_report {
  size_t struct_size;
  double* residual_rms;
  uint8_t* at_limit;
  uint8_t* closed;
  uint8_t* clamped;
} uhas_solve_report;
/* clang-format off */
#define UHAS_SOLVE_REPORT_INIT { sizeof(uhas_solve_report), NULL, NULL, NULL, NULL }
/* clang-format on */

typedef struct uhas_solver uhas_solver;

int uhas_solver_create(const uhas_profile* profile, const uhas_solve_options* options, uhas_solver** solver,
                       char* message, size_t message_size);
void uhas_solver_free(uhas_solver* solver);

/* Bounds of an action's numbers, to which those beyond are clamped; of normalised ones they are -1 and 1. Both bounds of
 * a number that no finger reads are 0: d_theta of a finger that cannot move sideways, and all of a slot without finger.
 *
 * lower, upper   [5 + 5 V] out: rad, sphere radii
 */
int uhas_solver_action_bounds(const uhas_solver* solver, double* lower, double* upper, size_t size);

/* Joint angles of actions, within limits for any finite action, one after the other: a uhas_batch is many times
 * faster for many.
 *
 * actions    [N][5 + 5 V]
 * options    how the actions are read, or NULL
 * q          [N][joint count] out: rad, m
 * report     arrays to fill, or NULL
 * statuses   [N] out, or NULL: UHAS_NON_FINITE_INPUT, UHAS_INVALID_DRIVING_VECTORS, UHAS_INVALID_RADIAL_BOUNDS or
 *            UHAS_OK
 */
int uhas_solver_solve(uhas_solver* solver, const double* actions, size_t actions_size,
                      const uhas_action_options* options, double* q, size_t q_size, const uhas_solve_report* report,
                      int* statuses);
int uhas_solver_solve_f(uhas_solver* solver, const float* actions, size_t actions_size,
                        const uhas_action_options* options, float* q, size_t q_size, const uhas_solve_report* report,
                        int* statuses);

/* ==== Solving at scale ========================================================================================== */

/* threads   1 to 256, the calling one included; with more than one, a call wakes the others and waits for them */
typedef struct uhas_batch_options {
  size_t struct_size;
  int threads;
} uhas_batch_options;
/* clang-format off */
#define UHAS_BATCH_OPTIONS_INIT { sizeof(uhas_batch_options), 1 }
/* clang-format on */

typedef struct uhas_batch uhas_batch;

/* Solves for one hand or a mixed set, several hands at a time by wide instructions of the processor, on several
 * threads.
 *
 * profiles   [profile_count], 1 or more: the hands that rows may be for
 * Starts the threads, which inherit the signal mask. The environment variable UHAS_INSTRUCTION_SET, `scalar` or
 * `baseline`, keeps it from the widest instructions. The rule contact and the field reading field have no wide code:
 * threads still help.
 */
int uhas_batch_create(const uhas_profile* const* profiles, size_t profile_count, const uhas_solve_options* options,
                      const uhas_batch_options* batch_options, uhas_batch** batch, char* message, size_t message_size);
void uhas_batch_free(uhas_batch* batch);

/* Numbers in a row of q: the joint count of the hand that has most. */
size_t uhas_batch_row_size(const uhas_batch* batch);

/* Joint angles of actions. A row's result depends neither on the other rows nor on the number of threads, bit for
 * bit; it is that of a uhas_solver to within 1e-10 rad, in single precision 1e-4 rad, except where a target passes
 * behind a joint.
 *
 * actions    [N][5 + 5 V]
 * options    how the actions are read, or NULL
 * hands      [N] indices into the profiles, or NULL: all rows are for the first
 * q          [N][uhas_batch_row_size] out: rad, m, in the joint order of the row's own hand; what is left of a row is
 *            untouched
 * statuses   [N] out, or NULL: those of uhas_solver_solve, or UHAS_UNKNOWN_HAND
 */
int uhas_batch_solve(uhas_batch* batch, const double* actions, size_t actions_size, const uhas_action_options* options,
                     const int* hands, double* q, size_t q_size, int* statuses);
int uhas_batch_solve_f(uhas_batch* batch, const float* actions, size_t actions_size, const uhas_action_options* options,
                       const int* hands, float* q, size_t q_size, int* statuses);

/* ==== The sphere controller: actions to joint targets, period by period ========================================= */

/* velocity_scale   > 0: share of the URDF's velocity limits that targets may use. A joint that states no limit is
 *                  bounded by its range and by the smoothing alone
 * range_scale      in (0, 1]: share of each joint's range, about its middle, that targets are led to
 * time_constant    s, >= 0: of first-order smoothing; 0 = none
 * solve            how actions are solved; NULL: the defaults
 */
typedef struct uhas_controller_options {
  size_t struct_size;
  double velocity_scale;
  double range_scale;
  double time_constant;
  const uhas_solve_options* solve;
} uhas_controller_options;
/* clang-format off */
#define UHAS_CONTROLLER_OPTIONS_INIT { sizeof(uhas_controller_options), 1, 1, 0, NULL }
/* clang-format on */

typedef struct uhas_controller uhas_controller;

/* Targets for the position controllers of the joints. The targets are all the state there is, and the caller's: one
 * controller serves any number of hands of its kind. In a period of dt seconds each independent joint's
 * target goes 1 - exp(-dt / time_constant) of its way to the goal, at most at velocity_scale * velocity limit. The goal
 * is the solution, held in the middle range_scale of the joint's range. Mimic followers go along; a group of them is as
 * slow as its slowest member.
 */
int uhas_controller_create(const uhas_profile* profile, const uhas_controller_options* options,
                           uhas_controller** controller, char* message, size_t message_size);
void uhas_controller_free(uhas_controller* controller);

/* Begins at postures, usually measured ones: held within limits, followers where their masters put them.
 *
 * q          [N][joint count] rad, m; elements of followers are not read
 * targets    [N][joint count] out; may be the array q
 * statuses   [N] out, or NULL: UHAS_NON_FINITE_INPUT or UHAS_OK
 */
int uhas_controller_reset(uhas_controller* controller, const double* q, size_t q_size, double* targets,
                          size_t targets_size, int* statuses);
int uhas_controller_reset_f(uhas_controller* controller, const float* q, size_t q_size, float* targets,
                            size_t targets_size, int* statuses);

/* One period toward the solutions of actions. The targets of a hand whose action is refused are held.
 *
 * actions    [N][5 + 5 V], V as the solve options say
 * options    how the actions are read, or NULL
 * dt         s since the last period, > 0
 * targets    [N][joint count] in and out: those of the last period, then the next; elements of followers are not read
 * statuses   [N] out, or NULL: those of uhas_solver_solve, or UHAS_INVALID_PERIOD
 */
int uhas_controller_update(uhas_controller* controller, const double* actions, size_t actions_size,
                           const uhas_action_options* options, double dt, double* targets, size_t targets_size,
                           int* statuses);
int uhas_controller_update_f(uhas_controller* controller, const float* actions, size_t actions_size,
                             const uhas_action_options* options, float dt, float* targets, size_t targets_size,
                             int* statuses);

/* The same toward solutions that are there already: those of a uhas_batch, the way for many hands.
 *
 * solutions  [N][joint count] rad, m; elements of followers are not read
 */
int uhas_controller_approach(uhas_controller* controller, const double* solutions, size_t solutions_size, double dt,
                             double* targets, size_t targets_size, int* statuses);
int uhas_controller_approach_f(uhas_controller* controller, const float* solutions, size_t solutions_size, float dt,
                               float* targets, size_t targets_size, int* statuses);

/* ==== Observing: joint angles and velocities to numbers that mean the same on every hand ======================== */

/* points           bit i: point i of the seven that stand at equal distances from a finger's root, 0, to its tip, 6
 * pad_directions   not 0: the direction of each fingertip's pad too
 */
typedef struct uhas_observation_options {
  size_t struct_size;
  unsigned points;
  int pad_directions;
} uhas_observation_options;
/* clang-format off */
#define UHAS_OBSERVATION_OPTIONS_INIT { sizeof(uhas_observation_options), 1u << 3 | 1u << 6, 0 }
/* clang-format on */

typedef struct uhas_observer uhas_observer;

int uhas_observer_create(const uhas_profile* profile, const uhas_observation_options* options, uhas_observer** observer,
                         char* message, size_t message_size);
void uhas_observer_free(uhas_observer* observer);

/* Numbers in one hand's observation: 5 slots * points * 9, 90 by default, and 15 more with pad directions. */
size_t uhas_observer_size(const uhas_observer* observer);

/* One row is, for the slots pinky, ring, middle, index, thumb and in each for its points, root to tip, nine numbers:
 * position (sphere radii), linear velocity (radii/s), angular velocity (rad/s), x y z each. With pad directions
 * follow, for the five slots, unit vectors out of the fingertips' pads, x y z. All are relative to the palm and in
 * the frame of the sphere: origin its centre, z the palm's outward normal, x along the open middle finger. A left
 * hand reports its mirror image: (x, -y, z), angular velocities (-x, y, -z). A finger that owns several slots stands
 * in each.
 *
 * q, qd          [N][joint count] rad and rad/s, m and m/s, beyond limits too; elements of followers are not read
 * observations   [N][uhas_observer_size] out
 * statuses       [N] out, or NULL: UHAS_NON_FINITE_INPUT or UHAS_OK
 * A row's result does not depend on the other rows, bit for bit.
 */
int uhas_observer_observe(uhas_observer* observer, const double* q, size_t q_size, const double* qd, size_t qd_size,
                          double* observations, size_t observations_size, int* statuses);
int uhas_observer_observe_f(uhas_observer* observer, const float* q, size_t q_size, const float* qd, size_t qd_size,
                            float* observations, size_t observations_size, int* statuses);

/* ==== Encoding: joint angles to actions ========================================================================= */

/* How far the solve of the action found stays from the posture that was asked for, over the independent joints. */
typedef struct uhas_encode_report {
  double residual_max;       /* the worst joint: rad; of sliding joints sphere radii */
  double residual_rms;       /* root of the mean square, the same units */
  double finger_residual[5]; /* [finger] in the profile's order, its worst joint, the same units */
  int finger_joint[5];       /* [finger] which joint that is; -1 of a finger that the hand does not have */
} uhas_encode_report;

typedef struct uhas_encoder uhas_encoder;

/* options   those of the solver whose inverse this is, or NULL. The convention must be UHAS_CONVENTION_UHAS */
int uhas_encoder_create(const uhas_profile* profile, const uhas_solve_options* options, uhas_encoder** encoder,
                        char* message, size_t message_size);
void uhas_encoder_free(uhas_encoder* encoder);

/* The actions whose solves come nearest to postures, one after the other. A finger has more joints than an action has
 * numbers for it, so most postures are met only nearly: read the reports. What a solve gave comes back within 0.01 rad
 * in 99 of 100 cases; by the reading field and the closing hard less often, in 84 or more.
 *
 * q          [N][joint count] rad, m; beyond a limit it is encoded as the limit; elements of followers are not read
 * actions    [N][5 + 5 V] out: rad and sphere radii, within bounds, not normalised, at the default driving-vector
 *            angles
 * reports    [N] out, or NULL
 * statuses   [N] out, or NULL: UHAS_NON_FINITE_INPUT or UHAS_OK
 */
int uhas_encoder_encode(uhas_encoder* encoder, const double* q, size_t q_size, double* actions, size_t actions_size,
                        uhas_encode_report* reports, int* statuses);
int uhas_encoder_encode_f(uhas_encoder* encoder, const float* q, size_t q_size, float* actions, size_t actions_size,
                          uhas_encode_report* reports, int* statuses);

/* ==== Retargeting: the postures of one hand on another ========================================================== */

typedef struct uhas_retargeter uhas_retargeter;

/* options   of both solvers, or NULL; more driving vectors follow `from` more closely. The convention must be
 *           UHAS_CONVENTION_UHAS */
int uhas_retargeter_create(const uhas_profile* from, const uhas_profile* to, const uhas_solve_options* options,
                           uhas_retargeter** retargeter, char* message, size_t message_size);
void uhas_retargeter_free(uhas_retargeter* retargeter);

/* Encodes postures of the hand `from` and solves the actions on the hand `to`.
 *
 * q_from     [N][joint count of from] rad, m, as uhas_encoder_encode takes them
 * q_to       [N][joint count of to] out: rad, m, within limits
 * reports    [N] out, or NULL: what `from` lost on the way to the actions
 * statuses   [N] out, or NULL: UHAS_NON_FINITE_INPUT or UHAS_OK
 */
int uhas_retargeter_retarget(uhas_retargeter* retargeter, const double* q_from, size_t q_from_size, double* q_to,
                             size_t q_to_size, uhas_encode_report* reports, int* statuses);
int uhas_retargeter_retarget_f(uhas_retargeter* retargeter, const float* q_from, size_t q_from_size, float* q_to,
                               size_t q_to_size, uhas_encode_report* reports, int* statuses);

#ifdef __cplusplus
}
#endif
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
