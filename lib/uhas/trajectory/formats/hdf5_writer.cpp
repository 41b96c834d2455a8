#include "uhas/trajectory/formats/hdf5_writer.hpp"

#include <algorithm>
#include <array>

#include "uhas/base/errors.hpp"
#include "uhas/files/file_replacement.hpp"
#include "uhas/hdf5/handle.hpp"
#include "uhas/trajectory/trajectory_json.hpp"

namespace uhas {
namespace {

constexpr hsize_t kBlock = 1024;  // frames held in memory at a time

/// How datasets are made: without time stamps, so that the same frames give the same bytes.
Hdf5Handle dataset_creation() {
  Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.id(), false);
  return creation;
}

/// A dataset [frames] or [frames][columns] that grows by blocks.
class GrowingDataset {
 public:
  GrowingDataset(hid_t file, const char* name, hsize_t columns, bool is_matrix)
      : rank_(is_matrix ? 2 : 1), columns_(columns), dataset_(create(file, name)) {}

  bool append(const std::vector<double>& values) {
    const hsize_t start[] = {rows_, 0}, count[] = {values.size() / columns_, columns_};
    const hsize_t size[] = {rows_ + count[0], columns_};
    if (!dataset_.valid() || H5Dset_extent(dataset_.id(), size) < 0) return false;
    rows_ += count[0];
    const Hdf5Handle space(H5Dget_space(dataset_.id()), H5Sclose),
        memory(H5Screate_simple(rank_, count, nullptr), H5Sclose);
    return H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) >= 0 &&
           H5Dwrite(dataset_.id(), memory_type<double>(), memory.id(), space.id(), H5P_DEFAULT, values.data()) >= 0;
  }

 private:
  Hdf5Handle create(hid_t file, const char* name) const {
    const hsize_t none[] = {0, columns_}, unlimited[] = {H5S_UNLIMITED, columns_}, chunk[] = {kBlock, columns_};
    const Hdf5Handle space(H5Screate_simple(rank_, none, unlimited), H5Sclose);
    const Hdf5Handle creation = dataset_creation();
    H5Pset_chunk(creation.id(), rank_, chunk);
    const hid_t type = stored_type<double>();
    return {H5Dcreate2(file, name, type, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Dclose};
  }

  int rank_;
  hsize_t columns_, rows_ = 0;
  Hdf5Handle dataset_;
};

Hdf5Handle text_type(const std::string& text) { return string_type(std::max<std::size_t>(text.size(), 1)); }

bool write_attribute(hid_t file, const char* name, hid_t type, const void* value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(H5Acreate2(file, name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute.id(), type, value) >= 0;
}

bool write_names(hid_t file, const std::vector<std::string>& names) {
  std::size_t longest = 1;
  for (const std::string& name : names) longest = std::max(longest, name.size());
  std::string text;
  for (const std::string& name : names) text += name + std::string(longest - name.size(), '\0');
  const hsize_t count = names.size();
  const Hdf5Handle type = string_type(longest), space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle creation = dataset_creation();
  const Hdf5Handle dataset(
      H5Dcreate2(file, "joint_names", type.id(), space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Dclose);
  return dataset.valid() && H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()) >= 0;
}

/// Made within a session.
class Hdf5Writer : public TrajectoryWriter {
 public:
  Hdf5Writer(const std::string& path, const TrajectoryHeader& header)
      : path_(path),
        replacement_(path),
        file_(H5Fcreate(replacement_.temporary_path().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose) {
    datasets_.emplace_back(file_.id(), "q", header.joint_names.size(), true);
    datasets_.emplace_back(file_.id(), "residual_max", 1, false);
    datasets_.emplace_back(file_.id(), "residual_rms", 1, false);
    const std::int32_t version = kJsonVersion;
    require(file_.valid() &&
            write_attribute(file_.id(), "format", text_type(kTrajectoryFormat).id(), kTrajectoryFormat) &&
            write_attribute(file_.id(), "version", memory_type<std::int32_t>(), &version) &&
            write_attribute(file_.id(), "hand", text_type(header.hand).id(), header.hand.c_str()) &&
            write_names(file_.id(), header.joint_names));
  }

  void write(std::span<const double> q, const EncodeReport& report) override {
    blocks_[0].insert(blocks_[0].end(), q.begin(), q.end());
    blocks_[1].push_back(report.residual_max);
    blocks_[2].push_back(report.residual_rms);
    if (blocks_[1].size() < kBlock) return;
    const Hdf5Session session;
    empty_blocks();
  }
  void finish(const TrajectorySummary&) override {
    {
      const Hdf5Session session;
      empty_blocks();
      datasets_.clear();
      require(file_.close());
    }
    replacement_.commit();
  }
  ~Hdf5Writer() override {
    const Hdf5Session session;
    datasets_.clear();
    file_.close();
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
  Hdf5Handle file_;
  std::vector<GrowingDataset> datasets_;       // q, residual_max, residual_rms
  std::array<std::vector<double>, 3> blocks_;  // of the same, not yet written
};

}  // namespace

std::unique_ptr<TrajectoryWriter> create_hdf5_trajectory(const std::string& path, const TrajectoryHeader& header) {
  const Hdf5Session session;
  return std::make_unique<Hdf5Writer>(path, header);
}

}  // namespace uhas
