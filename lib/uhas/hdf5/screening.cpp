#include "uhas/hdf5/screening.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "uhas/hdf5/handle.hpp"

namespace uhas {
namespace {

constexpr int max_depth = 4;       // of nested groups; the format has two levels
constexpr int max_objects = 2000;  // groups, datasets and attributes; the format has about 140

class Screening {
 public:
  Screening(const std::string& path, const Hdf5Bounds& bounds) : path_(path), bounds_(bounds) {}

  void visit_group(hid_t group, const std::string& name, int depth) {
    visit_attributes(group, name);
    if (depth > max_depth) refuse(name, "is nested too deep");
    H5G_info_t info{};
    if (H5Gget_info(group, &info) < 0) refuse(name, "cannot be listed");
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      const std::string child = link_name(group, i, name);
      H5L_info_t link{};
      if (H5Lget_info(group, child.c_str(), &link, H5P_DEFAULT) < 0) refuse(name, "cannot be listed");
      const std::string child_name = name + (name == "/" ? "" : "/") + child;
      if (link.type != H5L_TYPE_HARD) refuse(child_name, "is a soft, external or user-defined link");
      visit_object(Hdf5Handle(H5Oopen(group, child.c_str(), H5P_DEFAULT), H5Oclose), child_name, depth + 1);
    }
  }

 private:
  void visit_object(const Hdf5Handle& object, const std::string& name, int depth) {
    count_object(name);
    const H5I_type_t kind = object.valid() ? H5Iget_type(object.id()) : H5I_BADID;
    if (kind == H5I_GROUP)
      visit_group(object.id(), name, depth);
    else if (kind == H5I_DATASET)
      visit_dataset(object.id(), name);
    else
      refuse(name, "is neither a group nor a dataset");
  }

  void visit_dataset(hid_t dataset, const std::string& name) {
    visit_attributes(dataset, name);
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    check_values(type.id(), space.id(), name);
    check_storage(dataset, H5Tget_size(type.id()), name);
  }

  void visit_attributes(hid_t object, const std::string& name) {
    // H5Aopen_by_idx past the last attribute fails, which ends the list whatever the library's version of H5O_info_t
    for (hsize_t i = 0;; ++i) {
      const Hdf5Handle attribute(H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT),
                                 H5Aclose);
      if (!attribute.valid()) break;
      count_object(name);
      const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
      const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
      check_values(type.id(), space.id(), "an attribute of " + name);
    }
  }

  void check_values(hid_t type, hid_t space, const std::string& name) {
    const H5T_class_t kind = H5Tget_class(type);
    const bool is_plain = kind == H5T_INTEGER || kind == H5T_FLOAT ||
                          (kind == H5T_STRING && (bounds_.allow_variable_text || !H5Tis_variable_str(type)));
    if (!is_plain) refuse(name, "is neither of numbers nor of fixed-length strings");

    std::array<hsize_t, H5S_MAX_RANK> extents{};
    const int rank = H5Sget_simple_extent_ndims(space);
    if (rank < 0 || H5Sget_simple_extent_type(space) == H5S_NULL) refuse(name, "has no values");
    H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    if (rank > 0 && extents[0] > bounds_.max_rows) exceed(name, "has more rows than", "have", bounds_.bound_remedy);
    count_bytes(name, array_bytes(H5Tget_size(type), {extents.data(), static_cast<std::size_t>(rank)}));
  }

  void check_storage(hid_t dataset, std::size_t value_bytes, const std::string& name) {
    const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose);
    const H5D_layout_t layout = H5Pget_layout(creation.id());
    if (layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED)
      refuse(name, "is stored in other files");
    if (H5Pget_external_count(creation.id()) != 0) refuse(name, "is stored in other files");
    for (int i = 0; i < H5Pget_nfilters(creation.id()); ++i) {
      unsigned flags = 0;
      std::size_t parameters = 0;
      const H5Z_filter_t filter =
          H5Pget_filter2(creation.id(), static_cast<unsigned>(i), &flags, &parameters, nullptr, 0, nullptr, nullptr);
      if (filter != H5Z_FILTER_DEFLATE && !(bounds_.allow_shuffle && filter == H5Z_FILTER_SHUFFLE))
        refuse(name, "is packed by a filter other than deflate");
    }
    if (layout == H5D_CHUNKED) {  // however little of the chunk the dataset covers
      std::array<hsize_t, H5S_MAX_RANK> chunk{};
      const int rank = H5Pget_chunk(creation.id(), H5S_MAX_RANK, chunk.data());
      const std::uint64_t bytes = array_bytes(value_bytes, {chunk.data(), static_cast<std::size_t>(std::max(rank, 0))});
      if (bytes > bounds_.max_chunk_bytes)
        exceed(name, "has a larger chunk than", "have", "store it in smaller chunks");
      count_bytes(name, bytes);
    }
  }

  std::string link_name(hid_t group, hsize_t index, const std::string& name) const {
    const ssize_t length = H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, index, nullptr, 0, H5P_DEFAULT);
    if (length <= 0) refuse(name, "cannot be listed");
    std::string link(static_cast<std::size_t>(length), '\0');
    H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, index, link.data(), link.size() + 1, H5P_DEFAULT);
    return link;
  }

  void count_object(const std::string& name) {
    if (++objects_ > max_objects) exceed(name, "is one object more than", "have", bounds_.refusal_remedy);
  }

  /// The largest number when the size is beyond it.
  static std::uint64_t array_bytes(std::uint64_t value_bytes, std::span<const hsize_t> extents) {
    constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t bytes = value_bytes;
    for (const hsize_t extent : extents) {
      if (extent != 0 && bytes > largest / extent) return largest;
      bytes *= extent;
    }
    return bytes;
  }

  void count_bytes(const std::string& name, std::uint64_t bytes) {
    if (bytes > bounds_.max_bytes - bytes_) exceed(name, "is larger than", "be", bounds_.bound_remedy);
    bytes_ += bytes;
  }

  [[noreturn]] void refuse(const std::string& name, const std::string& problem) const {
    throw Error(bounds_.refusal, path_, name + " " + problem, bounds_.refusal_remedy);
  }
  [[noreturn]] void exceed(const std::string& name, const std::string& more_than, const std::string& verb,
                           const std::string& remedy) const {
    throw Error(ErrorCode::limit_exceeded, path_, name + " " + more_than + " " + bounds_.kind + " can " + verb, remedy);
  }

  const std::string& path_;
  const Hdf5Bounds& bounds_;
  int objects_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace

void screen_hdf5_file(hid_t file, const std::string& path, const Hdf5Bounds& bounds) {
  const Hdf5Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose);
  if (!root.valid()) throw Error(bounds.refusal, path, "the file has no root group", bounds.refusal_remedy);
  Screening(path, bounds).visit_group(root.id(), "/", 0);
}

}  // namespace uhas

void uhas::check_hdf5_bounds(const std::string& path, const Hdf5Bounds& bounds) {
  const Hdf5Session session;
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid())
    throw Error(ErrorCode::file_unreadable, path, "cannot be opened as HDF5", "check the path and what wrote the file");
  screen_hdf5_file(file.id(), path, bounds);
}
