// Any byte of a profile changed, or the file cut short, and sealed anew so that it gets past the hash; read as
// an untrusted file is: a profile that a solver takes, or an Error. HDF5 crashes on some (Debian 12: 1.10.8), in
// the child process.
#include "fuzz_file.hpp"
#include "profile_edits.hpp"
#include "uhas/profile_io/image/user_block.hpp"
#include "uhas/profile_io/read_profile.hpp"
#include "uhas/runtime/cascade_solver.hpp"

using namespace uhas;
using namespace uhas::test;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider input(data, size);
  const std::size_t whole = sound_image().size();
  const std::size_t kept =
      input.ConsumeBool() ? input.ConsumeIntegralInRange<std::size_t>(kUserBlockBytes, whole) : whole;
  std::vector<std::byte> image = edited_image(std::array{Extent{kUserBlockBytes, whole - kUserBlockBytes}}, input);
  image.resize(kept);
  write_user_block(image, {kProfileVersionMajor, kProfileVersionMinor});
  const std::string path = input_file("hand.h5", {reinterpret_cast<const char*>(image.data()), image.size()});
  accepted(
      [&] { CascadeSolver<double>(read_untrusted_profile(path, {.max_memory_bytes = 1u << 30, .max_seconds = 10})); });
  return 0;
}
