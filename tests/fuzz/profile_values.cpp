// A sound profile with other numbers in its datasets: refused by an Error, or as good as any other profile to the
// solver, the encoder and the observer. HDF5's own bytes stay whole, so that what is tried is our validation.
#include <hdf5.h>

#include <cmath>

#include "fuzz_file.hpp"
#include "profile_edits.hpp"
#include "uhas/runtime/cascade_solver.hpp"
#include "uhas/runtime/encoder.hpp"
#include "uhas/runtime/observation.hpp"
#include "within_limits.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

herr_t add_extent(hid_t file, const char* name, const H5O_info_t* info, void* extents) {
  if (info->type != H5O_TYPE_DATASET) return 0;
  const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
  const haddr_t start = H5Dget_offset(dataset);
  const hsize_t size = H5Dget_storage_size(dataset);
  if (start != HADDR_UNDEF && size > 0) static_cast<std::vector<Extent>*>(extents)->push_back({start, size});
  H5Dclose(dataset);
  return 0;
}

/// Where the values of the datasets are.
std::vector<Extent> find_extents() {
  const std::vector<std::byte>& image = sound_image();
  const std::string path = input_file("hand.h5", {reinterpret_cast<const char*>(image.data()), image.size()});
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  std::vector<Extent> extents;
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_INC, add_extent, &extents);
  H5Fclose(file);
  require(extents.size() > 50);
  return extents;
}

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// @param encodes  too: an encoder solves thousands of actions when it is made
void use(const HandProfile& profile, bool encodes) {
  CascadeSolver<double> solver(profile);
  Observer<double> observer(profile);
  std::vector<double> q(profile.tree.joints.size()), qd(q.size()), action(15), observation(observer.size());
  for (const double value : {0.0, -1.5, 0.7}) {
    std::ranges::fill(action, value);
    require(solver.solve({.values = action}, q) == Status::ok);
    require(within_limits<double>(profile, q));
  }
  if (encodes) {
    Encoder<double> encoder(profile);
    EncodeReport report;
    require(encoder.encode(q, action, report) == Status::ok && all_finite(action));
  }
  require(observer.observe(q, qd, observation) == Status::ok && all_finite(observation));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<Extent> extents = find_extents();
  FuzzedDataProvider input(data, size);
  const bool encodes = input.ConsumeIntegralInRange(0, 15) == 0;
  const std::vector<std::byte> image = edited_image(extents, input);
  HandProfile profile;
  if (accepted([&] { profile = profile_of_image(image, {kProfileVersionMajor, kProfileVersionMinor}, "hand.h5"); }))
    use(profile, encodes);
  return 0;
}
