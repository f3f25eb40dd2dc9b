// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "silt/experiments/light_comparison.h"

namespace silt::experiments {

// References, kept in a folder if one is named, since many paths take long: a picture is traced
// once and read by later runs. A file is named by a fingerprint of the scene, the view and the
// settings, and is thus never that of others.
class TracedPictures {
 public:
  // Throws silt::Error where the folder cannot be made.
  TracedPictures(const PathReference& reference, const std::filesystem::path& folder);

  // Throws silt::Error where a file cannot be read or written.
  ReferencePicture Of(const sim::LitScene& scene, const LightView& view,
                      std::uint32_t number) const;

 private:
  std::filesystem::path FileOf(const std::string& scene_digest, const LightView& view,
                               std::uint32_t number, int half) const;

  PathReference reference_;
  std::filesystem::path folder_;
};

}  // namespace silt::experiments
