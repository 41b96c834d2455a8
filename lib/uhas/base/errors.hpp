// Errors of the whole project: typed exceptions for set-up code, plain status numbers for the real-time path.
#pragma once

#include <stdexcept>
#include <string>

#include "uhas/base/export.hpp"

namespace uhas {

/// Why set-up code (loading, building, reading, writing) refused its input. The numbers are part of the API.
enum class ErrorCode : int {
  file_unreadable = 1,      ///< missing, not a regular file, no permission
  syntax = 2,               ///< not XML, not JSON, not a mesh of the named format
  invalid_model = 3,        ///< a URDF that is no usable kinematic tree
  invalid_mesh = 4,         ///< an empty or corrupt mesh
  invalid_hand = 5,         ///< a model in which no hand can be found
  invalid_config = 6,       ///< a hand config with an unknown key or an unusable value
  invalid_profile = 7,      ///< damaged, alien or inconsistent hand profile
  unsupported_version = 8,  ///< a format version this reader does not know
  invalid_action = 9,       ///< an action, from a file or from a caller, of the wrong form, length or value
  limit_exceeded = 10,      ///< larger than a stated bound
  write_failed = 11,        ///< disk full, read-only folder, failed rename
  invalid_option = 12,  ///< an argument of set-up code out of its range: passes, threads, a scale; the text names it
};

/// The one exception type of the library. `what()` reads `file: problem; remedy`, ready to follow `tool: error: `.
class UHAS_API Error : public std::runtime_error {
 public:
  /// @param file     file (and `:line`) the problem is in; may be empty
  /// @param problem  what is wrong, no trailing full stop
  /// @param remedy   what the user can do; may be empty
  Error(ErrorCode code, const std::string& file, const std::string& problem, const std::string& remedy);
  ~Error() override;  // in one library alone: what another throws is of the type that a program catches

  ErrorCode code() const noexcept { return code_; }

 private:
  ErrorCode code_;
};

/// Result of a call on the real-time path; on any but `ok` the output is untouched. The numbers are part of the API.
///
/// A call for many hands refuses row by row: a row that is refused leaves its part of the output untouched and hinders no
/// other. What became of each row goes to `statuses`, [N] or empty; the call returns that of the first row refused. What
/// all rows share (angles for all, a control period) refuses each of them. Only sizes that disagree refuse the call as
/// a whole: `wrong_size`, and nothing is written, the statuses neither.
enum class Status : int {
  ok = 0,
  non_finite_input = 1,         ///< NaN or infinity in the input
  wrong_size = 2,               ///< a span of the wrong length
  invalid_driving_vectors = 3,  ///< driving-vector angles not strictly increasing in (0, pi)
  unknown_hand = 4,             ///< a batch row for a hand that the solver does not have
  invalid_period = 5,           ///< a control period that is not a positive finite number
  invalid_radial_bounds = 6,    ///< radial bounds that are not -1e6 <= lower <= 0 <= upper <= 1e6
};

/// A short English sentence for `status`; never null.
UHAS_API const char* to_string(Status status) noexcept;

}  // namespace uhas
