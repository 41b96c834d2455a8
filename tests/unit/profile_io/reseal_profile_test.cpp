// Resealing makes a sound edit readable and leaves an unsound one as it is.
#include "uhas/profile_io/reseal_profile.hpp"

#include <doctest/doctest.h>
#include <hdf5.h>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_profile.hpp"
#include "uhas/profile_io/read_profile.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

void set_radius(const std::string& path, double radius) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t dataset = H5Dopen2(file, "sphere/radius", H5P_DEFAULT);
  REQUIRE(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, &radius) >= 0);
  H5Dclose(dataset);
  H5Fclose(file);
}

}  // namespace

TEST_CASE("an edited profile is readable after resealing") {
  const ScratchFolder folder;
  const std::string path = folder.file("hand.h5");
  write_profile(small_profile(), path);
  set_radius(path, 0.09);
  check_error(ErrorCode::invalid_profile, "damaged", [&] { read_profile(path); });
  reseal_profile(path);
  CHECK(read_profile(path).radius == 0.09);
  CHECK(folder.entry_count() == 1);
}

TEST_CASE("resealing an untouched profile changes no byte") {
  const ScratchFolder folder;
  const std::string path = folder.file("hand.h5");
  write_profile(small_profile(), path);
  const std::string bytes = read_bytes(path);
  reseal_profile(path);
  CHECK(read_bytes(path) == bytes);
}

TEST_CASE("an edit that breaks the profile is not sealed") {
  const ScratchFolder folder;
  const std::string path = folder.file("hand.h5");
  write_profile(small_profile(), path);
  set_radius(path, -1);
  const std::string bytes = read_bytes(path);
  check_error(ErrorCode::invalid_profile, "sphere/radius", [&] { reseal_profile(path); });
  CHECK(read_bytes(path) == bytes);
}

TEST_CASE("other files are not sealed") {
  const ScratchFolder folder;
  const std::string path = folder.file("hand.h5");
  for (const std::string& bytes :
       {std::string(), std::string("text"), std::string("uhas-hand-profile 1.0\n"), std::string(4096, 'x')}) {
    write_bytes(path, bytes);
    check_error(ErrorCode::invalid_profile, "not a hand profile", [&] { reseal_profile(path); });
    CHECK(read_bytes(path) == bytes);
  }
  write_bytes(path, "uhas-hand-profile 2.0\n" + std::string(4096, 'x'));
  check_error(ErrorCode::unsupported_version, "2.0", [&] { reseal_profile(path); });
}
