// A profile comes back as it went, and goes the same way twice.
#include <doctest/doctest.h>

#include <limits>
#include <thread>
#include <vector>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_profile.hpp"
#include "uhas/profile_io/read_profile.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;
using namespace uhas::test;

TEST_CASE("every field of a profile survives the file") {
  const ScratchFolder folder;
  const HandProfile written = small_profile();
  write_profile(written, folder.file("hand.h5"));
  CHECK(read_profile(folder.file("hand.h5")) == written);
  CHECK(folder.entry_count() == 1);
}

TEST_CASE("empty tables and texts survive the file") {
  const ScratchFolder folder;
  HandProfile written = small_profile();
  written.fingers[0].lateral_table = -1;
  written.lateral_tables.clear();
  written.correspondences.clear();
  written.findings.clear();
  written.warnings.clear();
  written.other_joints.clear();
  written.sources.clear();
  written.settings_json.clear();
  write_profile(written, folder.file("hand.h5"));
  CHECK(read_profile(folder.file("hand.h5")) == written);
}

TEST_CASE("a profile of a real hand's size survives the file") {
  const ScratchFolder folder;
  HandProfile written = small_profile();
  const Correspondence last = written.correspondences.back();
  for (int i = 0; i < 100'000; ++i) {
    written.correspondences.push_back(last);
    written.correspondences.back().rho = 0.5 + 1e-5 * i;
  }
  written.settings_json.assign(100'000, 'x');
  write_profile(written, folder.file("hand.h5"));
  CHECK(read_profile(folder.file("hand.h5")) == written);
}

TEST_CASE("the same profile gives the same bytes") {
  const ScratchFolder folder;
  write_profile(small_profile(), folder.file("one.h5"));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's time stamps count seconds
  write_profile(small_profile(), folder.file("two.h5"));
  const std::string bytes = read_bytes(folder.file("one.h5"));
  CHECK(bytes.size() > 512);
  CHECK(bytes == read_bytes(folder.file("two.h5")));
  write_profile(read_profile(folder.file("one.h5")), folder.file("three.h5"));
  CHECK(bytes == read_bytes(folder.file("three.h5")));
}

TEST_CASE("a path with spaces and UTF-8 works") {
  const ScratchFolder folder;
  const std::string path = folder.file("linke Hand – Größe 2.h5");
  write_profile(small_profile(), path);
  CHECK(read_profile(path).hand == "small hand");
}

TEST_CASE("threads may read and write at the same time") {
  const ScratchFolder folder;
  const HandProfile profile = small_profile();
  std::vector<int> agreed(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < agreed.size(); ++i)
      threads.emplace_back([&, i] {
        const std::string path = folder.file(std::to_string(i) + ".h5");
        for (int repeat = 0; repeat < 10; ++repeat) {
          write_profile(profile, path);
          agreed[i] += read_profile(path) == profile;
        }
      });
  }
  CHECK(agreed == std::vector<int>(4, 10));
}

TEST_CASE("what the reader would refuse is not written") {
  const ScratchFolder folder;
  HandProfile invalid = small_profile();
  invalid.radius = std::numeric_limits<double>::quiet_NaN();
  check_error(ErrorCode::invalid_profile, "sphere/radius", [&] { write_profile(invalid, folder.file("hand.h5")); });

  HandProfile huge = small_profile();
  huge.correspondences.resize((1u << 20) + 1, huge.correspondences.back());
  check_error(ErrorCode::limit_exceeded, "correspondences/", [&] { write_profile(huge, folder.file("hand.h5")); });
  CHECK(folder.entry_count() == 0);
}
