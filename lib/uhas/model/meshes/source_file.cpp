#include "uhas/model/meshes/source_file.hpp"

#include <algorithm>

#include "uhas/files/sha256.hpp"

namespace uhas {

void SourceLog::add(const std::filesystem::path& path, const std::string& reference, std::span<const std::byte> bytes) {
  namespace fs = std::filesystem;
  const auto full = [](const fs::path& any) { return (fs::current_path() / any).lexically_normal(); };
  const bool is_package = reference.starts_with("package://");
  const std::string name = is_package ? reference : full(path).lexically_relative(full(urdf_folder_)).generic_string();
  const auto known = [&](const LoggedFile& file) { return file.source.name == name; };
  if (std::ranges::none_of(files_, known)) files_.push_back({{name, sha256_hex(bytes)}, path.string()});
}

}  // namespace uhas
