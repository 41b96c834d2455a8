#include "uhas/profile_io/layout/layout_reader.hpp"

#include <algorithm>

#include "uhas/profile_io/image/profile_error.hpp"

namespace uhas {
namespace {

std::vector<hsize_t> shape_of(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(rank, 0)));
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  return shape;
}

std::string to_text(const std::vector<hsize_t>& shape) {
  std::string text;
  for (const hsize_t extent : shape) text += (text.empty() ? "" : ", ") + std::to_string(extent);
  return "[" + text + "]";
}

}  // namespace

LayoutReader::LayoutReader(hid_t file, const std::string& path) : file_(file), path_(path) {}

std::size_t LayoutReader::row_count(const std::string& name) const {
  const Hdf5Handle dataset = open_dataset(name);
  const Shape shape = shape_of(dataset.id());
  if (shape.empty()) refuse(name, "has no rows, only one value");
  return shape.front();
}

std::vector<std::int32_t> LayoutReader::read_offsets(const std::string& name, std::size_t rows) const {
  const std::vector<std::int32_t> offsets = read_numbers<std::int32_t>(name, {rows + 1}, rows + 1);
  if (offsets.front() != 0 || !std::is_sorted(offsets.begin(), offsets.end()))
    refuse(name, "does not start at 0 and increase");
  return offsets;
}

std::vector<std::string> LayoutReader::read_strings(const std::string& name, const Shape& shape,
                                                    std::size_t count) const {
  const Hdf5Handle dataset = open_dataset(name, shape);
  const Hdf5Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING) refuse(name, "is not of fixed-length strings");
  const std::size_t width = H5Tget_size(type.id());
  std::string padded(width * count, '\0');
  read_dataset(dataset.id(), type.id(), padded.data(), name);

  std::vector<std::string> texts(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view text(padded.data() + i * width, width);
    texts[i] = text.substr(0, text.find('\0'));
  }
  return texts;
}

Hdf5Handle LayoutReader::open_dataset(const std::string& name) const {
  Hdf5Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.valid()) refuse(name, "is missing or is no dataset");
  return dataset;
}

Hdf5Handle LayoutReader::open_dataset(const std::string& name, const Shape& expected) const {
  Hdf5Handle dataset = open_dataset(name);
  const Shape shape = shape_of(dataset.id());
  if (shape != expected) refuse(name, "has shape " + to_text(shape) + ", not " + to_text(expected));
  return dataset;
}

void LayoutReader::require_type(hid_t dataset, hid_t expected, const std::string& name) const {
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  if (H5Tequal(type.id(), expected) <= 0) refuse(name, "does not have the number type of the format");
}

void LayoutReader::read_dataset(hid_t dataset, hid_t memory, void* data, const std::string& name) const {
  if (H5Dread(dataset, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0) refuse(name, "cannot be read");
}

void LayoutReader::refuse(const std::string& name, const std::string& problem) const {
  throw profile_error(path_, name + " " + problem);
}

}  // namespace uhas
