#include "uhas/trajectory/formats/hdf5_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "uhas/base/errors.hpp"
#include "uhas/hdf5/bounds.hpp"
#include "uhas/hdf5/handle.hpp"

namespace uhas {
namespace {

constexpr hsize_t kBlock = 1024;  // frames held in memory at a time
constexpr hsize_t kMaxJoints = 1000;
constexpr std::size_t kMaxNameBytes = 1000;

// What h5py and MATLAB write of a trajectory, and no more.
Hdf5Bounds bounds(std::uint64_t max_bytes) {
  return {.kind = "a trajectory",
          .refusal = ErrorCode::syntax,
          .refusal_remedy = "store plain numbers and names",
          .bound_remedy = "cut it into parts or raise TrajectoryLimits::max_hdf5_bytes",
          .max_rows = max_bytes,  // a row has a byte at least
          .max_bytes = max_bytes,
          .allow_variable_text = true,
          .allow_shuffle = true};
}

Error wrong(const std::string& path, const std::string& problem, const std::string& remedy) {
  return {ErrorCode::syntax, path, problem, remedy};
}

std::vector<hsize_t> extents_of(hid_t dataset) {
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  std::vector<hsize_t> extents(std::max(rank, 0));
  H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr);
  return extents;
}

/// `count` texts of variable length; nothing when they cannot be read.
std::optional<std::vector<std::string>> read_variable_texts(hid_t dataset, hid_t type, std::size_t count) {
  std::vector<char*> texts(count, nullptr);
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) < 0) return std::nullopt;
  std::vector<std::string> result;
  for (const char* text : texts) result.emplace_back(text == nullptr ? "" : text);
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  H5Dvlen_reclaim(type, space.id(), H5P_DEFAULT, texts.data());
  return result;
}

/// `count` texts of fixed length without their padding; nothing when they cannot be read.
std::optional<std::vector<std::string>> read_fixed_texts(hid_t dataset, hid_t type, std::size_t count) {
  const std::size_t length = H5Tget_size(type);
  std::vector<char> text(count * length);
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) < 0) return std::nullopt;
  std::vector<std::string> result;
  for (std::size_t i = 0; i < count; ++i) {
    std::string& name = result.emplace_back(text.data() + i * length, length);
    name.erase(std::min(name.find('\0'), name.find_last_not_of(' ') + 1));
  }
  return result;
}

std::vector<std::string> read_names(hid_t file, const std::string& path) {
  const Hdf5Handle dataset(H5Dopen2(file, "joint_names", H5P_DEFAULT), H5Dclose);
  const Hdf5Handle type(dataset.valid() ? H5Dget_type(dataset.id()) : H5I_INVALID_HID, H5Tclose);
  if (!type.valid() || H5Tget_class(type.id()) != H5T_STRING || extents_of(dataset.id()).size() != 1)
    throw wrong(path, "has no dataset joint_names, a list of names",
                "store the names in the order of the columns of q");
  const std::size_t count = extents_of(dataset.id())[0];
  const bool is_variable = H5Tis_variable_str(type.id()) > 0;
  if (count > kMaxJoints || (!is_variable && H5Tget_size(type.id()) > kMaxNameBytes))
    throw Error(ErrorCode::limit_exceeded, path, "joint_names holds more or longer names than a hand has",
                "name the joints of one hand");
  const auto read = is_variable ? read_variable_texts : read_fixed_texts;
  std::optional<std::vector<std::string>> names = read(dataset.id(), type.id(), count);
  if (!names) throw wrong(path, "joint_names cannot be read", "store it as text");
  return *std::move(names);
}

/// The root attribute `hand`, text of fixed or variable length; empty when there is none.
std::string read_hand(hid_t file) {
  if (H5Aexists(file, "hand") <= 0) return "";
  const Hdf5Handle attribute(H5Aopen(file, "hand", H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose), space(H5Aget_space(attribute.id()), H5Sclose);
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

/// Made within a session.
class Hdf5Reader : public TrajectoryReader {
 public:
  Hdf5Reader(std::string path, Hdf5Handle file, TrajectoryHeader header)
      : TrajectoryReader(std::move(header)),
        path_(std::move(path)),
        file_(std::move(file)),
        q_(H5Dopen2(file_.id(), "q", H5P_DEFAULT), H5Dclose) {
    const Hdf5Handle type(q_.valid() ? H5Dget_type(q_.id()) : H5I_INVALID_HID, H5Tclose);
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
  ~Hdf5Reader() override {
    const Hdf5Session session;
    q_.close();
    file_.close();
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
    const Hdf5Session session;
    const Hdf5Handle space(H5Dget_space(q_.id()), H5Sclose), memory(H5Screate_simple(2, count, nullptr), H5Sclose);
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0 ||
        H5Dread(q_.id(), memory_type<double>(), memory.id(), space.id(), H5P_DEFAULT, block_.data()) < 0)
      throw wrong(path_, "q cannot be read from frame " + std::to_string(next_), "make sure that the file is whole");
  }

  std::string path_;
  Hdf5Handle file_, q_;
  hsize_t frames_ = 0, next_ = 0;
  std::vector<double> block_;  // [up to kBlock][joints]
};

}  // namespace

std::unique_ptr<TrajectoryReader> open_hdf5_trajectory(const std::string& path, std::uint64_t max_bytes) {
  check_hdf5_bounds(path, bounds(max_bytes));
  const Hdf5Session session;
  Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file.valid())
    throw Error(ErrorCode::file_unreadable, path, "cannot be opened as HDF5", "check the path and what wrote the file");
  TrajectoryHeader header{.hand = read_hand(file.id()), .joint_names = read_names(file.id(), path)};
  return std::make_unique<Hdf5Reader>(path, std::move(file), std::move(header));
}

}  // namespace uhas
