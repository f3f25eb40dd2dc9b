// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

// What is made of images before they are aligned, row by row, by one instruction set; see
// level_view.h for why all of this is plain. Images are without padding.
namespace silt::tracker::simd {

// A colour image, three bytes a pixel, and the gray image of it, or the half of that.
struct GrayView {
  const unsigned char* rgb;
  float* gray;
  int width;  // of the colour image
};

// An image and the next coarser one: core/pyramid.h says what of.
struct HalvedView {
  const float* fine;
  float* half;
  int width;  // of the fine one
};

// A level's depth, and what is kept of it and of the intensity away from its edges.
struct EdgeView {
  int width, height;
  int reach;  // columns and rows beside the two pixels of a jump that are edge too
  const float* depth_m;
  const float* intensity;
  float* marks;  // above 0: at most `reach` columns from a pixel of a jump; null: no edges
  // Results; null: not wanted.
  float* kept_m;          // depth, 0 at edges
  float* inverse_depth;   // NaN at edges and where nothing is measured
  float* kept_intensity;  // NaN at edges, but not for holes
};

// Of the preparation; all instruction sets give the same bits.
struct PreparationKernels {
  // Rows [begin, end) of the gray image, and of its half.
  void (*gray)(const GrayView& view, int begin, int end);
  void (*halve_gray)(const GrayView& view, int begin, int end);
  // Rows [begin, end) of the coarser image.
  void (*halve_intensity)(const HalvedView& view, int begin, int end);
  void (*halve_depth)(const HalvedView& view, int begin, int end);
  // Rows [begin, end) of the marks; then, when all are there, of the results: how many depths are
  // kept that are measured.
  void (*mark_edges)(const EdgeView& view, int begin, int end);
  int (*keep)(const EdgeView& view, int begin, int end);
};

inline constexpr int kMaxEdgeReach = 100;

PreparationKernels BaselinePreparation();
PreparationKernels Avx2Preparation();
PreparationKernels Avx512Preparation();

}  // namespace silt::tracker::simd
