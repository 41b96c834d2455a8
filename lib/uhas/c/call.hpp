// What the functions of uhas.h share: exceptions become codes and a line of text, options are read as long as they are.
#pragma once

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <type_traits>

#include "uhas/base/each_row.hpp"
#include "uhas/c/uhas.h"
#include "uhas/runtime/cascade_solver.hpp"

struct uhas_profile {
  uhas::HandProfile profile;
};

namespace uhas::c {

/// A caller's buffer for one line of text.
struct Message {
  char* text;
  std::size_t size;

  /// Cut to the buffer, between characters of UTF-8.
  void write(const std::string& line) const noexcept {
    if (text == nullptr || size == 0) return;
    std::size_t length = std::min(line.size(), size - 1);
    const auto continues = [&](std::size_t i) { return (static_cast<unsigned char>(line[i]) & 0xC0) == 0x80; };
    while (length > 0 && length < line.size() && continues(length)) --length;
    std::memcpy(text, line.data(), length);
    text[length] = '\0';
  }
};

[[noreturn]] inline void refuse(const std::string& problem, const std::string& remedy) {
  throw Error(ErrorCode::invalid_option, "", problem, remedy);
}

/// Runs `make`, which returns a handle or throws; `handle` becomes NULL when it throws.
template <class Handle, class Make>
int create(Handle** handle, Message message, Make&& make) noexcept {
  if (handle == nullptr) {
    message.write("the address of the handle is NULL");
    return UHAS_ERROR_INVALID_OPTION;
  }
  *handle = nullptr;
  try {
    *handle = make();
    return UHAS_OK;
  } catch (const Error& error) {
    message.write(error.what());
    return static_cast<int>(error.code());
  } catch (const std::bad_alloc&) {
    message.write("out of memory");
    return UHAS_ERROR_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    message.write(error.what());
    return UHAS_ERROR_INTERNAL;
  } catch (...) {
    message.write("an unknown exception");
    return UHAS_ERROR_INTERNAL;
  }
}

inline const HandProfile& profile_of(const uhas_profile* profile) {
  if (profile == nullptr) refuse("the profile is NULL", "load one");
  return profile->profile;
}

/// Whether the options of the caller, who may have an older header, hold nothing that this library does not know.
template <class Options>
bool is_known(const Options& given) noexcept {
  return given.struct_size >= sizeof(std::size_t) && given.struct_size <= sizeof(Options);
}

/// `options` overwritten by those given, as far as they go.
template <class Options>
void overwrite(Options& options, const Options* given) noexcept {
  if (given != nullptr) std::memcpy(&options, given, given->struct_size);
}

template <class Options>
Options read_options(const Options* given, Options options) {
  if (given != nullptr && !is_known(*given))
    refuse("struct_size is " + std::to_string(given->struct_size),
           "initialise options by their _INIT; a newer program needs a newer library");
  overwrite(options, given);
  return options;
}

/// What a handle solves by, and the number of driving vectors of its actions, V.
struct SolveSettings {
  SolveOptions options;
  int driving_vectors;
};

inline SolveSettings solve_settings(const uhas_solve_options* given) {
  const uhas_solve_options options = read_options(given, UHAS_SOLVE_OPTIONS_INIT);
  const auto require_choice = [](const char* field, int choice) {
    if (choice != 0 && choice != 1) refuse(field + (" is " + std::to_string(choice)), "choose 0 or 1");
  };
  require_choice("rule", options.rule);
  require_choice("closing", options.closing);
  require_choice("field", options.field);
  require_choice("convention", options.convention);
  if (options.driving_vectors < 1 || options.driving_vectors > kMaxDrivingVectors)
    refuse("driving_vectors is " + std::to_string(options.driving_vectors), "choose a number from 1 to 4");
  return {{.rule = static_cast<CascadeRule>(options.rule),
           .closing = static_cast<CascadeClosing>(options.closing),
           .field = static_cast<FieldReading>(options.field),
           .passes = options.passes,
           .convention = (options.convention == UHAS_CONVENTION_SIM ? kUhasSim : kUhas).convention},
          options.driving_vectors};
}

/// An array and its size; empty when there is none.
template <class Real>
std::span<Real> array(Real* elements, std::size_t size) noexcept {
  return elements == nullptr ? std::span<Real>() : std::span<Real>(elements, size);
}

/// How many rows of `row` elements `size` elements are; -1 when they are not whole rows.
inline std::ptrdiff_t rows_of(std::size_t size, std::size_t row) noexcept {
  return row > 0 && size % row == 0 ? static_cast<std::ptrdiff_t>(size / row) : -1;
}

/// The statuses of `count` rows, where the caller wants them. A Status is stored as an int.
inline std::span<Status> statuses_of(int* statuses, std::size_t count) noexcept {
  static_assert(std::is_same_v<std::underlying_type_t<Status>, int>);
  return array(reinterpret_cast<Status*>(statuses), count);
}

/// The actions of several hands, [hands][5 + 5 V], read in one way.
template <class Real>
class Actions {
 public:
  Actions(const Real* values, std::size_t size, int driving_vectors, const uhas_action_options* given,
          std::size_t hands) noexcept
      : values_(array(values, size)), row_(kSlotCount * (1 + driving_vectors)) {
    const bool rows_fit = values_.size() % row_ == 0 && values_.size() / row_ == hands;
    if (!rows_fit || (given != nullptr && !is_known(*given))) return;
    uhas_action_options options = UHAS_ACTION_OPTIONS_INIT;
    overwrite(options, given);
    normalized_ = options.normalized != 0;
    angles_ = options.driving_vectors_size;
    const std::size_t vectors = driving_vectors;
    const bool has_angles = options.driving_vectors_phi != nullptr;
    fits_ = has_angles ? angles_ == vectors || angles_ == kSlotCount * vectors : angles_ == 0;
    if (!fits_) return;
    const auto as_real = [](double number) { return static_cast<Real>(number); };
    if (has_angles)
      std::transform(options.driving_vectors_phi, options.driving_vectors_phi + angles_, phi_.begin(), as_real);
    has_offsets_ = options.azimuth_offsets != nullptr;
    has_bounds_ = options.radial_bounds != nullptr;
    if (has_offsets_)
      std::transform(options.azimuth_offsets, options.azimuth_offsets + kSlotCount, offsets_.begin(), as_real);
    if (has_bounds_) std::transform(options.radial_bounds, options.radial_bounds + 2, bounds_.begin(), as_real);
  }

