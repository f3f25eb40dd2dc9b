// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::tracker {

// What a pass over pixels adds up, on the CPU and on the GPU: 21 of JᵀJ, its upper triangle row by
// row, 6 of Jᵀr, over all residuals; then Σr², the number of pixels, and Σs·r² of the robust norm,
// over those of the intensity; then the latter two over those of the inverse depth.
inline constexpr int kGradientSum = 21, kSquaresSum = 27, kCountSum = 28, kRobustSum = 29,
                     kDepthCountSum = 30, kDepthRobustSum = 31, kSumCount = 32;

// Rows of a tile: of its part of the gradient, NormalEquations::scatter is made.
inline constexpr int kTileRows = 8;

}  // namespace silt::tracker
