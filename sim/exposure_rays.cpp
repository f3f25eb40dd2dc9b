// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/exposure_rays.h"

#include <algorithm>
#include <cmath>

namespace silt::sim {

namespace {

// Between poses so far apart, a hand that turns back and forth by 20 rad/s² bends by 1e-7 rad.
constexpr double kPoseStep_s = 2e-4;
constexpr int kMostPoses = 1 << 13;

int SampleCount(const PixelSampling& sampling, const Shutter& shutter) {
  const bool blurred = shutter.exposure_s > 0;
  return blurred ? std::max(sampling.samples_per_pixel, shutter.time_samples)
                 : sampling.samples_per_pixel;
}

}  // namespace

ExposureRays::ExposureRays(const Optics& optics, const PixelSampling& sampling,
                           const Shutter& shutter, const PoseAtTime& world_from_camera,
                           double time_s)
    : optics_(optics),
      shutter_(shutter),
      seed_(sampling.seed),
      frame_(sampling.frame),
      count_(SampleCount(sampling, shutter)),
      cone_width_(float(1 / std::sqrt(optics.camera.fx * optics.camera.fy))) {
  if (sampling.pattern == PixelPattern::kShared) {
    shared_ = SharedSamples(count_, sampling.filter);
  } else {
    scrambled_.emplace(count_, sampling.filter);
  }
  const bool scrambled_time = scrambled_ && shutter.exposure_s > 0;
  const bool rolling = shutter.row_time_s != 0 && optics.camera.height > 1;
  moving_ = rolling || scrambled_time;
  if (!moving_) {
    for (const PixelSample& sample : shared_) {
      rays_.emplace_back(optics, world_from_camera(time_s + shutter.exposure_s * sample.time));
    }
    if (shared_.empty()) rays_.emplace_back(optics, world_from_camera(time_s));
    return;
  }
  const double length_s = shutter.exposure_s + shutter.row_time_s * (optics.camera.height - 1);
  const int steps = int(std::clamp(std::ceil(length_s / kPoseStep_s), 1.0, double(kMostPoses)));
  first_s_ = -length_s / 2;
  step_s_ = length_s / steps;
  for (int i = 0; i <= steps; ++i) {
    rays_.emplace_back(optics, world_from_camera(time_s + first_s_ + i * step_s_));
  }
}

CameraRays ExposureRays::RaysAt(double time_s) const {
  const double step = (time_s - first_s_) / step_s_;
  const int before = std::clamp(int(step), 0, int(rays_.size()) - 2);
  return {rays_[std::size_t(before)], rays_[std::size_t(before) + 1], step - before};
}

void ExposureRays::Fill(int k, int x, int y, RayPacket& rays) const {
  if (!moving_ && !scrambled_) {
    rays_[std::size_t(k)].Fill(x, y, shared_[std::size_t(k)].offset, rays);
    return;
  }
  for (int i = 0; i < kPacketSize; ++i) {
    int column = x + i % CameraRays::kBlock, row = y + i / CameraRays::kBlock;
    const bool inside = column < optics_.camera.width && row < optics_.camera.height;
    if (!inside) column = x, row = y;
    const PixelSample sample = SampleOf(k, column, row);
    const double u = column + sample.offset.x, v = row + sample.offset.y;
    if (moving_) {
      const double row_s = shutter_.RowTime(row, optics_.camera.height);
      RaysAt(row_s + shutter_.exposure_s * sample.time).FillLane(i, u, v, rays);
    } else {
      rays_.front().FillLane(i, u, v, rays);
    }
    if (!inside) rays.valid[i] = 0;
  }
}

PixelSample ExposureRays::SampleOf(int k, int column, int row) const {
  if (!scrambled_) return shared_[std::size_t(k)];
  const auto pixel =
      std::uint32_t(row) * std::uint32_t(optics_.camera.width) + std::uint32_t(column);
  return scrambled_->At(k, ScrambledSamples::KeyOf(seed_, frame_, pixel));
}

}  // namespace silt::sim
