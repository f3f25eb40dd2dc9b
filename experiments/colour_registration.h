// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace silt::experiments {

// One line for people where alignments of a preset doubt the colours of a keyframe with this
// contrast (see tracker::ImageContent::edge_contrast); empty where they do not.
std::string DoubtOfColours(const std::string& preset, double edge_contrast);

}  // namespace silt::experiments
