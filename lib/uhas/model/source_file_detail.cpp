#include "uhas/model/source_file_detail.hpp"

#include <algorithm>
#include <fstream>

#include "uhas/base/errors.hpp"
#include "uhas/base/sha256.hpp"

namespace uhas::detail {

FileBytes read_file(const std::filesystem::path& path, std::uint64_t max_bytes) {
  std::error_code failure;
  const auto status = std::filesystem::status(path, failure);
  if (status.type() == std::filesystem::file_type::not_found)
    throw Error(ErrorCode::file_unreadable, path, "the file does not exist", "check the path");
  if (status.type() != std::filesystem::file_type::regular)
    throw Error(ErrorCode::file_unreadable, path,
                failure ? "the file cannot be reached (" + failure.message() + ")" : "this is not a regular file",
                "name a readable file");

  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = stream ? static_cast<std::streamoff>(stream.tellg()) : -1;
  if (size < 0) throw Error(ErrorCode::file_unreadable, path, "the file cannot be opened", "check its permissions");
  if (static_cast<std::uint64_t>(size) > max_bytes)
    throw Error(ErrorCode::limit_exceeded, path,
                "the file has " + std::to_string(size) + " bytes, more than the bound of " + std::to_string(max_bytes),
                "simplify it or raise the bound");

  FileBytes bytes(static_cast<std::size_t>(size));
  stream.seekg(0);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), size))
    throw Error(ErrorCode::file_unreadable, path, "the file cannot be read to its end", "check the disk");
  return bytes;
}

void SourceLog::add(const std::filesystem::path& path, const std::string& reference, std::span<const std::byte> bytes) {
  namespace fs = std::filesystem;
  const auto full = [](const fs::path& any) { return (fs::current_path() / any).lexically_normal(); };
  const bool is_package = reference.starts_with("package://");
  const std::string name = is_package ? reference : full(path).lexically_relative(full(urdf_folder_)).generic_string();
  if (std::ranges::find(files_, name, &SourceFile::name) == files_.end()) files_.push_back({name, sha256_hex(bytes)});
}

}  // namespace uhas::detail
