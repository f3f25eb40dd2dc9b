// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "silt/experiments/accuracy.h"

// What each choice of a preset gains: the preset beside itself with one choice made otherwise.
namespace silt::experiments {

// One choice made otherwise.
struct Alternative {
  std::string changes;  // as PresetOptions takes them after the preset's name: "joint=1"
  std::string meaning;  // a few words
};

// Those worth a look at a preset of this name; of one without choices of its own, none.
std::vector<Alternative> AlternativesTo(const std::string& preset);

// One sequence tracked with one alternative, or, of the empty one, as the preset is.
struct AblationCell {
  std::string sequence;
  double position_rmse_cm = 0, ate_aligned_cm = 0;
  double ratio = 1;  // of the position's RMSE to the preset's own
  int lost = 0;
  double ms_per_frame = 0;
};

struct AblationRow {
  Alternative alternative;
  std::vector<AblationCell> cells;  // one per sequence

  double MeanRatio() const;  // the geometric mean over the sequences
};

// `accuracy` says all but the trackers. The first row is the preset as it is. Errors are means over
// the seeds.
std::vector<AblationRow> RunAblation(const AccuracyOptions& accuracy, const std::string& preset,
                                     const std::vector<Alternative>& alternatives);

// The same on recorded sequences that have true poses, as `silt render` leaves them; the cells have
// the names of the folders. Throws silt::Error for a folder without them.
struct RecordedSequences {
  std::vector<std::filesystem::path> folders;
  std::string backend = "cpu";
};
std::vector<AblationRow> RunAblation(const RecordedSequences& recorded, const std::string& preset,
                                     const std::vector<Alternative>& alternatives);

// A table for a page or a terminal.
std::string FormatMarkdown(const std::vector<AblationRow>& rows);
// One flat object for each row and sequence.
Json ToJson(const std::vector<AblationRow>& rows);

}  // namespace silt::experiments
