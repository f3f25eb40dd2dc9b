// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/core/frame.h"
#include "silt/experiments/json.h"
#include "silt/experiments/pair_alignment.h"
#include "silt/tracker/keyframe_tracker.h"

// §4.1: how long each stage of the tracker takes.
namespace silt::experiments {

struct FrameTiming {
  double time_s = 0;
  bool new_keyframe = false;
  double load_ms = 0;  // from the source: a folder's images read and decoded
  tracker::StageTimes stages;
};

// Feeds a source to a tracker, and times both.
std::vector<FrameTiming> TimeFrames(FrameSource& source, tracker::KeyframeTracker& tracker);

// The paper's figures for the warp and the Jacobian are for one call with the full image.
struct CallTimes {
  double residual_ms = 0;  // Backend::Cost
  double jacobian_ms = 0;  // Backend::Linearize, which computes the residuals too
};

// Medians of `calls` calls at the true motion.
CallTimes TimeFullSizeCalls(const tracker::Backend& backend, const FramePair& pair, int calls);

// One line of the table: the paper's and our median milliseconds.
struct StageTiming {
  std::string stage;
  double paper_ms = 0;
  double median_ms = 0, percentile_90_ms = 0;
};

// The first frame, which only becomes a keyframe, is left out; there must be another one.
std::vector<StageTiming> SummarizeTiming(const std::vector<FrameTiming>& frames,
                                         const CallTimes& calls);

// Lists of flat objects, for JSON and CSV alike.
Json StageRows(const std::vector<StageTiming>& stages);
Json FrameRows(const std::vector<FrameTiming>& frames);

std::string FormatTiming(const std::vector<StageTiming>& stages);

}  // namespace silt::experiments
