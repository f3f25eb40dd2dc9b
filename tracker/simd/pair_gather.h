// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <xsimd/xsimd.hpp>

namespace silt::tracker::simd {

// Two neighbouring pixels, from[at] and from[at + 1], as 64 bits.
template <typename Arch>
[[gnu::always_inline]] inline long long PairAt(const float* from, std::int32_t at) {
  long long pair;
  std::memcpy(&pair, from + at, sizeof(pair));
  return pair;
}

// The pairs at every second of a batch's indices, at[0], at[2], …. Loads of 64 bits into registers
// cost less than the processors' own gather instructions, and half as many are needed.
template <typename Arch>
struct PairGather {
  using Words = xsimd::batch<std::int64_t, Arch>;

  static Words EverySecond(const float* from, const std::int32_t* at) {
    alignas(64) std::int64_t pairs[Words::size];
    for (std::size_t k = 0; k < Words::size; ++k) pairs[k] = PairAt<Arch>(from, at[2 * k]);
    return Words::load_aligned(pairs);
  }
};

#if XSIMD_WITH_SSE2
template <>
struct PairGather<xsimd::sse2> {
  static xsimd::batch<std::int64_t, xsimd::sse2> EverySecond(const float* from,
                                                             const std::int32_t* at) {
    const auto pair = [&](int k) { return PairAt<xsimd::sse2>(from, at[2 * k]); };
    return _mm_set_epi64x(pair(1), pair(0));
  }
};
#endif

#if XSIMD_WITH_AVX2
template <>
struct PairGather<xsimd::avx2> {
  static xsimd::batch<std::int64_t, xsimd::avx2> EverySecond(const float* from,
                                                             const std::int32_t* at) {
    const auto pair = [&](int k) { return PairAt<xsimd::avx2>(from, at[2 * k]); };
    return _mm256_set_epi64x(pair(3), pair(2), pair(1), pair(0));
  }
};
#endif

#if XSIMD_WITH_AVX512F
template <>
struct PairGather<xsimd::avx512f> {
  static xsimd::batch<std::int64_t, xsimd::avx512f> EverySecond(const float* from,
                                                                const std::int32_t* at) {
    const auto pair = [&](int k) { return PairAt<xsimd::avx512f>(from, at[2 * k]); };
    return _mm512_set_epi64(pair(7), pair(6), pair(5), pair(4), pair(3), pair(2), pair(1), pair(0));
  }
};
#endif

}  // namespace silt::tracker::simd
