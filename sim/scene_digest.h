// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/sim/scene.h"

namespace silt::sim {

// Whether surfaces count as matt, as stored light takes them, or with their gloss.
enum class SurfacesAre { kMatt, kAsGiven };

// A fingerprint, 32 hexadecimal digits, of all in a scene that light depends on: geometry,
// materials and textures, lights, background. Two scenes that share one look alike at the same
// exposure.
std::string SceneDigest(const Scene& scene, SurfacesAre surfaces);

}  // namespace silt::sim
