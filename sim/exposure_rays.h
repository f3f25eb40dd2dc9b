// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "silt/sim/camera_rays.h"
#include "silt/sim/pixel_samples.h"
#include "silt/sim/shutter.h"

namespace silt::sim {

// world_from_camera at a time in seconds.
using PoseAtTime = std::function<SE3d(double time_s)>;

// How a frame's pixels are covered.
struct PixelSampling {
  int samples_per_pixel = 4;
  PixelFilter filter = PixelFilter::kBox;
  PixelPattern pattern = PixelPattern::kShared;
  // Of the scrambled pattern.
  std::uint64_t seed = 0;
  std::uint32_t frame = 0;
};

// The rays of a frame: sample k of every pixel, k < count().
class ExposureRays {
 public:
  // Asks for the pose at all times that it needs at once.
  ExposureRays(const Optics& optics, const PixelSampling& sampling, const Shutter& shutter,
               const PoseAtTime& world_from_camera, double time_s);

  const PinholeCamera& camera() const { return optics_.camera; }
  int count() const { return count_; }
  // Width of the cone around a ray, at depth 1: that of a pixel, however many samples it has. Cones
  // that only together fill the pixel leave more detail than its neighbours can carry: frames of
  // the office, warped onto each other, then differ by a third more (silt experiment
  // photo-consistency).
  float cone_width() const { return cone_width_; }

  // Sample k of a block of pixels, see CameraRays::Fill.
  void Fill(int k, int x, int y, RayPacket& rays) const;

 private:
  CameraRays RaysAt(double time_s) const;  // relative to the frame's time
  PixelSample SampleOf(int k, int column, int row) const;

  Optics optics_;
  Shutter shutter_;
  std::uint64_t seed_;
  std::uint32_t frame_;
  int count_;
  float cone_width_;
  std::vector<PixelSample> shared_;  // by k; empty: scrambled
  std::optional<ScrambledSamples> scrambled_;
  // Where all rays of a sample share a time, the rays at that time, by k. Else the rays at times
  // first_s_ + i·step_s_ relative to the frame's, so close together that between them all is
  // linear.
  std::vector<CameraRays> rays_;
  bool moving_ = false;
  double first_s_ = 0, step_s_ = 1;
};

}  // namespace silt::sim
