// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/renderer.h"

#include <cmath>
#include <string>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/camera_rays.h"
#include "silt/sim/image_tiles.h"
#include "silt/sim/path_renderer.h"
#include "silt/sim/shading.h"
#include "silt/sim/shutter.h"

namespace silt::sim {

namespace {

// Calls visit(x, y) for the upper left pixel of each packet's block in a tile.
template <typename Visit>
void ForEachBlock(const ImageTile& tile, const Visit& visit) {
  for (int y = tile.top; y < tile.bottom; y += CameraRays::kBlock) {
    for (int x = tile.left; x < tile.right; x += CameraRays::kBlock) visit(x, y);
  }
}

// All that the samples of one frame have in common.
struct Exposure {
  const LitScene& lit;
  const PinholeCamera& camera;
  std::vector<ShutterSample> samples;
  std::vector<CameraRays> rays;  // at the time of each sample
  float pixel_width;             // of a sample's cone, at depth 1
};

void AddSample(const Exposure& exposure, std::size_t k, int x, int y, Image<Vec3f>& sum) {
  RayPacket rays;
  exposure.rays[k].Fill(x, y, exposure.samples[k].offset, rays);
  HitPacket hits;
  exposure.lit.tracer().TraceCoherent(rays, hits);
  for (int i = 0; i < kPacketSize; ++i) {
    if (!rays.valid[i]) continue;
    Vec3f& pixel = sum(x + i % CameraRays::kBlock, y + i / CameraRays::kBlock);
    if (hits.triangle[i] == kNoTriangle) {
      pixel += exposure.lit.scene().Background(
          {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]});
    } else {
      pixel += Shade(exposure.lit, {hits.triangle[i], hits.u[i], hits.v[i], hits.cosine[i],
                                    hits.distance[i] * exposure.pixel_width});
    }
  }
}

// What the ray through a pixel's centre meets.
struct CentreHit {
  const SurfacePlane& plane;
  float depth_m;
  bool front;
};

// Calls visit(x, y, hit) for every pixel that sees something, in parallel.
template <typename Visit>
void ForEachCentreHit(const LitScene& lit, const CameraRays& camera_rays, const Visit& visit) {
  ForEachTile(camera_rays.width(), camera_rays.height(), [&](const ImageTile& tile) {
    ForEachBlock(tile, [&](int left, int top) {
      RayPacket rays;
      camera_rays.Fill(left, top, {}, rays);
      HitPacket hits;
      lit.tracer().TraceCoherent(rays, hits);
      for (int i = 0; i < kPacketSize; ++i) {
        if (hits.triangle[i] == kNoTriangle) continue;
        const int x = left + i % CameraRays::kBlock, y = top + i / CameraRays::kBlock;
        const SurfacePlane& plane = lit.plane(hits.triangle[i]);
        const double z = plane.Distance(camera_rays.origin(), camera_rays.Direction(x, y));
        const bool good = z > 0 && std::isfinite(z);
        visit(x, y, CentreHit{plane, good ? float(z) : hits.distance[i], hits.cosine[i] < 0});
      }
    });
  });
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
  require(shutter.time_samples >= 1 && shutter.time_samples <= 4096,
          "time samples must be 1 to 4096");
}

Renderer::Renderer(Scene scene, const RenderOptions& options, const LightingOptions& lighting)
    : Renderer(std::make_shared<const LitScene>(std::move(scene), lighting), options) {}

Renderer::Renderer(std::shared_ptr<const LitScene> scene, const RenderOptions& options)
    : lit_(std::move(scene)), options_(options), sensor_(options.sensor, options.camera) {
  options_.Validate();
  if (!options.lens.IsNone()) lens_ = std::make_shared<LensMap>(options.camera, options.lens);
}

Image<Vec3f> Renderer::RenderLinear(const PoseAtTime& world_from_camera, double time_s) const {
  const PinholeCamera& camera = options_.camera;
  Exposure exposure{
      *lit_, camera, ShutterSamples(options_.samples_per_pixel, options_.shutter), {}, 0};
  for (const ShutterSample& sample : exposure.samples) {
    exposure.rays.emplace_back(camera, world_from_camera(time_s + sample.time_s), lens_.get());
  }
  const auto count = float(exposure.samples.size());
  exposure.pixel_width = float(1 / std::sqrt(camera.fx * camera.fy)) / std::sqrt(count);

  if (lit_->light() == LightMode::kPath) {
    return RenderPaths(
        lit_->path_tracer(),
        {camera.width, camera.height, int(exposure.samples.size()), options_.seed, 0},
        [&](int k, int x, int y, RayPacket& rays) {
          exposure.rays[std::size_t(k)].Fill(x, y, exposure.samples[std::size_t(k)].offset, rays);
        });
  }
  Image<Vec3f> image(camera.width, camera.height);
  ForEachTile(camera.width, camera.height, [&](const ImageTile& tile) {
    for (std::size_t k = 0; k < exposure.samples.size(); ++k) {
      ForEachBlock(tile, [&](int x, int y) { AddSample(exposure, k, x, y, image); });
    }
    for (int y = tile.top; y < tile.bottom; ++y) {
      for (int x = tile.left; x < tile.right; ++x) image(x, y) = (1 / count) * image(x, y);
    }
  });
  return image;
}

Image<float> Renderer::RenderDepth(const SE3d& world_from_camera) const {
  Image<float> depth_m(options_.camera.width, options_.camera.height);
  ForEachCentreHit(*lit_, {options_.camera, world_from_camera, lens_.get()},
                   [&](int x, int y, const CentreHit& hit) { depth_m(x, y) = hit.depth_m; });
  return depth_m;
}

GeometryBuffers Renderer::RenderGeometry(const SE3d& world_from_camera) const {
  const int width = options_.camera.width, height = options_.camera.height;
  GeometryBuffers buffers{Image<float>(width, height), Image<Vec3f>(width, height),
                          Image<std::uint32_t>(width, height), Image<std::uint32_t>(width, height)};
  const Mat3d camera_from_world = Transposed(world_from_camera.rotation.Matrix());
  ForEachCentreHit(*lit_, {options_.camera, world_from_camera, lens_.get()},
                   [&](int x, int y, const CentreHit& hit) {
                     const Vec3d normal = camera_from_world * hit.plane.normal;
                     buffers.depth_m(x, y) = hit.depth_m;
                     buffers.normal_camera(x, y) = (hit.front ? normal : -normal).Cast<float>();
                     buffers.instance(x, y) = hit.plane.instance;
                     buffers.material(x, y) = hit.plane.material;
                   });
  return buffers;
}

Image<Rgb8> Renderer::Develop(Image<Vec3f> radiance, const NoiseKey& key) const {
  return sensor_.Develop(std::move(radiance), lit_->scene().exposure, key);
}

Frame Renderer::Render(const PoseAtTime& world_from_camera, double time_s, int frame_index) const {
  const NoiseKey key{options_.seed, std::uint32_t(frame_index)};
  return {time_s, Develop(RenderLinear(world_from_camera, time_s), key),
          RenderDepth(world_from_camera(time_s))};
}

}  // namespace silt::sim
