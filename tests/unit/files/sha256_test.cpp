#include "uhas/files/sha256.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "uhas/files/sha256/blocks.hpp"

using uhas::Sha256;
using uhas::sha256_hex;

namespace {

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

}  // namespace

TEST_CASE("SHA-256 agrees with the NIST example vectors") {
  CHECK(sha256_hex(bytes_of("")) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(sha256_hex(bytes_of("abc")) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(sha256_hex(bytes_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")) ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(sha256_hex(bytes_of("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmno"
                            "ijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu")) ==
        "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
  CHECK(sha256_hex(bytes_of(std::string(1'000'000, 'a'))) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("SHA-256 does not depend on how the bytes are cut into pieces") {
  std::string message;
  for (std::size_t size = 0; size <= 200; ++size, message += static_cast<char>('a' + size % 26))
    for (const std::size_t piece : {1, 7, 63, 64, 65, 128}) {
      Sha256 whole, pieces;
      whole.update(bytes_of(message));
      for (std::size_t at = 0; at < size; at += piece)
        pieces.update(bytes_of(message).subspan(at, std::min(piece, size - at)));
      CHECK(whole.finish() == pieces.finish());
    }
}

TEST_CASE("the processor's own instructions agree with plain code") {
  using namespace uhas;
  const Sha256Compress own = sha256_compress_x86();
  if (!own) {
    MESSAGE("SKIPPED: this processor has no SHA instructions");
    return;
  }
  std::mt19937_64 random(1);
  std::vector<std::byte> bytes(20 * kSha256Block);
  for (std::size_t blocks = 0; blocks <= 20; ++blocks) {
    Sha256State plain, wide;
    for (std::uint32_t& word : plain) word = static_cast<std::uint32_t>(random());
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random());
    wide = plain;
    sha256_compress_portable(plain, std::span(bytes).first(blocks * kSha256Block));
    own(wide, std::span(bytes).first(blocks * kSha256Block));
    CHECK(plain == wide);
  }
}
