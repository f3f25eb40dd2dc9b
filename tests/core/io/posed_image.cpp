// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "posed_image.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace silt {

SequenceFolder::SequenceFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "silt-seq-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("cannot make " + pattern);
  path_ = pattern;
}

std::string ReadText(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace silt
