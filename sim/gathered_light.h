// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "silt/sim/indirect_light.h"
#include "silt/sim/sample_clusters.h"

namespace silt::sim {

// How wide an area shares one gathering: a fixed part of the harmonic mean distance to all that is
// seen from there, which is known at the leaders of coarser clusters; less towards the edge of
// these, since what is near may be nearer there. One of few widths, from `finest_m` to `widest_m`.
std::vector<float> GatherWidths(const std::vector<SurfaceSample>& samples,
                                const SampleClusters& coarse,
                                const std::vector<float>& leader_distance_m, float finest_m,
                                float widest_m);

// The same where more is known: what each sample itself sees nearby.
void NarrowBy(const std::vector<Gathered>& near, float finest_m, std::vector<float>& width_m);

// Light at all samples from that gathered at the leaders: a weighted mean of the leaders within
// one and a half widths that lie in the sample's plane and face alike. Buried ones do not count.
std::vector<Vec3f> Interpolated(const std::vector<SurfaceSample>& samples,
                                const SampleClusters& clusters, const std::vector<float>& width_m,
                                const std::vector<Gathered>& gathered);

// Gives buried samples the light of the nearest open ones in their plane, up to `radius_m` away: a
// triangle that sticks out of a solid is not darkened by its part within.
void FillBuried(const std::vector<SurfaceSample>& samples, const std::vector<bool>& buried,
                float radius_m, std::vector<Vec3f>& irradiance);

}  // namespace silt::sim
