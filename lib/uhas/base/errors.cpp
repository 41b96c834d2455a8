#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

std::string compose(const std::string& file, const std::string& problem, const std::string& remedy) {
  std::string text;
  if (!file.empty()) text += file + ": ";
  text += problem;
  if (!remedy.empty()) text += "; " + remedy;
  return text;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& file, const std::string& problem, const std::string& remedy)
    : std::runtime_error(compose(file, problem, remedy)), code_(code) {}

Error::~Error() = default;

const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::ok: return "ok";
    case Status::non_finite_input: return "the input has a number that is not finite";
    case Status::wrong_size: return "a span has the wrong length";
    case Status::invalid_driving_vectors: return "driving-vector angles must increase strictly within (0, pi)";
    case Status::unknown_hand: return "a row is for a hand that the batch solver does not have";
    case Status::invalid_period: return "the control period must be a positive finite number of seconds";
    case Status::invalid_radial_bounds: return "radial bounds must be -1e6 <= lower <= 0 <= upper <= 1e6";
  }
  return "unknown status";
}

}  // namespace uhas
