#include "uhas/trajectory/hdf5/trajectory_hdf5.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "uhas/base/errors.hpp"
#include "uhas/files/file_replacement.hpp"
#include "uhas/hdf5/bounds.hpp"

namespace uhas {
namespace {

constexpr const char* kFormat = "uhas-trajectory";
constexpr hsize_t kBlock = 1024;  // frames held in memory at a time
constexpr hsize_t kMaxJoints = 1000;
constexpr std::size_t kMaxNameBytes = 1000;

// What h5py and MATLAB write of a trajectory, and no more.
Hdf5Bounds bounds(std::uint64_t max_bytes) {
  return {.kind = "a trajectory",
          .refusal = ErrorCode::syntax,
          .refusal_remedy = "store plain numbers and names",
          .bound_remedy = "cut it into parts or raise the bound by --max-hdf5-bytes",
          .max_rows = max_bytes,  // a row has a byte at least
          .max_bytes = max_bytes,
          .allow_variable_text = true,
          .allow_shuffle = true};
}

/// An HDF5 identifier that closes itself.
class Handle {
 public:
  Handle() = default;
  Handle(hid_t id, herr_t (*closed_by)(hid_t)) : id_(id), close_(closed_by) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() {
    if (valid()) close_(id_);
  }
  hid_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }

  /// Now rather than later, to learn whether it succeeds.
  bool close() { return close_(std::exchange(id_, H5I_INVALID_HID)) >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  herr_t (*close_)(hid_t) = nullptr;
};

Error wrong(const std::string& path, const std::string& problem, const std::string& remedy) {
  return {ErrorCode::syntax, path, problem, remedy};
}

std::vector<hsize_t> extents_of(hid_t dataset) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> extents(std::max(rank, 0));
  H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
  return extents;
}

/// Text of any length: fixed-length strings lose their padding.
std::vector<std::string> read_names(hid_t file, const std::string& path) {
  const Handle dataset(H5Dopen2(file, "joint_names", H5P_DEFAULT), H5Dclose);
  const Handle type(dataset.valid() ? H5Dget_type(dataset.id()) : H5I_INVALID_HID, H5Tclose);
  if (!type.valid() || H5Tget_class(type.id()) != H5T_STRING || extents_of(dataset.id()).size() != 1)
    throw wrong(path, "has no dataset joint_names, a list of names",
                "store the names in the order of the columns of q");
  const std::size_t count = extents_of(dataset.id())[0];
  if (count > kMaxJoints || (H5Tis_variable_str(type.id()) <= 0 && H5Tget_size(type.id()) > kMaxNameBytes))
    throw Error(ErrorCode::limit_exceeded, path, "joint_names holds more or longer names than a hand has",
                "name the joints of one hand");
  std::vector<std::string> names(count);
  bool read = true;
  if (H5Tis_variable_str(type.id()) > 0) {
    std::vector<char*> texts(count, nullptr);
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    read = H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) >= 0;
    for (std::size_t i = 0; read && i < count; ++i) names[i] = texts[i] == nullptr ? "" : texts[i];
    if (read) H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, texts.data());
  } else {
    const std::size_t length = H5Tget_size(type.id());
    std::vector<char> text(count * length);
    read = H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0;
    for (std::size_t i = 0; read && i < count; ++i) {
      names[i].assign(text.data() + i * length, length);
      names[i].erase(std::min(names[i].find('\0'), names[i].find_last_not_of(' ') + 1));
    }
  }
  if (!read) throw wrong(path, "joint_names cannot be read", "store it as text");
  return names;
}

/// The root attribute `hand`, text of fixed or variable length; empty when there is none.
std::string read_hand(hid_t file) {
  if (H5Aexists(file, "hand") <= 0) return "";
  const Handle attribute(H5Aopen(file, "hand", H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose), space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Tget_class(type.id()) != H5T_STRING || H5Sget_simple_extent_npoints(space.id()) != 1) return "";
  if (H5Tis_variable_str(type.id()) > 0) {
    char* text = nullptr;
    const bool read = H5Aread(attribute.id(), type.id(), &text) >= 0 && text != nullptr;
    const std::string hand = read ? text : "";
    H5free_memory(text);
    return hand;
  }
  std::string hand(H5Tget_size(type.id()), '\0');
  if (H5Aread(attribute.id(), type.id(), hand.data()) < 0) return "";
  return hand.substr(0, hand.find('\0'));
}

