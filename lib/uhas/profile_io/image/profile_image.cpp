#include "uhas/profile_io/image/profile_image.hpp"

#include <array>

#include "uhas/hdf5/handle.hpp"
#include "uhas/hdf5/screening.hpp"
#include "uhas/profile_io/image/profile_error.hpp"
#include "uhas/profile_io/layout/layout.hpp"
#include "uhas/profile_io/layout/layout_reader.hpp"
#include "uhas/profile_io/layout/layout_writer.hpp"

namespace uhas {
namespace {

constexpr const char* format_name = "uhas-hand-profile";

// HDF5's memory driver refuses the name of an existing file; below a device there can be none
constexpr const char* image_name = "/dev/null/uhas-hand-profile";

/// Access to a file that lives in memory only.
Hdf5Handle memory_access() {
  constexpr std::size_t increment = 1u << 16;
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access.id(), increment, /*backing_store=*/false);
  // fixed bounds: the bytes do not depend on the defaults of the library's version
  H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
  H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG);
  return access;
}

Hdf5Handle create_file() {
  const Hdf5Handle access = memory_access();
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(creation.id(), kUserBlockBytes);
  H5Pset_obj_track_times(creation.id(), false);
  return {H5Fcreate(image_name, H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose};
}

Hdf5Handle open_image(std::span<const std::byte> image) {
  const Hdf5Handle access = memory_access();
  // the library copies the image and does not write to it
  H5Pset_file_image(access.id(), const_cast<std::byte*>(image.data()), image.size());
  return {H5Fopen(image_name, H5F_ACC_RDONLY, access.id()), H5Fclose};
}

using VersionNumbers = std::array<std::int32_t, 2>;

bool write_version(hid_t file) {
  constexpr VersionNumbers version{kProfileVersionMajor, kProfileVersionMinor};
  constexpr hsize_t count = version.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle attribute(
      H5Acreate2(file, "version", stored_type<std::int32_t>(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute.id(), memory_type<std::int32_t>(), version.data()) >= 0;
}

/// True when the root says that the file is a hand profile of `version`.
bool has_format_and_version(hid_t file, FormatVersion version) {
  const Hdf5Handle format(H5Aopen(file, "format", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle format_type(H5Aget_type(format.id()), H5Tclose);
  const std::string expected = format_name;
  if (!format.valid() || H5Tget_class(format_type.id()) != H5T_STRING ||
      H5Tget_size(format_type.id()) != expected.size())
    return false;
  std::string name(expected.size(), '\0');
  if (H5Sget_simple_extent_npoints(Hdf5Handle(H5Aget_space(format.id()), H5Sclose).id()) != 1 ||
      H5Aread(format.id(), format_type.id(), name.data()) < 0 || name != expected)
    return false;

  const Hdf5Handle attribute(H5Aopen(file, "version", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  VersionNumbers numbers{};
  return attribute.valid() && H5Sget_simple_extent_npoints(space.id()) == numbers.size() &&
         H5Aread(attribute.id(), memory_type<std::int32_t>(), numbers.data()) >= 0 &&
         FormatVersion{numbers[0], numbers[1]} == version;
}

}  // namespace

std::vector<std::byte> image_of_profile(const HandProfile& profile, const std::string& path) {
  std::vector<std::byte> image;
  {
    const Hdf5Session session;
    const Hdf5Handle file = create_file();
    const auto require = [&](bool succeeded) {
      if (!succeeded)
        throw Error(ErrorCode::write_failed, path, "the HDF5 library could not lay out the file",
                    "check the free memory");
    };
    require(file.valid() && write_string_attribute(file.id(), "format", format_name) && write_version(file.id()));
    LayoutWriter writer(file.id(), path);
    visit_layout(writer, profile);
    screen_hdf5_file(file.id(), path);  // never write what the reader would refuse

    require(H5Fflush(file.id(), H5F_SCOPE_GLOBAL) >= 0);
    const ssize_t size = H5Fget_file_image(file.id(), nullptr, 0);  // of what follows the user block
    require(size > 0);
    image.resize(kUserBlockBytes + static_cast<std::size_t>(size));
    require(H5Fget_file_image(file.id(), image.data() + kUserBlockBytes, static_cast<std::size_t>(size)) == size);
  }
  write_user_block(image, {kProfileVersionMajor, kProfileVersionMinor});
  return image;
}

HandProfile profile_of_image(std::span<const std::byte> image, FormatVersion version, const std::string& path) {
  HandProfile profile;
  {
    const Hdf5Session session;
    const Hdf5Handle file = open_image(image);
    if (!file.valid()) throw profile_error(path, "the content is not HDF5");
    screen_hdf5_file(file.id(), path);
    if (!has_format_and_version(file.id(), version))
      throw profile_error(path, "the root attributes format and version do not agree with the user block");
    const LayoutReader reader(file.id(), path);
    visit_layout(reader, profile);
  }
  validate_profile(profile, path);
  return profile;
}

}  // namespace uhas
