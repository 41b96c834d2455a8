#include "uhas/files/sha256/blocks.hpp"

#if defined(__x86_64__)
#include <cpuid.h>
#include <immintrin.h>
#endif

namespace uhas {

#if defined(__x86_64__)
namespace {

/// The instructions keep the state as (a b e f) and (c d g h) and do two rounds at a time; see
/// Intel's "SHA Extensions".
__attribute__((target("sha,sse4.1"))) void compress(Sha256State& state, std::span<const std::byte> blocks) {
  const __m128i big_endian = _mm_set_epi64x(0x0c0d0e0f08090a0b, 0x0405060700010203);
  auto* halves = reinterpret_cast<__m128i*>(state.data());
  const __m128i badc = _mm_shuffle_epi32(_mm_loadu_si128(halves), 0xb1);
  const __m128i hgfe = _mm_shuffle_epi32(_mm_loadu_si128(halves + 1), 0x1b);
  __m128i abef = _mm_alignr_epi8(badc, hgfe, 8), cdgh = _mm_blend_epi16(hgfe, badc, 0xf0);

  for (; blocks.size() >= kSha256Block; blocks = blocks.subspan(kSha256Block)) {
    const __m128i abef_before = abef, cdgh_before = cdgh;
    __m128i w[4];  // words t .. t + 15 of the message schedule, in a ring
    for (int i = 0; i < 4; ++i)
      w[i] = _mm_shuffle_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(blocks.data()) + i), big_endian);
#pragma GCC unroll 16
    for (int i = 0; i < 16; ++i) {
      __m128i& oldest = w[i % 4];
      const __m128i constants = _mm_load_si128(reinterpret_cast<const __m128i*>(kSha256Constants.data()) + i);
      const __m128i sums = _mm_add_epi32(oldest, constants);
      cdgh = _mm_sha256rnds2_epu32(cdgh, abef, sums);
      abef = _mm_sha256rnds2_epu32(abef, cdgh, _mm_shuffle_epi32(sums, 0x0e));
      const __m128i newest = w[(i + 3) % 4], seven_ago = _mm_alignr_epi8(newest, w[(i + 2) % 4], 4);
      if (i < 12)
        oldest = _mm_sha256msg2_epu32(_mm_add_epi32(_mm_sha256msg1_epu32(oldest, w[(i + 1) % 4]), seven_ago), newest);
    }
    abef = _mm_add_epi32(abef, abef_before);
    cdgh = _mm_add_epi32(cdgh, cdgh_before);
  }

  const __m128i feba = _mm_shuffle_epi32(abef, 0x1b), dchg = _mm_shuffle_epi32(cdgh, 0xb1);
  _mm_storeu_si128(halves, _mm_blend_epi16(feba, dchg, 0xf0));
  _mm_storeu_si128(halves + 1, _mm_alignr_epi8(dchg, feba, 8));
}

bool processor_has_sha() noexcept {
  constexpr unsigned sha_bit = 1u << 29, sse41_bit = 1u << 19;
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (!__get_cpuid(1, &a, &b, &c, &d) || !(c & sse41_bit)) return false;
  return __get_cpuid_count(7, 0, &a, &b, &c, &d) && (b & sha_bit);
}

}  // namespace

Sha256Compress sha256_compress_x86() noexcept { return processor_has_sha() ? &compress : nullptr; }
#else
Sha256Compress sha256_compress_x86() noexcept { return nullptr; }
#endif

}  // namespace uhas
