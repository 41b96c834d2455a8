// A sound profile's file with some bytes changed: the input of a target is the list of changes.
#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <span>
#include <vector>

#include "support/small_profile.hpp"
#include "uhas/profile_io/image/profile_image.hpp"

namespace uhas::test {

struct Extent {
  std::size_t start, size;  ///< bytes of the file
};

/// The file of `small_profile`.
inline const std::vector<std::byte>& sound_image() {
  static const std::vector<std::byte> image = image_of_profile(small_profile(), "hand.h5");
  return image;
}

/// That file, changed within `extents`, a few bytes an edit, until the input ends.
inline std::vector<std::byte> edited_image(std::span<const Extent> extents, FuzzedDataProvider& input) {
  std::vector<std::byte> image = sound_image();
  while (input.remaining_bytes() > 0) {
    const Extent& extent = extents[input.ConsumeIntegralInRange<std::size_t>(0, extents.size() - 1)];
    const auto offset = input.ConsumeIntegralInRange<std::size_t>(0, extent.size - 1);
    const std::size_t length = std::min(extent.size - offset, input.ConsumeIntegralInRange<std::size_t>(1, 8));
    const auto bytes = input.ConsumeBytes<std::uint8_t>(length);
    std::ranges::copy(std::as_bytes(std::span(bytes)),
                      image.begin() + static_cast<std::ptrdiff_t>(extent.start + offset));
  }
  return image;
}

}  // namespace uhas::test
