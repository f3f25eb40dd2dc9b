// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "silt/core/image.h"
#include "silt/experiments/absolute_error.h"
#include "silt/experiments/case_runner.h"
#include "silt/experiments/json.h"
#include "silt/experiments/tracking_run.h"

// §4.3: the paper's three sequences of a path, tracked, against the truth.
namespace silt::experiments {

struct AccuracyOptions {
  std::string scene, trajectory;
  double start_s = 0, duration_s = 0;  // 0: to the end of the path
  int width = 640, samples_per_pixel = 4;
  int seeds = 1;  // noises and random draws, from `seed` on
  std::uint64_t seed = 0;
  std::vector<std::string> presets = {"paper"};
  std::string backend = "cpu", initializer = "auto";
  std::string depth_sensor = "perfect";  // a model of sim/depth_sensor.h

  Json ToJson() const;
};

// One sequence tracked by one preset with one seed.
struct AccuracyRun {
  PaperSequence sequence;
  TrackerSetup setup;
  Trajectory truth;
  TrackingResult tracking;
  std::vector<PoseError> errors;  // per frame
  PaperStatistics statistics;
  double ate_aligned_cm = 0;

  std::string Name() const;  // of its files: "60fps-paper", "60fps-paper-seed3"
  Json ToJson() const;
};

// A frame to look at.
struct SamplePicture {
  std::string sequence;
  Frame frame;
};

struct AccuracyResult {
  World world;
  std::vector<RenderPlan> plans;  // sharp, then blurred
  std::vector<AccuracyRun> runs;
  std::vector<SamplePicture> pictures;
};

// Renders each frame once and feeds it to every tracker whose sequence has it. Depends on the
// options alone, but for the times it takes.
AccuracyResult RunAccuracy(const AccuracyOptions& options);

}  // namespace silt::experiments
