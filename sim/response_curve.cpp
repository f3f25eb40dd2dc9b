// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/response_curve.h"

#include <array>
#include <cmath>

#include "silt/core/color.h"
#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

constexpr int kCells = 4096;

// A code is reached where the encoded value passes code − ½; `first` gives for each cell of [0, 1]
// the code at its lower end, from which few steps remain.
struct Table {
  std::array<float, 257> threshold;
  std::array<std::uint8_t, kCells + 1> first;

  Table() {
    threshold[0] = -1;
    threshold[256] = 2;
    for (int code = 1; code < 256; ++code) {
      threshold[std::size_t(code)] = LinearFromSrgb((float(code) - 0.5f) / 255);
    }
    int code = 0;
    for (int cell = 0; cell <= kCells; ++cell) {
      while (threshold[std::size_t(code) + 1] <= float(cell) / kCells) ++code;
      first[std::size_t(cell)] = std::uint8_t(code);
    }
  }
};

}  // namespace

std::uint8_t EncodeSrgb8(float linear) {
  static const Table table;
  if (!(linear > 0)) return 0;  // also what is not a number
  if (linear >= 1) return 255;
  std::size_t code = table.first[std::size_t(linear * kCells)];
  while (table.threshold[code + 1] <= linear) ++code;
  return std::uint8_t(code);
}

Image<Rgb8> EncodeSrgb8(const Image<Vec3f>& linear) {
  Image<Rgb8> encoded(linear.width(), linear.height());
  ParallelFor(linear.height(), [&](int y) {
    const Vec3f* in = linear.row(y);
    Rgb8* out = encoded.row(y);
    for (int x = 0; x < linear.width(); ++x) {
      out[x] = {EncodeSrgb8(in[x].x), EncodeSrgb8(in[x].y), EncodeSrgb8(in[x].z)};
    }
  });
  return encoded;
}

}  // namespace silt::sim
