#include "uhas/files/file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include "uhas/base/errors.hpp"
#include "uhas/files/file_descriptor.hpp"
#include "uhas/files/file_replacement.hpp"

namespace uhas {

namespace {

Error unreadable(const std::string& path, const std::string& problem) {
  return {ErrorCode::file_unreadable, path, problem, "check the path and its permissions"};
}

}  // namespace

std::vector<std::byte> read_file(const std::string& path, std::uint64_t max_bytes, const std::string& remedy) {
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
                "has " + std::to_string(size) + " bytes, more than the bound of " + std::to_string(max_bytes), remedy);

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
  FileReplacement replacement(path);
  replacement.write(bytes);
  replacement.commit();
}

}  // namespace uhas
