// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/sequence_writer.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "silt/core/error.h"

namespace silt {

namespace fs = std::filesystem;

bool HasFrame(const fs::path& folder, const SequenceWriter& writer, int number) {
  const std::vector<fs::path> files = writer.FrameFiles(number);
  return std::all_of(files.begin(), files.end(),
                     [&](const fs::path& file) { return fs::is_regular_file(folder / file); });
}

void RequirePinhole(const SequenceDescription& description, const char* format) {
  if (description.lens.IsNone()) return;
  throw Error(std::string("format ") + format +
              ": has no place for a lens's distortion; choose tum, euroc, nerfstudio or colmap");
}

std::string FrameName(int number, const char* extension) {
  char name[16];
  std::snprintf(name, sizeof name, "%06d", number);
  return std::string(name) + extension;
}

}  // namespace silt
