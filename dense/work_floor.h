// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/tracker/alignment.h"

namespace silt::dense {

// The least that alignments must read and compute, counted by hand from tracker/kernel, whatever
// the implementation: each solve linearizes every pixel of its level once more.
struct Work {
  double passes = 0;      // over all pixels of a level
  double bytes = 0;       // of images, each read once a pass
  double operations = 0;  // in single precision, of measured pixels or not

  Work& operator+=(const Work& other);
  Work operator*(double factor) const;
};

Work WorkOf(const tracker::AlignmentResult& alignment, const tracker::AlignmentOptions& options);

}  // namespace silt::dense
