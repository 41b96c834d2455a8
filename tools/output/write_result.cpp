#include "output/write_result.hpp"

#include <iostream>
#include <span>

#include "uhas/files/file_bytes.hpp"

namespace uhas::tools {

void write_file(const std::string& path, const std::string& text) {
  replace_file(path, std::as_bytes(std::span(text)));
}

void write_result(const std::string& path, const std::string& text) {
  if (path.empty() || path == "-")
    std::cout << text;
  else
    write_file(path, text);
}

}  // namespace uhas::tools
