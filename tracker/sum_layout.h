// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::tracker {

// What a pass over pixels adds up, on the CPU and on the GPU: 21 of JᵀJ, its upper triangle row by
// row, 6 of Jᵀr, over all residuals; then Σr², the number of pixels, and Σs·r² of the robust norm,
// over those of the intensity; then the latter two over those of the inverse depth.
inline constexpr int kGradientSum = 21, kSquaresSum = 27, kCountSum = 28, kRobustSum = 29,
                     kDepthCountSum = 30, kDepthRobustSum = 31, kSumCount = 32;

// And behind them, on the CPU alone, those of kernel/brightness.h.
inline constexpr int kBrightnessSum = kSumCount, kBrightnessSumCount = 5,
                     kAllSumCount = kSumCount + kBrightnessSumCount;

// Rows of a tile, the unit of work.
inline constexpr int kTileRows = 8;

// NormalEquations::scatter is made of the gradients of so many stripes of the image, of whole
// tiles, or of the tiles where there are fewer. Errors that run along an edge, as those of
// interpolation do, are not told apart from independent ones by tiles that are lower than the edge
// is long.
inline constexpr int kScatterStripes = 8;

constexpr int TilesOfStripe(int tiles) { return (tiles + kScatterStripes - 1) / kScatterStripes; }

}  // namespace silt::tracker
