// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "silt/core/vector.h"

namespace silt::sim {

// Four numbers in one register, in the compiler's own vectors: a colour travels as (r, g, b, −).
// Sixteen bytes are what every x86-64 and AArch64 has, so that there is one code and one result.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 Float4From(const Vec3f& v) { return Float4{v.x, v.y, v.z, 0}; }
inline Vec3f Vec3From(const Float4& v) { return {v[0], v[1], v[2]}; }

inline Float4 Lerp(const Float4& a, const Float4& b, float t) { return a + t * (b - a); }

// Two neighbours of four unsigned 16-bit channels each, as floats.
struct TexelPair {
  Float4 first, second;
};

inline TexelPair LoadTexelPair(const std::uint16_t* from) {
#if defined(__SSE2__)
  const __m128i both = _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
  const __m128i zero = _mm_setzero_si128();
  return {Float4(_mm_cvtepi32_ps(_mm_unpacklo_epi16(both, zero))),
          Float4(_mm_cvtepi32_ps(_mm_unpackhi_epi16(both, zero)))};
#else
  return {Float4{float(from[0]), float(from[1]), float(from[2]), float(from[3])},
          Float4{float(from[4]), float(from[5]), float(from[6]), float(from[7])}};
#endif
}

}  // namespace silt::sim
