#include "uhas/profile_io/reseal_profile.hpp"

#include "uhas/files/file_bytes.hpp"
#include "uhas/profile_io/image/profile_error.hpp"
#include "uhas/profile_io/image/profile_image.hpp"

namespace uhas {

void reseal_profile(const std::string& path) {
  std::vector<std::byte> bytes = read_file(path, kMaxProfileBytes);
  const std::optional<FormatVersion> version = stated_version(bytes);
  if (!version || bytes.size() <= kUserBlockBytes)
    throw profile_error(path, "this is not a hand profile: it does not begin with 'uhas-hand-profile'",
                        "name a file that uhas-build-profile wrote");
  write_user_block(bytes, *version);
  check_user_block(bytes, path);  // of a version that this library reads
  profile_of_image(bytes, *version, path);
  replace_file(path, bytes);
}

}  // namespace uhas
