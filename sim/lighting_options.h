// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

namespace silt::sim {

// Where pixels get their light from: what was stored on the surfaces once, or paths traced for each
// pixel, which is exact, slow and noisy.
enum class LightMode { kBaked, kPath };

// How finely light is stored on the surfaces, and how carefully it is computed.
struct LightingOptions {
  LightMode mode = LightMode::kBaked;
  bool specular = false;   // surfaces reflect as their materials say (kBaked; kPath always does)
  std::uint64_t seed = 0;  // of the directions in which light is gathered

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
