// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "silt/experiments/accuracy.h"

namespace silt::experiments {

// Writes into an existing folder:
//   accuracy.json  accuracy.csv       all statistics, with the manifest in the former
//   trajectories/                     true and estimated poses, TUM's format, nine digits
//   errors/                           per frame: errors, keyframes, positions, orientations
//   frames/                           a picture of each rendering, and its depth
//   figures/                          drawn by matplotlib; without it a warning is all
//   report.html                       the tables, figures and pictures in one file
void WriteAccuracy(const std::filesystem::path& folder, const AccuracyResult& result,
                   const Json& manifest);

// A depth as a gray picture, near bright: 1/z between the nearest and farthest measurement.
Image<Rgb8> DepthPicture(const Image<float>& depth_m);

}  // namespace silt::experiments
