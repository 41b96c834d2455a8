// Whatever work does to its process, the caller gets its bytes or an Error.
#include "uhas/fence/child_process.hpp"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "support/error_check.hpp"
#include "support/scratch_folder.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

using Bytes = std::vector<std::byte>;

Bytes run(const std::function<Bytes()>& work, const ChildLimits& limits = {}) {
  return in_child(limits, ErrorCode::invalid_mesh, "some.file", work);
}

}  // namespace

TEST_CASE("the bytes come back, few or many") {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{3'000'000}}) {
    const auto make = [&] {
      Bytes bytes(size);
      for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * i);
      return bytes;
    };
    CHECK(run(make) == make());
  }
}

TEST_CASE("what the child does to memory is undone with it") {
  int number = 1;
  run([&] {
    number = 2;
    return Bytes{};
  });
  CHECK(number == 1);
}

TEST_CASE("an Error keeps its code and words, any other exception its words") {
  check_error(ErrorCode::unsupported_version, "a.h5: too new; update",
              [] { run([]() -> Bytes { throw Error(ErrorCode::unsupported_version, "a.h5", "too new", "update"); }); });
  check_error(ErrorCode::invalid_mesh, "of the library",
              [] { run([]() -> Bytes { throw std::runtime_error("of the library"); }); });
}

TEST_CASE("a crash is an error that names the file and the cause") {
  check_error(ErrorCode::invalid_mesh, "some.file: the process that read it was brought down (Segmentation fault)", [] {
    run([]() -> Bytes {
      ::raise(SIGSEGV);
      return {};
    });
  });
  check_error(ErrorCode::invalid_mesh, "some.file: the process that read it was brought down; do not trust the file",
              [] { run([]() -> Bytes { ::_exit(7); }); });
}

TEST_CASE("one child gives several results, and the file that it is at is blamed") {
  const auto number = [](std::size_t i) { return Bytes(i + 1, static_cast<std::byte>(i)); };
  const auto check_two_of_three = [&](const std::function<Bytes(std::size_t)>& work, ErrorCode code,
                                      const std::string& words) {
    ChildProcess child({.max_seconds = 1}, ErrorCode::invalid_mesh, "a.file", 3, work);
    CHECK(child.next("a.file") == number(0));
    CHECK(child.next("b.file") == number(1));
    check_error(code, words, [&] { child.next("c.file"); });
  };
  ChildProcess whole({}, ErrorCode::invalid_mesh, "a.file", 3, number);
  for (std::size_t i = 0; i < 3; ++i) CHECK(whole.next("any.file") == number(i));

  check_two_of_three(
      [&](std::size_t i) {
        if (i == 2) ::_exit(7);
        return number(i);
      },
      ErrorCode::invalid_mesh, "c.file: the process that read it was brought down");
  check_two_of_three(
      [&](std::size_t i) {
        while (i == 2) std::this_thread::sleep_for(std::chrono::seconds(1));
        return number(i);
      },
      ErrorCode::limit_exceeded, "c.file: cannot be read within 1 s");
}

TEST_CASE("a child whose results nobody wants ends with its object") {
  const auto start = std::chrono::steady_clock::now();
  {
    ChildProcess endless({}, ErrorCode::invalid_mesh, "a.file", SIZE_MAX, [](std::size_t) { return Bytes(1u << 20); });
  }
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("a hang is ended") {
  const auto start = std::chrono::steady_clock::now();
  check_error(ErrorCode::limit_exceeded, "some.file: cannot be read within 1 s", [] {
    run(
        []() -> Bytes {
          for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
        },
        {.max_seconds = 1});
  });
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("a result larger than the bound on memory is refused") {
  Bytes large(8u << 20);
  check_error(ErrorCode::limit_exceeded, "some.file: cannot be read within 4194304 bytes of memory",
              [&] { run([&] { return std::move(large); }, {.max_memory_bytes = 4u << 20}); });
}

#ifndef UHAS_SANITIZED  // whose own checks open files, and whose malloc ends the process
TEST_CASE("a process that may open no more files says so") {
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const rlimit none{0, before.rlim_max};
  ::setrlimit(RLIMIT_NOFILE, &none);
  check_error(ErrorCode::file_unreadable, "some.file: no pipe can be made: Too many open files; close some files",
              [] { run([] { return Bytes{}; }); });
  ::setrlimit(RLIMIT_NOFILE, &before);
}

TEST_CASE("boundless memory is refused") {
  check_error(ErrorCode::limit_exceeded,
              "some.file: cannot be read within 67108864 bytes of memory; do not trust the file, or raise "
              "ChildLimits::max_memory_bytes",
              [] { run([] { return Bytes(256u << 20); }, {.max_memory_bytes = 64u << 20}); });
}
#endif

TEST_CASE("the child writes no file") {
  const ScratchFolder folder;
  CHECK_THROWS_AS(run([&]() -> Bytes {
                    std::ofstream(folder.file("a")) << "text" << std::flush;  // ended by SIGXFSZ
                    return {};
                  }),
                  Error);
  CHECK(read_bytes(folder.file("a")).empty());
}
