#include "uhas/profile_io/read_profile.hpp"

#include "uhas/fence/child_process.hpp"
#include "uhas/files/file_bytes.hpp"
#include "uhas/profile_io/flat_profile.hpp"
#include "uhas/profile_io/image/profile_image.hpp"
#include "uhas/profile_io/image/user_block.hpp"

namespace uhas {

HandProfile read_profile(const std::string& path) {
  const std::vector<std::byte> bytes = read_file(path, kMaxProfileBytes);
  const FormatVersion version = check_user_block(bytes, path);
  return profile_of_image(bytes, version, path);
}

HandProfile read_untrusted_profile(const std::string& path, const ChildLimits& limits) {
  return unflatten_profile(
      in_child(limits, ErrorCode::invalid_profile, path, [&] { return flatten_profile(read_profile(path)); }));
}

}  // namespace uhas
