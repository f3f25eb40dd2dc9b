// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <xsimd/xsimd.hpp>

namespace silt::tracker::simd {

// The values at even and at odd places of two batches, one behind the other.
template <typename Arch>
struct EvenOdd {
  using Batch = xsimd::batch<float, Arch>;
  Batch even, odd;

  static EvenOdd Of(const Batch& first, const Batch& second) {
    constexpr int n = int(Batch::size);
    alignas(64) float all[2 * n], even[n], odd[n];
    first.store_aligned(all);
    second.store_aligned(all + n);
    for (int i = 0; i < n; ++i) {
      even[i] = all[2 * i];
      odd[i] = all[2 * i + 1];
    }
    return {Batch::load_aligned(even), Batch::load_aligned(odd)};
  }
};

#if XSIMD_WITH_SSE2
template <>
inline EvenOdd<xsimd::sse2> EvenOdd<xsimd::sse2>::Of(const Batch& first, const Batch& second) {
  return {_mm_shuffle_ps(first, second, _MM_SHUFFLE(2, 0, 2, 0)),
          _mm_shuffle_ps(first, second, _MM_SHUFFLE(3, 1, 3, 1))};
}
#endif

#if XSIMD_WITH_AVX2
template <>
inline EvenOdd<xsimd::avx2> EvenOdd<xsimd::avx2>::Of(const Batch& first, const Batch& second) {
  // Halves of registers are shuffled apart: what belongs together is brought into one first.
  const __m256 low = _mm256_permute2f128_ps(first, second, 0x20);
  const __m256 high = _mm256_permute2f128_ps(first, second, 0x31);
  return {_mm256_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0)),
          _mm256_shuffle_ps(low, high, _MM_SHUFFLE(3, 1, 3, 1))};
}
#endif

#if XSIMD_WITH_AVX512F
template <>
inline EvenOdd<xsimd::avx512f> EvenOdd<xsimd::avx512f>::Of(const Batch& first,
                                                           const Batch& second) {
  const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
  const __m512i odd = _mm512_add_epi32(even, _mm512_set1_epi32(1));
  return {_mm512_permutex2var_ps(first, even, second), _mm512_permutex2var_ps(first, odd, second)};
}
#endif

}  // namespace silt::tracker::simd
