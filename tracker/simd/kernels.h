// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/simd/level_view.h"

namespace silt::tracker::simd {

// Functions that add the sums of rows [begin, end) of a level.
using AddRows = void (*)(const LevelView& view, int begin, int end, LaneSums* sums);

// Copies rows [begin, end) of the reference's depth without the pixels that are hidden in the
// current image: those that land there behind what its depth shows. They get 0, no measurement.
using CopyVisible = void (*)(const LevelView& view, int begin, int end, float* depth_m);

// What one instruction set offers; all of them give the same bits.
struct Kernels {
  AddRows add_equations;
  AddRows add_cost;              // Σr² and the count alone
  AddRows add_robust_equations;  // of the robust norm
  AddRows add_depth_equations;   // the same, with residuals of the inverse depth
  CopyVisible copy_visible;      // where the view has a current depth
};

// Each stands in a file of its own, compiled for that instruction set alone.
Kernels BaselineKernels();  // what every processor of the architecture has: SSE2 on x86-64
Kernels Avx2Kernels();
Kernels Avx512Kernels();

}  // namespace silt::tracker::simd
