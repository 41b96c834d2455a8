#include "uhas/base/file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

std::string errno_text() { return std::generic_category().message(errno); }

Error unreadable(const std::string& path, const std::string& problem) {
  return {ErrorCode::file_unreadable, path, problem, "check the path and its permissions"};
}

Error write_failed(const std::string& path, const std::string& problem) {
  return {ErrorCode::write_failed, path, problem, "check the folder, its permissions and the free space"};
}

class FileDescriptor {
 public:
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

  /// Some file systems report a failed write only here.
  bool close() {
    const int number = number_;
    number_ = -1;
    return ::close(number) == 0;
  }

 private:
  int number_;
};

/// A new file beside the one to be replaced, removed unless it takes the other's place.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& folder)
      : path_(unused_path(folder)), file_(create(path_)), exists_(file_.is_open()) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (exists_) ::unlink(path_.c_str());
  }

  bool exists() const { return exists_; }

  bool write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file_.number(), bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }
  bool sync_and_close() { return ::fsync(file_.number()) == 0 && file_.close(); }
  bool rename_to(const std::filesystem::path& target) {
    exists_ = ::rename(path_.c_str(), target.c_str()) != 0;
    return !exists_;
  }

 private:
  static std::filesystem::path unused_path(const std::filesystem::path& folder) {
    static std::atomic<unsigned> counter = 0;
    std::filesystem::path path;
    do {
      path = folder / (".uhas-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
    } while (::access(path.c_str(), F_OK) == 0);
    return path;
  }
  static int create(const std::filesystem::path& path) {
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  }

  std::filesystem::path path_;
  FileDescriptor file_;
  bool exists_;
};

/// The path to replace: the target of a symbolic link, and never a device, pipe or folder.
std::filesystem::path replaceable_path(const std::string& path) {
  std::error_code error;
  std::filesystem::path target = path;
  if (std::filesystem::is_symlink(target, error)) target = std::filesystem::canonical(target, error);
  if (error && error != std::errc::no_such_file_or_directory) throw write_failed(path, error.message());
  if (target.empty()) throw write_failed(path, "the symbolic link leads nowhere");
  const std::filesystem::file_status status = std::filesystem::status(target, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw write_failed(path, "this is not a regular file");
  return target;
}

}  // namespace

std::vector<std::byte> read_file(const std::string& path, std::uint64_t max_bytes) {
  // without O_NONBLOCK, opening a pipe would wait for a writer
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open() && errno == ENOENT)
    throw Error(ErrorCode::file_unreadable, path, "the file does not exist", "check the path");
  if (!file.is_open()) throw unreadable(path, "cannot be opened: " + errno_text());
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) throw unreadable(path, "cannot be examined: " + errno_text());
  if (!S_ISREG(status.st_mode)) throw unreadable(path, "is not a regular file");
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > max_bytes)
    throw Error(ErrorCode::limit_exceeded, path,
                "has " + std::to_string(size) + " bytes, more than the bound of " + std::to_string(max_bytes),
                "make sure that it is the right file");

  std::vector<std::byte> bytes(size);
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = ::read(file.number(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw unreadable(path, "cannot be read: " + errno_text());
    if (got == 0) break;  // shortened meanwhile
    filled += static_cast<std::size_t>(got);
  }
  bytes.resize(filled);
  return bytes;
}

void replace_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::filesystem::path target = replaceable_path(path);
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");

  TemporaryFile temporary(folder);
  if (!temporary.exists()) throw write_failed(path, "no file can be made in its folder: " + errno_text());
  if (!temporary.write(bytes) || !temporary.sync_and_close())
    throw write_failed(path, "cannot be written: " + errno_text());
  if (!temporary.rename_to(target)) throw write_failed(path, "cannot be replaced: " + errno_text());

  // the rename itself lasts through a power failure only when the folder is synced; some file systems cannot (EINVAL)
  const FileDescriptor opened_folder(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened_folder.is_open() && ::fsync(opened_folder.number()) != 0 && errno != EINVAL)
    throw write_failed(path, "its folder cannot be synced: " + errno_text());
}

}  // namespace uhas
