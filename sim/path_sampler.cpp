// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_sampler.h"

#include <array>

namespace silt::sim {

namespace {

std::uint32_t Reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x & 0xff00ff00u) >> 8);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x & 0xf0f0f0f0u) >> 4);
  x = ((x & 0x33333333u) << 2) | ((x & 0xccccccccu) >> 2);
  return ((x & 0x55555555u) << 1) | ((x & 0xaaaaaaaau) >> 1);
}

// A permutation in which each bit depends on the less significant ones only (Laine, Karras 2011).
std::uint32_t LaineKarras(std::uint32_t x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  return x ^ (x * 0x8d22f6e6u);
}

std::uint32_t OwenScrambled(std::uint32_t x, std::uint32_t seed) {
  return Reversed(LaineKarras(Reversed(x), seed));
}

// Contributions of each byte of an index to Sobol's second dimension: direction numbers
// v ← v ⊕ v/2.
constexpr auto kSobol2 = [] {
  std::array<std::array<std::uint32_t, 256>, 4> table{};
  std::uint32_t direction = 0x80000000u;
  for (auto& bytes : table) {
    for (std::uint32_t bit = 1; bit < 256; bit *= 2, direction ^= direction >> 1) {
      for (std::uint32_t i = 0; i < 256; ++i) bytes[i] ^= i & bit ? direction : 0;
    }
  }
  return table;
}();

std::uint32_t Sobol2(std::uint32_t i) {
  return kSobol2[0][i & 255] ^ kSobol2[1][i >> 8 & 255] ^ kSobol2[2][i >> 16 & 255] ^
         kSobol2[3][i >> 24];
}

std::uint32_t Hash(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return std::uint32_t(z ^ (z >> 31));
}

float Unit(std::uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }

}  // namespace

std::uint32_t PathSampler::NextSeed() {
  return Hash(key_ + ++position_ * std::uint64_t(0x9e3779b97f4a7c15u));
}

float PathSampler::Next() {
  const std::uint32_t seed = NextSeed();
  return Unit(OwenScrambled(Reversed(OwenScrambled(index_, seed)), Hash(seed)));
}

Vec2f PathSampler::Next2() {
  const std::uint32_t seed = NextSeed();
  const std::uint32_t i = OwenScrambled(index_, seed);
  return {Unit(OwenScrambled(Reversed(i), Hash(seed))),
          Unit(OwenScrambled(Sobol2(i), Hash(~std::uint64_t(seed))))};
}

}  // namespace silt::sim
