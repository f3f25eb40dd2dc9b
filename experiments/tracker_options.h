// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/json.h"
#include "silt/tracker/options.h"

namespace silt::experiments {

std::vector<std::string> PresetNames();

// A preset's options: "accurate"; or with some of them changed: "accurate:joint=1:robust_scale=0".
// The names are those of ToJson, without the group; a list has its entries joined by hyphens, from
// the finest pyramid level to the coarsest: "max_iterations=2-5-20-20"; yes and no are 1 and 0.
// Throws silt::Error for a name that is none and a value that its option cannot have.
tracker::TrackerOptions PresetOptions(const std::string& preset);

// All of them by name, those of the alignment and the keyframes in groups of their own.
Json ToJson(const tracker::TrackerOptions& options);

}  // namespace silt::experiments
