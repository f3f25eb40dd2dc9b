// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/experiments/case_runner.h"

namespace silt::experiments {

// The studio and its path, loaded and lit once per process.
inline const World& StudioWorld() {
  static const World world = LoadWorld(SILT_SOURCE_DIR "/scenes/studio", "");
  return world;
}

// A small picture of the paper's camera; four pyramid levels are down to a height of 30.
inline sim::RenderOptions SmallPictures(int width = 320) {
  sim::RenderOptions options = PaperRenderOptions(false);
  options.camera = IclNuimCameraOfWidth(width);
  return options;
}

}  // namespace silt::experiments