class Hdf5Reader : public TrajectoryReader {
 public:
  Hdf5Reader(std::string path, Handle file, TrajectoryHeader header)
      : TrajectoryReader(std::move(header)),
        path_(std::move(path)),
        file_(std::move(file)),
        q_(H5Dopen2(file_.id(), "q", H5P_DEFAULT), H5Dclose) {
    const Handle type(q_.valid() ? H5Dget_type(q_.id()) : H5I_INVALID_HID, H5Tclose);
    const H5T_class_t kind = type.valid() ? H5Tget_class(type.id()) : H5T_NO_CLASS;
    const std::vector<hsize_t> extents = q_.valid() ? extents_of(q_.id()) : std::vector<hsize_t>{};
    if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || extents.size() != 2)
      throw wrong(path_, "has no dataset q of numbers, frames by joints",
                  "store the joint values as q [frames][joints]");
    if (extents[1] != joints())
      throw wrong(path_, "q has " + std::to_string(extents[1]) + " columns for " + std::to_string(joints()) + " joints",
                  "store one column for each name of joint_names");
    frames_ = extents[0];
  }

  bool next(std::vector<double>& q) override {
    if (next_ == frames_) return false;
    if (next_ % kBlock == 0) read_block();
    const auto row = block_.begin() + static_cast<std::ptrdiff_t>(next_ % kBlock * joints());
    q.assign(row, row + static_cast<std::ptrdiff_t>(joints()));
    if (!std::ranges::all_of(q, [](double value) { return std::isfinite(value); }))
      throw wrong(path_ + ": frame " + std::to_string(next_), "has a value that is not finite",
                  "mend or leave out the frame");
    ++next_;
    return true;
  }
  double progress() const override { return double(next_) / double(std::max<hsize_t>(frames_, 1)); }

 private:
  std::size_t joints() const { return header().joint_names.size(); }

  void read_block() {
    const hsize_t start[] = {next_, 0}, count[] = {std::min(kBlock, frames_ - next_), joints()};
    block_.resize(count[0] * count[1]);
    const Handle space(H5Dget_space(q_.id()), H5Sclose), memory(H5Screate_simple(2, count, nullptr), H5Sclose);
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
        H5Dread(q_.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, block_.data()) < 0)
      throw wrong(path_, "q cannot be read from frame " + std::to_string(next_), "make sure that the file is whole");
  }

  std::string path_;
  Handle file_, q_;
  hsize_t frames_ = 0, next_ = 0;
  std::vector<double> block_;  // [up to kBlock][joints]
};

/// How datasets are made: without time stamps, so that the same frames give the same bytes.
Handle dataset_creation() {
  Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  return creation;
}

/// A dataset [frames] or [frames][columns] that grows by blocks.
class GrowingDataset {
 public:
  GrowingDataset(hid_t file, const char* name, hsize_t columns, bool is_matrix)
      : rank_(is_matrix ? 2 : 1), columns_(columns) {
    const hsize_t none[] = {0, columns}, unlimited[] = {H5S_UNLIMITED, columns}, chunk[] = {kBlock, columns};
    const Handle space(H5Screate_simple(rank_, none, unlimited), H5Sclose);
    const Handle creation = dataset_creation();
    H5Pset_chunk(creation.id(), rank_, chunk);
    dataset_ = {H5Dcreate2(file, name, H5T_IEEE_F64LE, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Dclose};
  }

  bool append(const std::vector<double>& values) {
    const hsize_t start[] = {rows_, 0}, count[] = {values.size() / columns_, columns_};
    const hsize_t size[] = {rows_ + count[0], columns_};
    if (!dataset_.valid() || H5Dset_extent(dataset_.id(), size) < 0) return false;
    rows_ += count[0];
    const Handle space(H5Dget_space(dataset_.id()), H5Sclose),
        memory(H5Screate_simple(rank_, count, nullptr), H5Sclose);
    return H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
           H5Dwrite(dataset_.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, values.data()) >= 0;
  }

 private:
  int rank_;
  hsize_t columns_, rows_ = 0;
  Handle dataset_;
};

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), std::max<std::size_t>(length, 1));
  H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

