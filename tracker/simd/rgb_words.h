// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <xsimd/xsimd.hpp>

namespace silt::tracker::simd {

// A batch of pixels of three bytes, each in a word: red + 256·green + 65536·blue. What is above
// that is of no meaning. No byte behind the last pixel is read.
template <typename Arch>
struct RgbWords {
  using Words = xsimd::batch<std::int32_t, Arch>;

  static Words Load(const unsigned char* rgb) {
    alignas(64) std::int32_t words[Words::size];
    for (std::size_t i = 0; i < Words::size; ++i) {
      words[i] = rgb[3 * i] | rgb[3 * i + 1] << 8 | rgb[3 * i + 2] << 16;
    }
    return Words::load_aligned(words);
  }
};

#if XSIMD_WITH_SSE2
template <>
struct RgbWords<xsimd::sse2> {
  static xsimd::batch<std::int32_t, xsimd::sse2> Load(const unsigned char* rgb) {
    const auto word = [&](int byte) {
      std::uint32_t value;
      std::memcpy(&value, rgb + byte, sizeof(value));
      return value;
    };
    return _mm_set_epi32(int(word(8) >> 8), int(word(6)), int(word(3)), int(word(0)));
  }
};
#endif

// From registers of 16 bytes: four pixels lie at the beginning of the first, and at the end of the
// last, which is loaded from so much earlier.
#if XSIMD_WITH_AVX2
template <>
struct RgbWords<xsimd::avx2> {
  static xsimd::batch<std::int32_t, xsimd::avx2> Load(const unsigned char* rgb) {
    const auto bytes = [&](int at) {
      return _mm_loadu_si128(reinterpret_cast<const __m128i*>(rgb + at));
    };
    const __m128i first = _mm_setr_epi8(0, 1, 2, -1, 3, 4, 5, -1, 6, 7, 8, -1, 9, 10, 11, -1);
    const __m128i last = _mm_setr_epi8(4, 5, 6, -1, 7, 8, 9, -1, 10, 11, 12, -1, 13, 14, 15, -1);
    return _mm256_set_m128i(_mm_shuffle_epi8(bytes(8), last), _mm_shuffle_epi8(bytes(0), first));
  }
};
#endif

#if XSIMD_WITH_AVX512F
template <>
struct RgbWords<xsimd::avx512f> {
  static xsimd::batch<std::int32_t, xsimd::avx512f> Load(const unsigned char* rgb) {
    const auto bytes = [&](int at) {
      return _mm_loadu_si128(reinterpret_cast<const __m128i*>(rgb + at));
    };
    const __m128i first = _mm_setr_epi8(0, 1, 2, -1, 3, 4, 5, -1, 6, 7, 8, -1, 9, 10, 11, -1);
    const __m128i last = _mm_setr_epi8(4, 5, 6, -1, 7, 8, 9, -1, 10, 11, 12, -1, 13, 14, 15, -1);
    const __m256i lower =
        _mm256_set_m128i(_mm_shuffle_epi8(bytes(12), first), _mm_shuffle_epi8(bytes(0), first));
    const __m256i upper =
        _mm256_set_m128i(_mm_shuffle_epi8(bytes(32), last), _mm_shuffle_epi8(bytes(24), first));
    return _mm512_inserti64x4(_mm512_castsi256_si512(lower), upper, 1);
  }
};
#endif

}  // namespace silt::tracker::simd
