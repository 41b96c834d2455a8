// Files whose user block is right and whose content is not: edited with HDF5 itself, then sealed.
#include <doctest/doctest.h>
#include <hdf5.h>

#include <functional>
#include <span>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_profile.hpp"
#include "uhas/profile_io/image/user_block.hpp"
#include "uhas/profile_io/read_profile.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

constexpr std::array<hsize_t, 1> twelve{12};

struct Fixture {
  Fixture() : path(folder.file("hand.h5")) { write_profile(small_profile(), path); }

  void edit(const std::function<void(hid_t)>& change, FormatVersion version = {1, 0}) const {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(file >= 0);
    change(file);
    REQUIRE(H5Fclose(file) >= 0);
    std::string bytes = read_bytes(path);
    write_user_block(std::as_writable_bytes(std::span(bytes)), version);
    write_bytes(path, bytes);
  }
  void check_refusal(const std::string& words, ErrorCode code = ErrorCode::invalid_profile) const {
    check_error(code, words, [&] { read_profile(path); });
  }

  ScratchFolder folder;
  std::string path;
};

/// Puts an unwritten dataset in the place of another; `creation` is consumed.
void replace_dataset(hid_t file, const char* name, hid_t type, std::span<const hsize_t> shape,
                     hid_t creation = H5Pcreate(H5P_DATASET_CREATE)) {
  if (H5Lexists(file, name, H5P_DEFAULT) > 0) H5Ldelete(file, name, H5P_DEFAULT);
  const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name, type, space, H5P_DEFAULT, creation, H5P_DEFAULT);
  REQUIRE(dataset >= 0);
  H5Dclose(dataset);
  H5Sclose(space);
  H5Pclose(creation);
}

template <class Number>
void write_numbers(hid_t file, const char* name, hid_t memory_type, const std::vector<Number>& numbers) {
  const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
  REQUIRE(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) >= 0);
  H5Dclose(dataset);
}

hid_t variable_length_string() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  return type;
}

hid_t chunked(std::vector<hsize_t> chunk) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
  return creation;
}

}  // namespace

TEST_CASE_FIXTURE(Fixture, "a sealed edit within the format is accepted") {
  edit([](hid_t file) { write_numbers(file, "sphere/radius", H5T_NATIVE_DOUBLE, std::vector{0.5}); });
  CHECK(read_profile(path).radius == 0.5);
}

TEST_CASE_FIXTURE(Fixture, "deflated datasets are accepted") {
  edit([](hid_t file) {
    const hid_t creation = chunked({5});
    H5Pset_deflate(creation, 6);
    replace_dataset(file, "correspondences/weight", H5T_IEEE_F64LE, twelve, creation);
    write_numbers(file, "correspondences/weight", H5T_NATIVE_DOUBLE, std::vector<double>(12, 0.25));
  });
  CHECK(read_profile(path).correspondences[11].weight == 0.25);
}