  /// Whether the sizes agree.
  bool fits() const noexcept { return fits_; }
  Action<Real> operator[](std::size_t hand) const noexcept {
    return {values_.subspan(hand * row_, row_), angles(), normalized_, azimuth_offsets(), radial_bounds()};
  }

  std::span<const Real> values() const noexcept { return values_; }
  std::span<const Real> angles() const noexcept { return std::span(phi_).first(angles_); }
  bool normalized() const noexcept { return normalized_; }
  std::span<const Real> azimuth_offsets() const noexcept {
    return std::span(offsets_).first(has_offsets_ ? kSlotCount : 0);
  }
  std::span<const Real> radial_bounds() const noexcept { return std::span(bounds_).first(has_bounds_ ? 2 : 0); }

 private:
  std::span<const Real> values_;
  std::size_t row_;  // 5 + 5 V
  std::array<Real, kSlotCount * kMaxDrivingVectors> phi_{};
  std::size_t angles_ = 0;
  std::array<Real, kSlotCount> offsets_{};
  std::array<Real, 2> bounds_{};
  bool normalized_ = false, has_offsets_ = false, has_bounds_ = false, fits_ = false;
};

/// One object in both precisions.
template <template <class> class Job>
struct Both {
  template <class... Arguments>
  explicit Both(const Arguments&... arguments) : in_double(arguments...), in_float(arguments...) {}

  Job<double> in_double;
  Job<float> in_float;

  template <class Real>
  Job<Real>& in() noexcept {
    if constexpr (std::is_same_v<Real, double>)
      return in_double;
    else
      return in_float;
  }
};

}  // namespace uhas::c
