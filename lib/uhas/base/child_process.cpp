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

// The child answers once a file, until it fails: a head, then the bytes of the result, or the number of an ErrorCode
// and what() says.
enum class Answer : std::uint64_t { result, error };

struct AnswerHead {
  std::uint64_t size = 0;
  Answer kind = Answer::result;
};

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
  const AnswerHead head{bytes.size(), kind};
  if (write_all(file, std::as_bytes(std::span(&head, 1)))) write_all(file, bytes);
}

void answer_error(int file, ErrorCode code, const std::string& text) {
  std::vector<std::byte> bytes(sizeof code + text.size());
  std::memcpy(bytes.data(), &code, sizeof code);
  std::memcpy(bytes.data() + sizeof code, text.data(), text.size());
  answer(file, Answer::error, bytes);
}

[[noreturn]] void be_the_child(const ChildLimits& limits, ErrorCode blame, int out, std::size_t files,
                               const std::function<std::vector<std::byte>(std::size_t)>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // an interrupted tool leaves no child behind
  // a crash is ours to tell of, not for handlers of the program
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(crash, SIG_DFL);
  bound(RLIMIT_AS, address_space() + limits.max_memory_bytes);
  bound(RLIMIT_CORE, 0);
  bound(RLIMIT_FSIZE, 0);
  try {
    for (std::size_t i = 0; i < files; ++i) answer(out, Answer::result, work(i));
  } catch (const Error& error) {
    answer_error(out, error.code(), error.what());
  } catch (const std::bad_alloc&) {
    answer_error(out, ErrorCode::limit_exceeded, "");  // the parent has the words, and the memory for them
  } catch (const std::exception& error) {
    answer_error(out, blame, error.what());
  }
  ::_exit(0);  // nothing of the parent's is flushed or destroyed twice
}

enum class Reading { whole, ended, too_long };

// Fills `bytes` with what the child writes next.
Reading read_all(int file, Clock::time_point deadline, std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Reading::too_long;
    pollfd ready{.fd = file, .events = POLLIN, .revents = 0};
    if (::poll(&ready, 1, static_cast<int>(std::min<long long>(left, 1'000'000))) <= 0) continue;
    const ssize_t got = ::read(file, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return Reading::ended;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
  return Reading::whole;
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
          std::string(kDoNotTrust) + ", or raise the bounds by --max-read-seconds and --max-read-bytes"};
}

// A copy of this process at work, ended with this object.
class Child {
 public:
  Child(const ChildLimits& limits, ErrorCode blame, std::span<const std::string> files,
        const std::function<std::vector<std::byte>(std::size_t)>& work)
      : limits_(limits), blame_(blame) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw Error(ErrorCode::file_unreadable, files.front(), "no pipe can be made: " + errno_text(),
                  "close some files");
    in_.emplace(ends[0]);
    const FileDescriptor out(ends[1]);
    ::fcntl(in_->number(), F_SETPIPE_SZ, 1 << 20);  // fewer changes between the two; without it, it is only slower
    process_ = ::fork();
    if (process_ < 0)
      throw Error(ErrorCode::file_unreadable, files.front(), "no child process can be made: " + errno_text(),
                  "end some processes");
    if (process_ == 0) be_the_child(limits, blame, out.number(), files.size(), work);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (process_ > 0) end();
  }

  // Its next answer, about `file`.
  std::vector<std::byte> answer(const std::string& file) {
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits_.max_seconds));
    AnswerHead head;
    require(read_all(in_->number(), deadline, std::as_writable_bytes(std::span(&head, 1))), file);
    if (head.size > limits_.max_memory_bytes) throw too_much(limits_, file);
    std::vector<std::byte> bytes(head.size);
    require(read_all(in_->number(), deadline, bytes), file);
    if (head.kind == Answer::result) return bytes;

    ErrorCode code = blame_;
    const std::size_t code_size = std::min(sizeof code, bytes.size());
    std::memcpy(&code, bytes.data(), code_size);
    const std::string text(reinterpret_cast<const char*>(bytes.data()) + code_size, bytes.size() - code_size);
    if (text.empty()) throw too_much(limits_, file);
    throw Error(code, "", text, "");
  }

 private:
  void require(Reading reading, const std::string& file) {
    if (reading == Reading::too_long) throw too_much(limits_, file);
    if (reading == Reading::whole) return;
    const int status = status_of(process_);
    process_ = -1;
    throw Error(blame_, file,
                "the process that read it was brought down" +
                    (WIFSIGNALED(status) ? " (" + std::string(::strsignal(WTERMSIG(status))) + ")" : std::string()),
                kDoNotTrust);
  }

  void end() const {
    ::kill(process_, SIGKILL);
    status_of(process_);
  }

  const ChildLimits& limits_;
  ErrorCode blame_;
  std::optional<FileDescriptor> in_;
  pid_t process_ = -1;
};

}  // namespace

std::vector<std::vector<std::byte>> in_child(const ChildLimits& limits, ErrorCode blame,
                                             std::span<const std::string> files,
                                             const std::function<std::vector<std::byte>(std::size_t i)>& work) {
  std::vector<std::vector<std::byte>> results;
  if (files.empty()) return results;
  Child child(limits, blame, files, work);
  for (const std::string& file : files) results.push_back(child.answer(file));
  return results;
}

std::vector<std::byte> in_child(const ChildLimits& limits, ErrorCode blame, const std::string& file,
                                const std::function<std::vector<std::byte>()>& work) {
  return std::move(in_child(limits, blame, std::span(&file, 1), [&](std::size_t) { return work(); }).front());
}

}  // namespace uhas
