// Only plain, bounded content: what an HDF5 file may hold that comes from elsewhere.
#pragma once

#include <cstdint>
#include <string>

#include "uhas/base/errors.hpp"

namespace uhas {

/// By default the bounds of a hand profile.
struct Hdf5Bounds {
  const char* kind = "a hand profile";  ///< of file, for errors
  ErrorCode refusal = ErrorCode::invalid_profile;
  const char* refusal_remedy = "rebuild it with uhas-build-profile";
  const char* bound_remedy = "build it with fewer samples";
  std::uint64_t max_rows = 1u << 20;           ///< of each dataset
  std::uint64_t max_bytes = 256u << 20;        ///< of all values and chunks together, unpacked
  std::uint64_t max_chunk_bytes = 256u << 20;  ///< of one chunk, which is unpacked whole
  bool allow_variable_text = false;            ///< text of variable length
  bool allow_shuffle = false;                  ///< the filter that often precedes deflate
};

/// Refuses links that are not hard links, objects that are neither groups nor datasets, types other than integers,
/// floating-point numbers and fixed-length strings, external and virtual storage, filters other than deflate, and more
/// objects, rows or bytes than the bounds allow. Attributes are held to the same rules. A damaged file may bring HDF5
/// down before it is refused. Throws Error: file_unreadable for what is not HDF5, `bounds.refusal`, limit_exceeded.
void check_hdf5_bounds(const std::string& path, const Hdf5Bounds& bounds);

}  // namespace uhas
