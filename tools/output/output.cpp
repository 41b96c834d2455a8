#include "output/output.hpp"

#include <iostream>
#include <span>

#include "uhas/files/file_bytes.hpp"

namespace uhas::tools {

void write_result(const std::string& path, const std::string& text) {
  if (path.empty() || path == "-")
    std::cout << text;
  else
    replace_file(path, std::as_bytes(std::span(text)));
}

}  // namespace uhas::tools
