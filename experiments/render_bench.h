// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/experiments/case_runner.h"
#include "silt/experiments/json.h"

// How fast frames are rendered, beside what Embree alone takes for the same rays.
namespace silt::experiments {

struct RenderBenchOptions {
  int width = 640;
  int instants = 5;  // of the path, evenly spread, of which frames are rendered
  int repeats = 5;   // of which the fastest counts

  Json ToJson() const;
};

// One way to render. Seconds are processor time of all threads for a frame, the mean over the
// instants of the least of all repeats: other programs on the machine disturb that less than they
// disturb the clock on the wall.
struct RenderSpeed {
  std::string name;
  double rays = 0;   // of a frame
  double raw_s = 0;  // for rtcIntersect16 alone, on packets that lie ready
  double cpu_s = 0, wall_s = 0;

  double Ratio() const { return raw_s / cpu_s; }  // of throughput to that of Embree alone
  double Fps() const { return 1 / wall_s; }
  // With all threads at work.
  double MegaRays(int threads) const { return 1e-6 * rays / cpu_s * threads; }
  double RawMegaRays(int threads) const { return 1e-6 * rays / raw_s * threads; }
};

// Where the time of a frame of four samples goes, in nanoseconds of one processor for each ray.
struct RenderCosts {
  double embree_ns = 0;         // rtcIntersect16
  double rays_and_hits_ns = 0;  // making rays, packing them for Embree, unpacking its hits
  double shading_ns = 0;        // light, textures and sums
};

struct RenderBench {
  RenderSpeed geometry;    // depth, normals and ids, a ray for each pixel
  RenderSpeed baked_4spp;  // 8-bit colours of 4 samples, and depth
  RenderSpeed blur_16;     // the same with 16 instants in a full exposure of 1/60 s
  RenderCosts costs;

  Json ToJson(int threads) const;
  std::string Format(int threads) const;
};

// Each repeat measures everything once, so that all is slowed alike by what else the machine does.
RenderBench MeasureRendering(const World& world, const RenderBenchOptions& options);

}  // namespace silt::experiments