TEST_CASE_FIXTURE(Fixture, "a newer minor version with unknown datasets is accepted") {
  const HandProfile written = read_profile(path);
  edit(
      [](hid_t file) {
        H5Gclose(H5Gcreate2(file, "novelties", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        replace_dataset(file, "novelties/colour", H5T_IEEE_F32LE, twelve);
        replace_dataset(file, "joints/stiffness", H5T_IEEE_F64LE, twelve);
        const hid_t attribute = H5Aopen(file, "version", H5P_DEFAULT);
        const int version[2] = {1, 7};
        H5Awrite(attribute, H5T_NATIVE_INT, version);
        H5Aclose(attribute);
      },
      {1, 7});
  CHECK(read_profile(path) == written);
}

TEST_CASE_FIXTURE(Fixture, "an inconsistent profile is refused by the name of the field") {
  edit([](hid_t file) { write_numbers(file, "sphere/radius", H5T_NATIVE_DOUBLE, std::vector{-1.0}); });
  check_refusal("sphere/radius is outside");
}

TEST_CASE_FIXTURE(Fixture, "a missing dataset is refused") {
  edit([](hid_t file) { H5Ldelete(file, "joints/axis", H5P_DEFAULT); });
  check_refusal("joints/axis is missing");
}

TEST_CASE_FIXTURE(Fixture, "a group in a dataset's place is refused") {
  edit([](hid_t file) {
    H5Ldelete(file, "joints/axis", H5P_DEFAULT);
    H5Gclose(H5Gcreate2(file, "joints/axis", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  });
  check_refusal("joints/axis is missing or is no dataset");
}

TEST_CASE_FIXTURE(Fixture, "another shape is refused") {
  edit([](hid_t file) { replace_dataset(file, "joints/axis", H5T_IEEE_F64LE, std::array<hsize_t, 2>{5, 4}); });
  check_refusal("joints/axis has shape [5, 4], not [5, 3]");
}

TEST_CASE_FIXTURE(Fixture, "a single value in a table's place is refused") {
  edit([](hid_t file) { replace_dataset(file, "correspondences/link", H5T_STD_I32LE, {}); });
  check_refusal("correspondences/link has no rows");
}

TEST_CASE_FIXTURE(Fixture, "another number type is refused") {
  edit([](hid_t file) { replace_dataset(file, "correspondences/rho", H5T_IEEE_F32LE, twelve); });
  check_refusal("correspondences/rho does not have the number type");
}

TEST_CASE_FIXTURE(Fixture, "numbers in a text's place are refused") {
  edit([](hid_t file) { replace_dataset(file, "joints/name", H5T_STD_I32LE, std::array<hsize_t, 1>{5}); });
  check_refusal("joints/name is not of fixed-length strings");
}

TEST_CASE_FIXTURE(Fixture, "a truth value other than 0 and 1 is refused") {
  edit([](hid_t file) { write_numbers(file, "hand/mirrored", H5T_NATIVE_INT, std::vector{2}); });
  check_refusal("hand/mirrored holds a value");
}

TEST_CASE_FIXTURE(Fixture, "a matrix that is not homogeneous is refused") {
  edit([](hid_t file) { write_numbers(file, "sphere/T_palm_sphere", H5T_NATIVE_DOUBLE, std::vector<double>(16, 1)); });
  check_refusal("sphere/T_palm_sphere holds a value");
}

TEST_CASE_FIXTURE(Fixture, "offsets that run backwards or past the end are refused") {
  edit([](hid_t file) { write_numbers(file, "fingers/joints_offsets", H5T_NATIVE_INT, std::vector{0, 6, 5}); });
  check_refusal("fingers/joints_offsets does not start at 0 and increase");
  edit([](hid_t file) { write_numbers(file, "fingers/joints_offsets", H5T_NATIVE_INT, std::vector{0, 3, 6}); });
  check_refusal("fingers/joints has shape [5], not [6]");
}

TEST_CASE_FIXTURE(Fixture, "dimensions that would allocate gigabytes are refused") {
  SUBCASE("rows") {
    edit([](hid_t file) {
      replace_dataset(file, "correspondences/link", H5T_STD_I32LE, std::array<hsize_t, 1>{hsize_t{1} << 40});
    });
  }
  SUBCASE("columns") {
    edit([](hid_t file) {
      replace_dataset(file, "correspondences/p_link", H5T_IEEE_F64LE, std::array<hsize_t, 2>{12, hsize_t{1} << 40});
    });
  }
  SUBCASE("a product that overflows") {
    edit([](hid_t file) {
      replace_dataset(file, "novelty", H5T_STD_U8LE, std::array<hsize_t, 4>{16, 1u << 20, 1u << 20, 1u << 16},
                      chunked({1, 1, 1, 1}));
    });
  }
  SUBCASE("strings") {
    edit([](hid_t file) {
      const hid_t type = H5Tcopy(H5T_C_S1);
      H5Tset_size(type, std::size_t{1} << 30);
      replace_dataset(file, "joints/name", type, std::array<hsize_t, 1>{5});
      H5Tclose(type);
    });
  }
  SUBCASE("a chunk") {
    edit([](hid_t file) {
      const hid_t creation = chunked({hsize_t{1} << 28});
      const hsize_t rows = 12, no_end = H5S_UNLIMITED;
      const hid_t space = H5Screate_simple(1, &rows, &no_end);
      H5Dclose(H5Dcreate2(file, "novelty", H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT));
      H5Sclose(space);
      H5Pclose(creation);
    });
  }
  check_refusal("a hand profile can", ErrorCode::limit_exceeded);
}

TEST_CASE_FIXTURE(Fixture, "many datasets that add up to gigabytes are refused") {
  edit([](hid_t file) {
    for (int i = 0; i < 40; ++i)
      replace_dataset(file, ("novelty" + std::to_string(i)).c_str(), H5T_IEEE_F64LE, std::array<hsize_t, 1>{1u << 20});
  });
  check_refusal("larger than a hand profile can be", ErrorCode::limit_exceeded);
}

TEST_CASE_FIXTURE(Fixture, "too many objects are refused") {
  edit([](hid_t file) {
    for (int i = 0; i < 2100; ++i)
      H5Gclose(H5Gcreate2(file, ("g" + std::to_string(i)).c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  });
  check_refusal("one object more", ErrorCode::limit_exceeded);
}

TEST_CASE_FIXTURE(Fixture, "groups in a circle are refused") {
  edit([](hid_t file) { H5Lcreate_hard(file, "/", file, "joints/root", H5P_DEFAULT, H5P_DEFAULT); });
  check_refusal("nested too deep");
}

TEST_CASE_FIXTURE(Fixture, "links out of the file are refused") {
  edit([](hid_t file) { H5Lcreate_external("/etc/passwd", "/x", file, "joints/extra", H5P_DEFAULT, H5P_DEFAULT); });
  check_refusal("/joints/extra is a soft, external or user-defined link");
}

TEST_CASE_FIXTURE(Fixture, "soft links are refused") {
  edit([](hid_t file) { H5Lcreate_soft("/joints", file, "gelenke", H5P_DEFAULT, H5P_DEFAULT); });
  check_refusal("/gelenke is a soft, external or user-defined link");
}

TEST_CASE_FIXTURE(Fixture, "values kept in other files are refused") {
  SUBCASE("external storage") {
    edit([](hid_t file) {
      const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
      H5Pset_external(creation, "/etc/passwd", 0, 12 * sizeof(double));
      replace_dataset(file, "correspondences/rho", H5T_IEEE_F64LE, twelve, creation);
    });
  }
  SUBCASE("virtual dataset") {
    edit([](hid_t file) {
      const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
      const hid_t space = H5Screate_simple(1, twelve.data(), nullptr);
      H5Pset_virtual(creation, space, "/etc/passwd", "/x", space);
      H5Sclose(space);
      replace_dataset(file, "correspondences/rho", H5T_IEEE_F64LE, twelve, creation);
    });
  }
  check_refusal("/correspondences/rho is stored in other files");
}

TEST_CASE_FIXTURE(Fixture, "filters other than deflate are refused") {
  edit([](hid_t file) {
    const hid_t creation = chunked({12});
    H5Pset_shuffle(creation);
    replace_dataset(file, "correspondences/rho", H5T_IEEE_F64LE, twelve, creation);
  });
  check_refusal("/correspondences/rho is packed by a filter");
}

TEST_CASE_FIXTURE(Fixture, "variable-length types are refused") {
  SUBCASE("in a dataset") {
    edit([](hid_t file) {
      const hid_t type = variable_length_string();
      replace_dataset(file, "joints/name", type, std::array<hsize_t, 1>{5});
      H5Tclose(type);
    });
    check_refusal("/joints/name is neither of numbers nor of fixed-length strings");
  }
  SUBCASE("in an attribute") {
    edit([](hid_t file) {
      const hid_t type = variable_length_string();
      const hid_t space = H5Screate(H5S_SCALAR);
      const hid_t object = H5Oopen(file, "joints", H5P_DEFAULT);
      H5Aclose(H5Acreate2(object, "note", type, space, H5P_DEFAULT, H5P_DEFAULT));
      H5Oclose(object);
      H5Sclose(space);
      H5Tclose(type);
    });
    check_refusal("an attribute of /joints is neither of numbers nor of fixed-length strings");
  }
}

TEST_CASE_FIXTURE(Fixture, "types and spaces without a plain value are refused") {
  SUBCASE("compound") {
    edit([](hid_t file) {
      const hid_t type = H5Tcreate(H5T_COMPOUND, 8);
      H5Tinsert(type, "x", 0, H5T_IEEE_F64LE);
      replace_dataset(file, "novelty", type, twelve);
      H5Tclose(type);
    });
    check_refusal("/novelty is neither of numbers");
  }
  SUBCASE("committed type") {
    edit([](hid_t file) {
      const hid_t type = H5Tcopy(H5T_IEEE_F64LE);
      H5Tcommit2(file, "novelty", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      H5Tclose(type);
    });
    check_refusal("/novelty is neither a group nor a dataset");
  }
  SUBCASE("null space") {
    edit([](hid_t file) {
      const hid_t space = H5Screate(H5S_NULL);
      H5Dclose(H5Dcreate2(file, "novelty", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      H5Sclose(space);
    });
    check_refusal("/novelty has no values");
  }
}

TEST_CASE_FIXTURE(Fixture, "a sealed file of another format is refused") {
  SUBCASE("without the root attributes") {
    edit([](hid_t file) { H5Adelete(file, "format"); });
  }
  SUBCASE("with another version in the root") {
    edit([](hid_t) {}, {1, 1});
  }
  check_refusal("do not agree with the user block");
}

TEST_CASE_FIXTURE(Fixture, "a right user block before something else is refused") {
  std::string bytes(4096, 'x');
  write_user_block(std::as_writable_bytes(std::span(bytes)), {1, 0});
  write_bytes(path, bytes);
  check_refusal("the content is not HDF5");
}
