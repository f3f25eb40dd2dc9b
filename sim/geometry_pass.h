// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/centre_rays.h"
#include "silt/sim/geometry_buffers.h"
#include "silt/sim/lit_scene.h"

namespace silt::sim {

// What the rays through the pixels' centres meet; depths are exact, see SurfacePlane.
GeometryBuffers TraceGeometry(const LitScene& lit, const CentreRays& rays);
Image<float> TraceDepth(const LitScene& lit, const CentreRays& rays);

}  // namespace silt::sim
