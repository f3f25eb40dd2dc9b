// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace silt::experiments {

// The image files of one pair; the current image may be without a depth.
struct PairFiles {
  std::filesystem::path reference_rgb, reference_depth, current_rgb, current_depth;
};

// A text file with a pair a line, `ref_rgb ref_depth cur_rgb [cur_depth]`; empty lines and those
// that start with # are passed over. A file that is not found as it is named is looked for beside
// the list. Throws silt::Error "file:line: …".
std::vector<PairFiles> ReadPairList(const std::filesystem::path& file);

}  // namespace silt::experiments
