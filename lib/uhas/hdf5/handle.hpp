// What the HDF5 C library asks of its callers, as types: identifiers that close themselves, turns, silence.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <mutex>
#include <type_traits>
#include <utility>

namespace uhas {

/// Held around all use of HDF5: callers take turns, whether or not the library was built for threads, and its error
/// printing is off.
class Hdf5Session {
 public:
  Hdf5Session();
  Hdf5Session(const Hdf5Session&) = delete;
  Hdf5Session& operator=(const Hdf5Session&) = delete;
  ~Hdf5Session();

 private:
  std::lock_guard<std::mutex> turn_;
  H5E_auto2_t print_ = nullptr;
  void* print_data_ = nullptr;
};

/// An HDF5 identifier that closes itself.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle(hid_t id, Close closed_by) : id_(id), close_(closed_by) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  ~Hdf5Handle() { close(); }

  bool valid() const { return id_ >= 0; }
  hid_t id() const { return id_; }

  /// Now rather than later, to learn whether it succeeds.
  bool close() { return !valid() || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// The type in the file of a number that is `Number` in memory: little-endian IEEE 754 and two's complement.
template <class Number>
hid_t stored_type() {
  static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, std::int32_t> ||
                std::is_same_v<Number, std::uint8_t>);
  if constexpr (std::is_same_v<Number, double>) return H5T_IEEE_F64LE;
  if constexpr (std::is_same_v<Number, std::int32_t>) return H5T_STD_I32LE;
  if constexpr (std::is_same_v<Number, std::uint8_t>) return H5T_STD_U8LE;
}

template <class Number>
hid_t memory_type() {
  if constexpr (std::is_same_v<Number, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<Number, std::int32_t>) return H5T_NATIVE_INT32;
  if constexpr (std::is_same_v<Number, std::uint8_t>) return H5T_NATIVE_UINT8;
}

/// The type of a fixed-length UTF-8 string, padded with zeros.
Hdf5Handle string_type(std::size_t bytes);

}  // namespace uhas
