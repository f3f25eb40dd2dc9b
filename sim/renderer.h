// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "silt/core/camera.h"
#include "silt/core/frame.h"
#include "silt/core/lens.h"
#include "silt/core/se3.h"
#include "silt/sim/depth_sensor.h"
#include "silt/sim/exposure.h"
#include "silt/sim/exposure_rays.h"
#include "silt/sim/geometry_buffers.h"
#include "silt/sim/lens_map.h"
#include "silt/sim/lit_scene.h"
#include "silt/sim/sensor.h"

namespace silt::sim {

struct RenderOptions {
  PinholeCamera camera = kIclNuimCamera;
  int samples_per_pixel = 4;
  PixelFilter filter = PixelFilter::kBox;
  PixelPattern pattern = PixelPattern::kShared;
  Shutter shutter = {};
  Exposure exposure = {};
  SensorOptions sensor = {};             // of the colours
  DepthSensorOptions depth_sensor = {};  // perfect
  std::uint64_t seed = 0;                // of the noise of both and of scrambled patterns
  LensDistortion lens = {};              // that colours and depth are seen through

  void Validate() const;  // throws silt::Error
};

// Makes frames of a scene. Frames are byte-identical for any number of threads.
class Renderer {
 public:
  // Takes a scene (copies or moves it) and computes its light.
  explicit Renderer(Scene scene, const RenderOptions& options = {},
                    const LightingOptions& lighting = {});
  // Shares a scene whose light is there already.
  Renderer(std::shared_ptr<const LitScene> scene, const RenderOptions& options);

  // Colours averaged over the exposure about `time_s`; depth at `time_s` itself, as measured.
  Frame Render(const PoseAtTime& world_from_camera, double time_s, int frame_index) const;

  // Mean linear radiance of each pixel over the exposure, without noise. The frame's index only
  // chooses among scrambled patterns.
  Image<Vec3f> RenderLinear(const PoseAtTime& world_from_camera, double time_s,
                            int frame_index = 0) const;

  // The same with an exposure that is only an instant, at each row's middle of its own: the sharp
  // picture that belongs to a blurred one.
  Image<Vec3f> RenderSharp(const PoseAtTime& world_from_camera, double time_s,
                           int frame_index = 0) const;

  // What the sensor makes of radiance.
  Image<Rgb8> Develop(Image<Vec3f> radiance, const NoiseKey& key) const;

  // What the depth sensor measures of geometry that was rendered, in metres.
  Image<float> MeasureDepth(const GeometryBuffers& truth, const NoiseKey& key) const;

  // z of what the ray through each pixel's centre meets, in metres; 0: nothing.
  Image<float> RenderDepth(const SE3d& world_from_camera) const;
  // The same rays, and all that is known of what they meet.
  GeometryBuffers RenderGeometry(const SE3d& world_from_camera) const;

  // The same through the shutter: each row in the middle of its exposure.
  Image<float> RenderDepth(const PoseAtTime& world_from_camera, double time_s) const;
  GeometryBuffers RenderGeometry(const PoseAtTime& world_from_camera, double time_s) const;

  const RenderOptions& options() const { return options_; }
  const std::shared_ptr<const LitScene>& lit_scene() const { return lit_; }

 private:
  Image<Vec3f> RenderThrough(const Shutter& shutter, const PoseAtTime& world_from_camera,
                             double time_s, int frame_index) const;
  Optics optics() const { return {options_.camera, lens_.get()}; }

  std::shared_ptr<const LitScene> lit_;
  RenderOptions options_;
  std::shared_ptr<const LensMap> lens_;  // null without distortion
  Sensor sensor_;
  std::shared_ptr<const DepthSensor> depth_sensor_;
};

}  // namespace silt::sim
