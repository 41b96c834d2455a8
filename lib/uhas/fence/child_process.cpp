#include "uhas/fence/child_process.hpp"

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
#include <utility>

#include "uhas/files/file_descriptor.hpp"

namespace uhas {
namespace {

using Clock = std::chrono::steady_clock;

// The child answers once a piece of work, until it fails: a head, then the bytes of the result, or the number of an
// ErrorCode and what() says.
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

/// False when nobody listens any more.
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

[[noreturn]] void be_the_child(const ChildLimits& limits, ErrorCode blame, int out, std::size_t count,
                               const std::function<std::vector<std::byte>(std::size_t)>& work) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // an interrupted tool leaves no child behind
  // a crash is ours to tell of, not for handlers of the program
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::signal(crash, SIG_DFL);
  bound(RLIMIT_AS, address_space() + limits.max_memory_bytes);
  bound(RLIMIT_CORE, 0);
  bound(RLIMIT_FSIZE, 0);
  try {
    for (std::size_t i = 0; i < count; ++i) answer(out, Answer::result, work(i));
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

/// Fills `bytes` with what the child writes next.
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

Error too_long(const ChildLimits& limits, const std::string& file) {
  return {ErrorCode::limit_exceeded, file, "cannot be read within " + std::to_string(limits.max_seconds) + " s",
          std::string(kDoNotTrust) + ", or raise ChildLimits::max_seconds"};
}

Error too_much(const ChildLimits& limits, const std::string& file) {
  return {ErrorCode::limit_exceeded, file,
          "cannot be read within " + std::to_string(limits.max_memory_bytes) + " bytes of memory",
          std::string(kDoNotTrust) + ", or raise ChildLimits::max_memory_bytes"};
}

}  // namespace

struct ChildProcess::State {
  ChildLimits limits;
  ErrorCode blame;
  FileDescriptor in;
  pid_t process;

  // Fills `bytes` with what the child answers next.
  void receive(std::span<std::byte> bytes, Clock::time_point deadline, const std::string& file) {
    const Reading reading = read_all(in.number(), deadline, bytes);
    if (reading == Reading::too_long) throw too_long(limits, file);
    if (reading == Reading::whole) return;
    const int status = status_of(std::exchange(process, -1));
    throw Error(blame, file,
                "the process that read it was brought down" +
                    (WIFSIGNALED(status) ? " (" + std::string(::strsignal(WTERMSIG(status))) + ")" : std::string()),
                kDoNotTrust);
  }
};

ChildProcess::ChildProcess(const ChildLimits& limits, ErrorCode blame, const std::string& file, std::size_t count,
                           std::function<std::vector<std::byte>(std::size_t i)> work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw Error(ErrorCode::file_unreadable, file, "no pipe can be made: " + errno_text(), "close some files");
  state_.reset(new State{limits, blame, FileDescriptor(ends[0]), -1});
  const FileDescriptor out(ends[1]);
  ::fcntl(ends[0], F_SETPIPE_SZ, 1 << 20);  // fewer changes between the two; without it, it is only slower
  state_->process = ::fork();
  if (state_->process < 0)
    throw Error(ErrorCode::file_unreadable, file, "no child process can be made: " + errno_text(),
                "end some processes");
  if (state_->process == 0) be_the_child(limits, blame, out.number(), count, work);
}

ChildProcess::~ChildProcess() {
  if (state_->process < 0) return;
  ::kill(state_->process, SIGKILL);
  status_of(state_->process);
}

std::vector<std::byte> ChildProcess::next(const std::string& file) {
  constexpr std::uint64_t a_year = 365 * 24 * 3600;  // beyond it, sums of time could overflow
  const auto deadline = Clock::now() + std::chrono::seconds(std::min(state_->limits.max_seconds, a_year));
  AnswerHead head;
  state_->receive(std::as_writable_bytes(std::span(&head, 1)), deadline, file);
  if (head.size > state_->limits.max_memory_bytes) throw too_much(state_->limits, file);
  std::vector<std::byte> bytes(head.size);
  state_->receive(bytes, deadline, file);
  if (head.kind == Answer::result) return bytes;

  ErrorCode code = state_->blame;
  const std::size_t code_size = std::min(sizeof code, bytes.size());
  std::memcpy(&code, bytes.data(), code_size);
  const std::string text(reinterpret_cast<const char*>(bytes.data()) + code_size, bytes.size() - code_size);
  if (text.empty()) throw too_much(state_->limits, file);
  throw Error(code, "", text, "");
}

std::vector<std::byte> in_child(const ChildLimits& limits, ErrorCode blame, const std::string& file,
                                const std::function<std::vector<std::byte>()>& work) {
  return ChildProcess(limits, blame, file, 1, [&](std::size_t) { return work(); }).next(file);
}

}  // namespace uhas
