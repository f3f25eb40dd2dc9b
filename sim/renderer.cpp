// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/renderer.h"

#include <cmath>
#include <string>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/geometry_pass.h"
#include "silt/sim/path_renderer.h"
#include "silt/sim/radiance_pass.h"

namespace silt::sim {

namespace {

// Asks for no more than depth.
bool MeasuresTruth(const DepthSensorOptions& sensor) {
  return sensor.model == "perfect" && sensor.dropouts.AreNone();
}

}  // namespace

void RenderOptions::Validate() const {
  const auto require = [](bool good, const char* what) {
    if (!good) throw Error(std::string("render options: ") + what);
  };
  require(camera.width > 0 && camera.height > 0 && camera.fx > 0 && camera.fy > 0,
          "the camera needs a size and focal lengths above 0");
  require(samples_per_pixel >= 1 && samples_per_pixel <= 65536,
          "samples per pixel must be 1 to 65536");
  require(shutter.exposure_s >= 0 && std::isfinite(shutter.exposure_s),
          "the exposure must be 0 s or more");
  require(exposure.value > 0 && std::isfinite(exposure.value), "the exposure must be above 0");
  require(shutter.row_time_s >= 0 && std::isfinite(shutter.row_time_s),
          "the row time must be 0 s or more");
  require(shutter.time_samples >= 1 && shutter.time_samples <= 4096,
          "time samples must be 1 to 4096");
}

Renderer::Renderer(Scene scene, const RenderOptions& options, const LightingOptions& lighting)
    : Renderer(std::make_shared<const LitScene>(std::move(scene), lighting), options) {}

Renderer::Renderer(std::shared_ptr<const LitScene> scene, const RenderOptions& options)
    : lit_(std::move(scene)),
      options_((options.Validate(), options)),
      lens_(options.lens.IsNone() ? nullptr
                                  : std::make_shared<LensMap>(options.camera, options.lens)),
      sensor_(options.sensor, options.camera, lens_.get()),
      depth_sensor_(MakeDepthSensor(options.depth_sensor)) {}

Image<Vec3f> Renderer::RenderLinear(const PoseAtTime& world_from_camera, double time_s,
                                    int frame_index) const {
  return RenderThrough(options_.shutter, world_from_camera, time_s, frame_index);
}

Image<Vec3f> Renderer::RenderSharp(const PoseAtTime& world_from_camera, double time_s,
                                   int frame_index) const {
  Shutter instant = options_.shutter;
  instant.exposure_s = 0;
  return RenderThrough(instant, world_from_camera, time_s, frame_index);
}

Image<Vec3f> Renderer::RenderThrough(const Shutter& shutter, const PoseAtTime& world_from_camera,
                                     double time_s, int frame_index) const {
  const auto frame = std::uint32_t(frame_index);
  const PixelSampling sampling{options_.samples_per_pixel, options_.filter, options_.pattern,
                               options_.seed, frame};
  const ExposureRays rays(optics(), sampling, shutter, world_from_camera, time_s);
  if (lit_->light() == LightMode::kBaked) return TraceRadiance(*lit_, rays);
  return RenderPaths(
      lit_->path_tracer(),
      {options_.camera.width, options_.camera.height, rays.count(), options_.seed, frame},
      [&](int k, int x, int y, RayPacket& packet) { rays.Fill(k, x, y, packet); });
}

Image<float> Renderer::RenderDepth(const SE3d& world_from_camera) const {
  return TraceDepth(*lit_, CentreRays(optics(), world_from_camera));
}

Image<float> Renderer::RenderDepth(const PoseAtTime& world_from_camera, double time_s) const {
  return TraceDepth(*lit_, CentreRays(optics(), options_.shutter, world_from_camera, time_s));
}

GeometryBuffers Renderer::RenderGeometry(const SE3d& world_from_camera) const {
  return TraceGeometry(*lit_, CentreRays(optics(), world_from_camera));
}

GeometryBuffers Renderer::RenderGeometry(const PoseAtTime& world_from_camera, double time_s) const {
  return TraceGeometry(*lit_, CentreRays(optics(), options_.shutter, world_from_camera, time_s));
}

Image<Rgb8> Renderer::Develop(Image<Vec3f> radiance, const NoiseKey& key) const {
  double exposure = lit_->scene().exposure;
  if (options_.exposure.kind == Exposure::Kind::kGiven) exposure = options_.exposure.value;
  if (options_.exposure.kind == Exposure::Kind::kPerFrame) exposure = MeteredExposure({radiance});
  return sensor_.Develop(std::move(radiance), exposure, key);
}

Image<float> Renderer::MeasureDepth(const GeometryBuffers& truth, const NoiseKey& key) const {
  return depth_sensor_->Measure({options_.camera, lens_.get(), truth}, key);
}

Frame Renderer::Render(const PoseAtTime& world_from_camera, double time_s, int frame_index) const {
  const NoiseKey key{options_.seed, std::uint32_t(frame_index)};
  return {time_s, Develop(RenderLinear(world_from_camera, time_s, frame_index), key),
          MeasuresTruth(options_.depth_sensor)
              ? RenderDepth(world_from_camera, time_s)
              : MeasureDepth(RenderGeometry(world_from_camera, time_s), key)};
}

}  // namespace silt::sim
