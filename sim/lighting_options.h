// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace silt::sim {

// How finely light is stored on the surfaces, and how carefully it is computed.
struct LightingOptions {
  float direct_spacing_m = 0.025f;   // between samples of light that comes from lights
  float indirect_spacing_m = 0.08f;  // and of light that comes from surfaces and the ambient
  int light_points = 16;             // at which a light's visibility is tested
  // Directions over the hemisphere for indirect light: on surfaces larger than its spacing, where
  // the eye sees every step, and on small parts.
  int wide_gather_directions = 256;
  int small_gather_directions = 64;

  // Keep the light of a large scene on disk, see light_cache.h.
  bool cache = true;
  // Called now and then with the share of the work that is done, in [0, 1].
  std::function<void(double)> progress = nullptr;
};

}  // namespace silt::sim
