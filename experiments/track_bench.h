// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/dense/align_figures.h"
#include "silt/experiments/bench_pairs.h"
#include "silt/experiments/json.h"
#include "silt/tracker/keyframe_tracker.h"

// How fast pairs of frames are aligned, and how well, beside OpenCV's odometries.
namespace silt::experiments {

struct TrackBenchOptions {
  std::string backend = "cpu";
  int repeats = 5;  // of each pair, of which the fastest counts
  int threads = 2;  // beside one
  std::vector<std::string> presets = {"fast", "accurate"};

  Json ToJson() const;
};

// One method on one pair, from the images in memory to the pose: gray images, pyramids and all that
// is prepared of either image included. All start from the identity.
struct PairRun {
  bool found = false;
  double milliseconds = 0;
  double t_mm = 0, r_deg = 0;  // error of the motion; of the identity where none was found
  // silt's own methods only: the stages of the current frame, and what the reference took before.
  tracker::StageTimes stages;
  double device_ms = 0;  // of the current frame, by the clock of a device that has one
  double keyframe_ms = 0;
  double pixel_iterations = 0;  // pixels × iterations over all levels
};

struct MethodRuns {
  std::string name;
  bool has_stages = false;
  std::vector<PairRun> one_thread, threads;  // in the order of the pairs
};

// One full-size call of the fused pass, warp to normal equations, on one thread, in milliseconds;
// by the clock of a device that has one.
struct FusedPass {
  double photometric_ms = 0;   // eqs. 12–17
  double robust_ms = 0;        // with the robust norm
  double robust_depth_ms = 0;  // and with residuals of the inverse depth: of `fast`, `accurate`
};

// A preset's refinement alone, pair after pair, of images that lie ready: by the device's own clock
// where it has one.
struct Refinement {
  std::string name;
  dense::AlignFigures figures;
};

struct TrackBench {
  int threads = 2;
  std::string backend;
  std::vector<BenchPair> pairs;
  std::vector<MethodRuns> methods;
  FusedPass fused_pass;
  std::vector<Refinement> refinements;
  dense::Ceilings ceilings;  // of the backend's device

  Json ToJson() const;
  std::string Format() const;
};

// The presets, and OpenCV's methods if they are there, after each has run once to warm up. Each
// repeat runs every method on every pair once, another one first, so that all are slowed alike by
// what else the machine does.
TrackBench MeasureTracking(std::vector<BenchPair> pairs, const TrackBenchOptions& options);

}  // namespace silt::experiments
