// A hand profile as flat bytes in memory, for places without HDF5 such as a web page, and from process to process. Not
// a file format: it has no version of its own, and writer and reader must be of one build.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "uhas/profile/hand_profile.hpp"

namespace uhas {

/// `profile` as bytes, the same on every machine.
std::vector<std::byte> flatten_profile(const HandProfile& profile);

/// The profile in `bytes`, validated. Reads nothing beyond them and allocates in proportion to them, whatever they say.
/// Throws Error(invalid_profile).
HandProfile unflatten_profile(std::span<const std::byte> bytes);

}  // namespace uhas
