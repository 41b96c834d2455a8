#include "common/output.hpp"

#include <iostream>
#include <span>

#include "uhas/profile_io/file_bytes_detail.hpp"

namespace uhas::tools {

void write_result(const std::string& path, const std::string& text) {
  if (path.empty() || path == "-")
    std::cout << text;
  else
    detail::replace_file(path, std::as_bytes(std::span(text)));
}

}  // namespace uhas::tools
