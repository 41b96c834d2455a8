#include "command_line/file_guard.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "uhas/base/errors.hpp"

namespace uhas::tools {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kHeadBytes = 4096;  // tell what a file is

/// How a kind is called, and what begins its files or stands in their heads.
struct Signature {
  const char* name;
  std::vector<std::string_view> begins, holds;
};

const Signature& signature(FileKind kind) {
  static const std::array<Signature, 9> signatures{{
      {"hand profile", {"uhas-hand-profile"}, {}},
      {"hand config", {}, {"\"uhas-hand-config\""}},
      {"solution", {}, {"\"uhas-solution\""}},
      {"file of surface points", {}, {"\"uhas-surface-points\""}},
      {"trajectory", {}, {"\"uhas-trajectory\"", "joint_names"}},
      {"HTML page", {"<!doctype html", "<!DOCTYPE html", "<html"}, {}},
      {"binary glTF", {"glTF"}, {}},
      {"PLY file", {"ply\n"}, {}},
      {"SVG", {}, {"<svg"}},
  }};
  return signatures[static_cast<std::size_t>(kind)];
}

std::string head_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kHeadBytes, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool is_of_kind(const std::string& path, FileKind kind) {
  const std::string head = head_of(path);
  const auto& [name, begins, holds] = signature(kind);
  return std::ranges::any_of(begins, [&](std::string_view text) { return head.starts_with(text); }) ||
         std::ranges::any_of(holds, [&](std::string_view text) { return head.find(text) != std::string::npos; });
}

bool is_one_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) && fs::is_regular_file(a, ignored);
}

/// The first of `paths` that is the file `path`; empty when there is none.
std::string twin_of(const std::string& path, const std::vector<std::string>& paths) {
  const auto twin = std::ranges::find_if(paths, [&](const std::string& other) { return is_one_file(path, other); });
  return twin == paths.end() ? std::string() : *twin;
}

/// Also for root, whom no permission binds.
bool is_read_only(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return false;
  return (status.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0 || ::access(path.c_str(), W_OK) != 0;
}

Error refusal(const std::string& path, const std::string& problem, const std::string& remedy) {
  return {ErrorCode::write_failed, path, problem, remedy};
}

Error input_refusal(const std::string& output, const std::string& input) {
  return refusal(output, "would be written, but it is read too" + (input == output ? "" : ", as " + input),
                 "write to another file");
}

constexpr const char* kReplaceRemedy = "write to another file, or replace it with --force";

}  // namespace

void FileGuard::read(const std::string& path) {
  if (const std::string output = twin_of(path, outputs_); !output.empty()) throw input_refusal(output, path);
  inputs_.push_back(path);
}

void FileGuard::write(const std::string& path, FileKind kind) {
  if (const std::string input = twin_of(path, inputs_); !input.empty()) throw input_refusal(path, input);
  const auto same_place = [&](const std::string& other) {
    return fs::path(other).lexically_normal() == fs::path(path).lexically_normal() || is_one_file(other, path);
  };
  if (std::ranges::any_of(outputs_, same_place))
    throw refusal(path, "two results would be written to it", "give each a file of its own");
  outputs_.push_back(path);

  std::error_code ignored;
  if (forced_ || !fs::is_regular_file(path, ignored)) return;
  if (is_read_only(path)) throw refusal(path, "is read-only", kReplaceRemedy);
  if (fs::file_size(path, ignored) > 0 && !is_of_kind(path, kind))
    throw refusal(path, "exists and is no " + std::string(signature(kind).name), kReplaceRemedy);
}

void FileGuard::rewrite(const std::string& path) const {
  if (!forced_ && is_read_only(path))
    throw refusal(path, "is read-only", "make it writable, or replace it with --force");
}

}  // namespace uhas::tools
