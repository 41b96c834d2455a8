#include "uhas/files/file_replacement.hpp"

#include <fcntl.h>

#include <atomic>
#include <filesystem>

#include "uhas/base/errors.hpp"
#include "uhas/files/file_descriptor.hpp"

namespace uhas {

namespace {

Error write_failed(const std::string& path, const std::string& problem) {
  return {ErrorCode::write_failed, path, problem, "check the folder, its permissions and the free space"};
}

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

std::string folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path().string() : ".";
}

/// Opens a new file in `folder` for writing; its name goes to `path`. The name is free when the file can be made:
/// processes of several containers may share a folder, and a number.
int open_new_file(const std::string& folder, std::string& path) {
  static std::atomic<unsigned> counter = 0;
  int file = -1;
  do {
    path = folder + "/.uhas-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp";
    file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (file < 0 && errno == EEXIST);
  return file;
}

}  // namespace

struct FileReplacement::State {
  explicit State(const std::string& named)
      : path(named),
        target(replaceable_path(named)),
        folder(folder_of(target)),
        file(open_new_file(folder, temporary)) {}

  std::string path;  // as the caller names it
  std::filesystem::path target;
  std::string folder, temporary;
  FileDescriptor file;
  bool committed = false;
};

FileReplacement::FileReplacement(const std::string& path) : state_(std::make_unique<State>(path)) {
  if (!state_->file.is_open()) throw write_failed(path, "no file can be made in its folder: " + errno_text());
}

FileReplacement::~FileReplacement() {
  if (!state_->committed) ::unlink(state_->temporary.c_str());
}

const std::string& FileReplacement::temporary_path() const noexcept { return state_->temporary; }

void FileReplacement::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(state_->file.number(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw write_failed(state_->path, "cannot be written: " + errno_text());
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void FileReplacement::commit() {
  State& state = *state_;
  if (::fsync(state.file.number()) != 0 || !state.file.close())
    throw write_failed(state.path, "cannot be written: " + errno_text());
  state.committed = ::rename(state.temporary.c_str(), state.target.c_str()) == 0;
  if (!state.committed) throw write_failed(state.path, "cannot be replaced: " + errno_text());

  // the rename itself lasts through a power failure only when the folder is synced; some file systems cannot (EINVAL)
  const FileDescriptor opened_folder(::open(state.folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened_folder.is_open() && ::fsync(opened_folder.number()) != 0 && errno != EINVAL)
    throw write_failed(state.path, "its folder cannot be synced: " + errno_text());
}

}  // namespace uhas
