#include "uhas/profile_io/write_profile.hpp"

#include "uhas/base/errors.hpp"
#include "uhas/files/file_bytes.hpp"
#include "uhas/profile_io/image/profile_image.hpp"

namespace uhas {

void write_profile(const HandProfile& profile, const std::string& path) {
  validate_profile(profile, path);
  const std::vector<std::byte> image = image_of_profile(profile, path);
  if (image.size() > kMaxProfileBytes)
    throw Error(ErrorCode::limit_exceeded, path, "the profile would have " + std::to_string(image.size()) + " bytes",
                "build it with fewer samples");
  replace_file(path, image);
}

}  // namespace uhas
