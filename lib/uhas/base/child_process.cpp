#include "uhas/base/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <new>
#include <optional>
#include <span>

#include "uhas/base/file_descriptor_detail.hpp"

namespace uhas {
namespace {

using detail::errno_text;
using detail::FileDescriptor;
using Clock = std::chrono::steady_clock;

// The first byte of what the child writes: the bytes of the result follow, or the number of an ErrorCode and what()
// says.
enum class Answer : char { result, error };

std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void bound(int resource, rlim_t most) {
  rlimit limit{};
  ::getrlimit(static_cast<__rlimit_resource>(resource), &limit);
  limit.rlim_cur = limit.rlim_max = std::min(most, limit.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

// False when nobody listens any more.
bool write_all(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

void answer(int file, Answer kind, std::span<const std::byte> bytes) {
  if (write_all(file, std::as_bytes(std::span(&kind, 1)))) write_all(file, bytes);
}

void answer_error(int file, ErrorCode code, const std::string& text) {
  std::vector<std::byte> bytes(sizeof code + text.size());
  std::memcpy(bytes.data(), &code, sizeof code);
  std::memcpy(bytes.data() + sizeof code, text.data(), text.size());
  answer(file, Answer::error, bytes);
}

[[noreturn]] void be_the_child(const ChildLimits& limits, ErrorCode blame, int out,
                               const std::function<std::vector<std::byte>()>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // an interrupted tool leaves no child behind
  bound(RLIMIT_AS, address_space() + limits.max_memory_bytes);
  bound(RLIMIT_CORE, 0);
  bound(RLIMIT_FSIZE, 0);
  try {
    answer(out, Answer::result, work());
  } catch (const Error& error) {
    answer_error(out, error.code(), error.what());
  } catch (const std::bad_alloc&) {
    answer_error(out, ErrorCode::limit_exceeded, "");  // the parent has the words, and the memory for them
  } catch (const std::exception& error) {
    answer_error(out, blame, error.what());
  }
  ::_exit(0);  // nothing of the parent's is flushed or destroyed twice
}

// What the child writes until it ends; nothing when that takes too long or is too much.
std::optional<std::vector<std::byte>> read_until_end(int file, const ChildLimits& limits) {
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.max_seconds));
  std::vector<std::byte> bytes;
  std::array<std::byte, 1u << 16> block;
  while (bytes.size() <= limits.max_memory_bytes) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return std::nullopt;
    pollfd ready{.fd = file, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, static_cast<int>(std::min<long long>(left, 1'000'000))) <= 0) continue;
    const ssize_t got = ::read(file, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return bytes;
    bytes.insert(bytes.end(), block.begin(), block.begin() + got);
  }
  return std::nullopt;
}

int status_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

constexpr const char* kDoNotTrust = "do not trust the file";

Error too_much(const ChildLimits& limits, const std::string& file) {
  return {ErrorCode::limit_exceeded, file,
          "cannot be read within " + std::to_string(static_cast<int>(limits.max_seconds)) + " s and " +
              std::to_string(limits.max_memory_bytes >> 20) + " MiB of memory",
          kDoNotTrust};
}

}  // namespace

std::vector<std::byte> in_child(const ChildLimits& limits, ErrorCode blame, const std::string& file,
                                const std::function<std::vector<std::byte>()>& work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(ErrorCode::file_unreadable, file, "no pipe can be made: " + errno_text(), "close some files");
  const FileDescriptor in(ends[0]);
  FileDescriptor out(ends[1]);
  const pid_t child = ::fork();
  if (child < 0)
    throw Error(ErrorCode::file_unreadable, file, "no child process can be made: " + errno_text(),
                "end some processes");
  if (child == 0) be_the_child(limits, blame, out.number(), work);

  out.close();
  std::optional<std::vector<std::byte>> bytes = read_until_end(in.number(), limits);
  if (!bytes) ::kill(child, SIGKILL);
  const int status = status_of(child);
  if (!bytes) throw too_much(limits, file);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || bytes->empty())
    throw Error(blame, file,
                "the process that read it was brought down" +
                    (WIFSIGNALED(status) ? " (" + std::string(::strsignal(WTERMSIG(status))) + ")" : std::string()),
                kDoNotTrust);

  const auto kind = static_cast<Answer>(bytes->front());
  bytes->erase(bytes->begin());
  if (kind == Answer::result) return std::move(*bytes);
  ErrorCode code = blame;
  const std::size_t code_size = std::min(sizeof code, bytes->size());
  std::memcpy(&code, bytes->data(), code_size);
  const std::string text(reinterpret_cast<const char*>(bytes->data()) + code_size, bytes->size() - code_size);
  if (text.empty()) throw too_much(limits, file);
  throw Error(code, "", text, "");
}

}  // namespace uhas
