#include "uhas/profile_io/layout/layout_writer.hpp"

#include <algorithm>

#include "uhas/base/errors.hpp"

namespace uhas {

LayoutWriter::LayoutWriter(hid_t file, const std::string& path) : file_(file), path_(path) {}

void LayoutWriter::write_strings(const std::string& name, const Shape& shape, const std::vector<std::string>& texts) {
  std::size_t width = 1;  // HDF5 has no strings of length zero
  for (const std::string& text : texts) width = std::max(width, text.size());
  std::string padded(width * texts.size(), '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::copy(texts[i].begin(), texts[i].end(), padded.begin() + i * width);
  const Hdf5Handle type = string_type(width);
  write_dataset(name, "", shape, type.id(), type.id(), padded.data());
}

void LayoutWriter::write_dataset(const std::string& name, const char* units, const Shape& shape, hid_t stored,
                                 hid_t memory, const void* data) {
  require_group(name.substr(0, name.find('/')));
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  const Hdf5Handle dataset(H5Dcreate2(file_, name.c_str(), stored, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                           H5Dclose);
  require(dataset.valid(), name);
  require(H5Dwrite(dataset.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0, name);
  if (*units) require(write_string_attribute(dataset.id(), "units", units), name);
}

void LayoutWriter::require_group(const std::string& name) {
  if (H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0) return;
  const Hdf5Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  const Hdf5Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose);
  require(group.valid(), name);
}

void LayoutWriter::require(bool succeeded, const std::string& name) const {
  if (!succeeded)
    throw Error(ErrorCode::write_failed, path_, "the HDF5 library could not write " + name, "check the free memory");
}

bool write_string_attribute(hid_t object, const char* name, const std::string& text) {
  const Hdf5Handle type = string_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute.id(), type.id(), text.data()) >= 0;
}

}  // namespace uhas
