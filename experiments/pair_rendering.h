// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/experiments/case_runner.h"
#include "silt/experiments/pair_alignment.h"

namespace silt::experiments {

// The frames that a camera on the path takes at two times. Throws silt::Error where a time lies
// beyond the path.
FramePair RenderPair(const World& world, const sim::RenderOptions& options, double reference_s,
                     double current_s);

}  // namespace silt::experiments
