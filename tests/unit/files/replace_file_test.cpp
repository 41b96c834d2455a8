// Writing is all or nothing: on any failure the old file is untouched and nothing else stays behind.
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_profile.hpp"
#include "uhas/profile_io/read_profile.hpp"
#include "uhas/profile_io/write_profile.hpp"

using namespace uhas;
using namespace uhas::test;
namespace fs = std::filesystem;

namespace {

/// Lets no file of this process grow past `bytes`: a disk that is full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : previous_handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &previous_);
    const rlimit limit{bytes, previous_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &previous_);
    ::signal(SIGXFSZ, previous_handler_);
  }

 private:
  sighandler_t previous_handler_;
  rlimit previous_{};
};

void check_write_failure(const std::string& path, const std::string& words) {
  check_error(ErrorCode::write_failed, words, [&] { write_profile(small_profile(), path); });
}

}  // namespace

TEST_CASE("a full disk leaves the old file and nothing else") {
  const ScratchFolder folder;
  const std::string path = folder.file("hand.h5");
  write_bytes(path, "old");
  {
    const FileSizeLimit limit(4096);
    check_write_failure(path, "cannot be written: File too large");
  }
  CHECK(read_bytes(path) == "old");
  CHECK(folder.entry_count() == 1);
}

TEST_CASE("a good write replaces the old file") {
  const ScratchFolder folder;
  const std::string path = folder.file("hand.h5");
  write_bytes(path, "old");
  write_profile(small_profile(), path);
  CHECK(read_profile(path) == small_profile());
  CHECK(folder.entry_count() == 1);
}

TEST_CASE("a folder that takes no file is an error") {
  check_write_failure("/proc/hand.h5", "/proc/hand.h5: no file can be made in its folder");
  const ScratchFolder folder;
  check_write_failure(folder.file("missing/hand.h5"), "No such file or directory");
  write_bytes(folder.file("plain"), "");
  check_write_failure(folder.file("plain/hand.h5"), "Not a directory");
}

TEST_CASE("a read-only folder is an error") {
  if (::geteuid() == 0) {
    MESSAGE("SKIPPED: permissions do not bind root");
    return;
  }
  const ScratchFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  check_write_failure(folder.file("hand.h5"), "Permission denied");
  fs::permissions(folder.path(), fs::perms::owner_all);
  CHECK(folder.entry_count() == 0);
}

TEST_CASE("only a regular file is replaced") {
  const ScratchFolder folder;
  check_write_failure(folder.path().string(), "not a regular file");
  check_write_failure("/dev/null", "not a regular file");
  fs::create_symlink("/dev/null", folder.file("null"));
  check_write_failure(folder.file("null"), "not a regular file");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a symbolic link is followed") {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "profiles");
  write_bytes(folder.file("profiles/hand.h5"), "old");
  fs::create_symlink("profiles/hand.h5", folder.file("link.h5"));
  write_profile(small_profile(), folder.file("link.h5"));
  CHECK(fs::is_symlink(folder.file("link.h5")));
  CHECK(read_profile(folder.file("profiles/hand.h5")) == small_profile());

  fs::create_symlink("loop.h5", folder.file("loop.h5"));
  check_write_failure(folder.file("loop.h5"), "loop.h5: ");
  fs::create_symlink("nowhere/hand.h5", folder.file("dangling.h5"));
  check_write_failure(folder.file("dangling.h5"), "dangling.h5: ");
}

TEST_CASE("names that others have taken are passed over, however they came to be") {
  const ScratchFolder folder;
  const std::string taken = folder.file(".uhas-" + std::to_string(::getpid()) + "-");
  constexpr int names = 500;  // more than this process has used up
  for (int i = 0; i < names; ++i) {
    const std::string name = taken + std::to_string(i) + ".tmp";
    if (i % 2 == 0)
      fs::create_symlink("nowhere", name);  // which access(2) takes for a free name and open(2) does not
    else
      write_bytes(name, "another process");
  }
  const std::string path = folder.file("hand.h5");
  write_profile(small_profile(), path);
  CHECK(read_profile(path) == small_profile());
  CHECK(folder.entry_count() == names + 1);
  for (int i = 1; i < names; i += 2) CHECK(read_bytes(taken + std::to_string(i) + ".tmp") == "another process");
}
