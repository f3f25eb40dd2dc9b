// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <xsimd/xsimd.hpp>

#include "silt/tracker/kernel/bilinear.h"
#include "silt/tracker/simd/pair_gather.h"

// What tracker/kernel needs of a SIMD batch beyond arithmetic. Include before the kernels: they
// find Select by the batch's own namespace.
namespace xsimd {

template <typename T, typename Arch>
inline batch<T, Arch> Select(const batch_bool<T, Arch>& mask, const batch<T, Arch>& yes,
                             const batch<T, Arch>& no) {
  return select(mask, yes, no);
}

}  // namespace xsimd

namespace silt::tracker::simd {

// kernel/image_sampler.h for a batch of coordinates.
template <typename Arch>
struct BatchSampler {
  using Batch = xsimd::batch<float, Arch>;
  using Indices = xsimd::batch<std::int32_t, Arch>;

  const float* pixels;
  int width, height;

  kernel::Taps<Batch> operator()(const Batch& x, const Batch& y) const {
    alignas(64) std::int32_t at[Batch::size];
    IndexOf(x, y).store_aligned(at);
    return TapsAt(at);
  }

  Indices IndexOf(const Batch& x, const Batch& y) const {
    return xsimd::to_int(y) * Indices(width) + xsimd::to_int(x);
  }

  // Of a batch of indices.
  kernel::Taps<Batch> TapsAt(const std::int32_t* at) const {
    const Pairs upper = PairsAt(pixels, at), lower = PairsAt(pixels + width, at);
    return {upper.left, upper.right, lower.left, lower.right};
  }

  struct Pairs {
    Batch left, right;  // pixels and their right neighbours
  };

  // The pairs of the even lanes come in one batch, left pixels in the lower halves of its words,
  // and those of the odd lanes in another.
  static Pairs PairsAt(const float* from, const std::int32_t* at) {
    using Words = xsimd::batch<std::uint64_t, Arch>;
    const Words even = xsimd::bitwise_cast<Words>(PairGather<Arch>::EverySecond(from, at));
    const Words odd = xsimd::bitwise_cast<Words>(PairGather<Arch>::EverySecond(from, at + 1));
    const Words lower_half(0xffffffffu);
    return {xsimd::bitwise_cast<Batch>((even & lower_half) | (odd << 32)),
            xsimd::bitwise_cast<Batch>((even >> 32) | (odd & ~lower_half))};
  }
};

}  // namespace silt::tracker::simd
