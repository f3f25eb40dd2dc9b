// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/tracker/alignment.h"
#include "silt/tracker/backend.h"
#include "silt/tracker/levenberg_marquardt.h"

namespace silt::tracker {

// What an optimizer that wants nothing any more has found, for pyramids of these levels.
AlignmentResult ResultOf(const LevenbergMarquardt& optimizer, const AlignmentPlan& plan,
                         const PyramidLevels& levels, const AlignmentOptions& options);

}  // namespace silt::tracker
