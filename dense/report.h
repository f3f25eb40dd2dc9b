// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/core/raw_sequence.h"

namespace silt::dense {

struct ReportOptions {
  std::string backend = "cuda";
  int frames = 0;      // of the sequence, from its start; 0: all
  int repeats = 200;   // of the refinement
  int starts = 20000;  // of the batch
  std::string commit = "unknown";
};

struct Report {
  std::string json, text;
  bool agrees = true;  // with the CPU backend
};

// Tracks the frames with the presets paper, accurate and fast by both the CPU and the backend,
// compares, and measures refinement and batch.
Report MakeReport(const std::vector<RawFrame>& frames, const ReportOptions& options);

}  // namespace silt::dense
