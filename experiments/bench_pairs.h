// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "silt/experiments/case_runner.h"
#include "silt/experiments/pair_alignment.h"

// The pairs of frames that trackers are measured on: rendered, or from disk.
namespace silt::experiments {

struct BenchPair {
  FramePair frames;
  int gap = 0;         // frames that they are apart; 0: not told
  double load_ms = 0;  // of one frame, read from its files; 0 where it comes from no file
};

// For each of some instants, evenly spread over a path or a folder, and each gap: the pair of the
// frame there and the one so many frames later.
struct PairChoice {
  int instants = 8;
  std::vector<int> gaps = {1, 3, 9};
};

// Of a path at `fps`. Throws silt::Error where a gap is longer than the path.
std::vector<BenchPair> RenderBenchPairs(const World& world, const sim::RenderOptions& options,
                                        double fps, const PairChoice& choice);

// Of a folder in TUM's layout with its groundtruth.txt. `camera` with fy < 0: its poses are in
// ICL-NUIM's axes (core/io/icl_camera.h). Gaps longer than the folder give no pair. Throws
// silt::Error where nothing is left.
std::vector<BenchPair> FolderBenchPairs(const std::filesystem::path& folder,
                                        const PinholeCamera& camera, double depth_per_metre,
                                        const PairChoice& choice);

// Of a list as `silt align --pairs` takes it. The files are named by their times, as TUM's are;
// `truth` has the poses. Throws silt::Error naming a file that does not fit.
std::vector<BenchPair> ListedBenchPairs(const std::filesystem::path& list,
                                        const std::filesystem::path& truth,
                                        const PinholeCamera& camera, double depth_per_metre);

}  // namespace silt::experiments
