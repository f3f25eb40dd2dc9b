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
  // Surfaces reflect as their materials say, on top of baked light, which is that of a matt world.
  // Traced paths always see them so.
  bool specular = false;
  std::uint64_t seed = 0;  // of the directions in which light is gathered

  float direct_spacing_m = 0.025f;   // between the samples at which light is stored
  float indirect_spacing_m = 0.1f;   // at which indirect light is gathered in the open; finer, down
                                     // to the samples themselves, the closer things are
  float bounce_spacing_m = 0.1f;     // and for the reflections before the last
  int light_points = 8;              // along a light's sides, at which its visibility is tested
  int environment_directions = 256;  // drawn from the picture of an environment
  int gather_directions = 384;       // over the hemisphere, for indirect light
  int gather_rounds = 4;             // of so many directions at most, until the standard error is
  float gather_tolerance = 0.035f;   // this share of the light
  int bounce_directions = 32;        // and for the reflections before the last
  int bounces = 10;                  // of these, the rest being extrapolated after the fourth
  // Cells between samples are stored finely where direct light, at the middle of a cell or of one
  // of its borders, differs by more than this share of all light from what the samples say.
  float refine_tolerance = 0.03f;

  // Keep the light of a large scene on disk, see light_cache.h.
  bool cache = true;
  // Called now and then with the share of the work that is done, in [0, 1].
  std::function<void(double)> progress = nullptr;
};

}  // namespace silt::sim