bool write_attribute(hid_t file, const char* name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute.id(), type, value) >= 0;
}

bool write_names(hid_t file, const std::vector<std::string>& names) {
  std::size_t longest = 1;
  for (const std::string& name : names) longest = std::max(longest, name.size());
  std::string text;
  for (const std::string& name : names) text += name + std::string(longest - name.size(), '\0');
  const hsize_t count = names.size();
  const Handle type = text_type(longest), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Handle creation = dataset_creation();
  const Handle dataset(H5Dcreate2(file, "joint_names", type.id(), space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
                       H5Dclose);
  return dataset.valid() && H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0;
}

class Hdf5Writer : public TrajectoryWriter {
 public:
  Hdf5Writer(const std::string& path, const TrajectoryHeader& header)
      : path_(path),
        replacement_(path),
        file_(H5Fcreate(replacement_.temporary_path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose) {
    datasets_.emplace_back(file_.id(), "q", header.joint_names.size(), true);
    datasets_.emplace_back(file_.id(), "residual_max", 1, false);
    datasets_.emplace_back(file_.id(), "residual_rms", 1, false);
    const int version = 1;
    require(file_.valid() &&
            write_attribute(file_.id(), "format", text_type(std::string(kFormat).size()).id(), kFormat) &&
            write_attribute(file_.id(), "version", H5T_NATIVE_INT, &version) &&
            write_attribute(file_.id(), "hand", text_type(header.hand.size()).id(), header.hand.c_str()) &&
            write_names(file_.id(), header.joint_names));
  }

  void write(std::span<const double> q, const EncodeReport& report) override {
    blocks_[0].insert(blocks_[0].end(), q.begin(), q.end());
    blocks_[1].push_back(report.residual_max);
    blocks_[2].push_back(report.residual_rms);
    if (blocks_[1].size() == kBlock) empty_blocks();
  }
  void finish(const TrajectorySummary&) override {
    empty_blocks();
    datasets_.clear();
    require(file_.close());
    replacement_.commit();
  }

 private:
  void empty_blocks() {
    for (int i = 0; i < 3; ++i) {
      require(datasets_[i].append(blocks_[i]));
      blocks_[i].clear();
    }
  }
  void require(bool succeeded) const {
    if (!succeeded)
      throw Error(ErrorCode::write_failed, path_, "the HDF5 library could not write it", "check the free space");
  }

  std::string path_;
  FileReplacement replacement_;
  Handle file_;
  std::vector<GrowingDataset> datasets_;       // q, residual_max, residual_rms
  std::array<std::vector<double>, 3> blocks_;  // of the same, not yet written
};

/// HDF5 prints no errors of its own: they become exceptions here.
void silence_hdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

}  // namespace

std::unique_ptr<TrajectoryReader> open_hdf5_trajectory(const std::string& path, std::uint64_t max_bytes) {
  check_hdf5_bounds(path, bounds(max_bytes));
  silence_hdf5();
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid())
    throw Error(ErrorCode::file_unreadable, path, "cannot be opened as HDF5", "check the path and what wrote the file");
  TrajectoryHeader header{.hand = read_hand(file.id()), .joint_names = read_names(file.id(), path)};
  return std::make_unique<Hdf5Reader>(path, std::move(file), std::move(header));
}

std::unique_ptr<TrajectoryWriter> create_hdf5_trajectory(const std::string& path, const TrajectoryHeader& header) {
  silence_hdf5();
  return std::make_unique<Hdf5Writer>(path, header);
}

}  // namespace uhas
