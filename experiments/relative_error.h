// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "silt/core/trajectory.h"
#include "silt/experiments/association.h"
#include "silt/experiments/statistics.h"

namespace silt::experiments {

// How long a window of the relative pose error is.
enum class WindowUnit { kFrames, kSeconds, kMetres };

struct Window {
  double length = 1;
  WindowUnit unit = WindowUnit::kSeconds;
};

// Drift over a window: of the motion from the window's first to its last pose.
struct RelativeError {
  Window window;
  Statistics translation_m, rotation_deg;
};

// The relative pose error; nothing where the trajectories are shorter than a window. With Q the
// true and P the estimated poses:
//   evo: consecutive windows over the associated poses, E = (Qᵢ⁻¹·Qⱼ)⁻¹·(Pᵢ⁻¹·Pⱼ);
//   TUM's evaluate_rpe.py --fixed_delta: a window from every estimated pose, each end compared with
//   the true pose nearest in time (at most two median intervals of the truth away),
//   E = (Pⱼ⁻¹·Pᵢ)⁻¹·(Qⱼ⁻¹·Qᵢ).
// Both measure a window's length in metres along the estimate.
std::optional<RelativeError> RelativePoseError(const Trajectory& truth, const Trajectory& estimate,
                                               const Window& window, Convention convention);

}  // namespace silt::experiments
