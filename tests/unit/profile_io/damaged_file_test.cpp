// Files that are no hand profile, or no longer: each is refused before HDF5 sees it.
#include <doctest/doctest.h>
#include <hdf5.h>
#include <sys/stat.h>

#include <filesystem>
#include <random>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_profile.hpp"
#include "uhas/profile_io/read_profile.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// The bytes of a good file, and a place to put bad ones.
struct Fixture {
  Fixture() : path(folder.file("hand.h5")) {
    write_profile(small_profile(), path);
    good = read_bytes(path);
  }
  void check_refusal(const std::string& bytes, ErrorCode code, const std::string& words) const {
    write_bytes(path, bytes);
    check_error(code, words, [&] { read_profile(path); });
  }

  ScratchFolder folder;
  std::string path;
  std::string good;
};

std::string with_first_line(std::string bytes, const std::string& from, const std::string& to) {
  return bytes.replace(bytes.find(from), from.size(), to);
}

}  // namespace

TEST_CASE_FIXTURE(Fixture, "the user block is three lines of text padded with zeros") {
  CHECK(good.starts_with("uhas-hand-profile 1.0\nlength " + std::to_string(good.size()) + "\nsha256 "));
  const std::size_t text_end = good.find('\0');
  CHECK(good[text_end - 1] == '\n');
  CHECK(good.substr(text_end, 512 - text_end) == std::string(512 - text_end, '\0'));
  CHECK(good.substr(512, 8) == "\x89HDF\r\n\x1a\n");
}

TEST_CASE_FIXTURE(Fixture, "a truncated file is refused") {
  for (std::size_t size = 97; size < good.size(); size += 97)
    check_refusal(good.substr(0, size), ErrorCode::invalid_profile, "truncated");
  check_refusal("", ErrorCode::invalid_profile, "empty");
}

TEST_CASE_FIXTURE(Fixture, "a file with appended bytes is refused") {
  check_refusal(good + '\0', ErrorCode::invalid_profile, "damaged");
}

TEST_CASE_FIXTURE(Fixture, "a flipped bit anywhere is refused") {
  std::mt19937 random(20240607);
  for (int repeat = 0; repeat < 1500; ++repeat) {
    std::string bytes = good;
    const std::size_t position = repeat < 512 ? static_cast<std::size_t>(repeat) : random() % good.size();
    bytes[position] = static_cast<char>(bytes[position] ^ (1 << random() % 8));
    CAPTURE(position);
    write_bytes(path, bytes);
    CHECK_THROWS_AS(read_profile(path), Error);
  }
}

TEST_CASE_FIXTURE(Fixture, "another major version is refused with both numbers") {
  for (const char* line : {"uhas-hand-profile 2.0\n", "uhas-hand-profile 0.9\n"})
    check_refusal(with_first_line(good, "uhas-hand-profile 1.0\n", line), ErrorCode::unsupported_version,
                  std::string("format version ") + std::string(line).substr(18, 3) + ", this reader knows version 1.0");
}

TEST_CASE_FIXTURE(Fixture, "a version changed in the user block alone is refused") {
  check_refusal(with_first_line(good, "uhas-hand-profile 1.0\n", "uhas-hand-profile 1.3\n"), ErrorCode::invalid_profile,
                "do not agree with the user block");
}

TEST_CASE_FIXTURE(Fixture, "other kinds of files are refused") {
  check_refusal("<robot name=\"hand\"/>\n", ErrorCode::invalid_profile, "not a hand profile");
  check_refusal(std::string(4096, '\0'), ErrorCode::invalid_profile, "not a hand profile");
  check_refusal(good.substr(512), ErrorCode::invalid_profile, "not a hand profile");  // HDF5 without a user block
}

TEST_CASE_FIXTURE(Fixture, "what is no readable regular file is refused") {
  check_error(ErrorCode::file_unreadable, "does not exist", [&] { read_profile(folder.file("missing.h5")); });
  check_error(ErrorCode::file_unreadable, "not a regular file", [&] { read_profile(folder.path().string()); });
  check_error(ErrorCode::file_unreadable, "not a regular file", [&] { read_profile("/dev/zero"); });

  REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  check_error(ErrorCode::file_unreadable, "not a regular file", [&] { read_profile(folder.file("pipe")); });

  std::filesystem::create_symlink("loop.h5", folder.file("loop.h5"));
  check_error(ErrorCode::file_unreadable, "cannot be opened", [&] { read_profile(folder.file("loop.h5")); });
}

TEST_CASE_FIXTURE(Fixture, "an untrusted file is read, or refused in the same words") {
  CHECK(read_untrusted_profile(path) == read_profile(path));
  write_bytes(path, good.substr(0, good.size() - 1));
  check_error(ErrorCode::invalid_profile, "the file is truncated", [&] { read_untrusted_profile(path); });
}

TEST_CASE_FIXTURE(Fixture, "a file over the size limit is refused unread") {
  std::filesystem::resize_file(path, (256ull << 20) + 1);  // sparse
  check_error(ErrorCode::limit_exceeded, "268435456", [&] { read_profile(path); });
}
