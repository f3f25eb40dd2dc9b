// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/renderer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/sim/camera_rays.h"
#include "silt/sim/denormals.h"
#include "silt/sim/response_curve.h"
#include "silt/sim/shading.h"
#include "silt/sim/shutter.h"

namespace silt::sim {

namespace {

// Pixels that one task renders, in packets of 4 × 4.
constexpr int kTile = 16;

void ForTiles(int width, int height, const std::function<void(int x, int y)>& body) {
  const int columns = (width + kTile - 1) / kTile, rows = (height + kTile - 1) / kTile;
  ParallelFor(columns * rows, [&](int i) {
    const ScopedFlushDenormals flush;
    body(i % columns * kTile, i / columns * kTile);
  });
}

// Where along the ray it meets the plane of a triangle: exact, where Embree's own distance is
// rounded to float.
double PlaneDistance(const Mesh& mesh, std::uint32_t number, const Vec3d& origin,
                     const Vec3d& direction) {
  const std::uint32_t* vertex = mesh.triangles[number].vertex;
  const Vec3d a = mesh.positions[vertex[0]].Cast<double>();
  const Vec3d normal = Cross(mesh.positions[vertex[1]].Cast<double>() - a,
                             mesh.positions[vertex[2]].Cast<double>() - a);
  return Dot(normal, a - origin) / Dot(normal, direction);
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
      pixel += exposure.lit.scene().ambient;
    } else {
      pixel += Shade(exposure.lit, {hits.triangle[i], hits.u[i], hits.v[i], hits.cosine[i],
                                    hits.distance[i] * exposure.pixel_width});
    }
  }
}

}  // namespace

void RenderOptions::Validate() const {
  const auto require = [](bool good, const char* what) {
    if (!good) throw Error(std::string("render options: ") + what);
  };
  require(camera.width > 0 && camera.height > 0 && camera.fx > 0 && camera.fy > 0,
          "the camera needs a size and focal lengths above 0");
  require(samples_per_pixel >= 1 && samples_per_pixel <= 4096,
          "samples per pixel must be 1 to 4096");
  require(exposure_s >= 0 && std::isfinite(exposure_s), "the exposure must be 0 s or more");
  require(time_samples >= 1 && time_samples <= 4096, "time samples must be 1 to 4096");
}

Renderer::Renderer(Scene scene, const RenderOptions& options, const LightingOptions& lighting)
    : Renderer(std::make_shared<const LitScene>(std::move(scene), lighting), options) {}

Renderer::Renderer(std::shared_ptr<const LitScene> scene, const RenderOptions& options)
    : lit_(std::move(scene)), options_(options) {
  options_.Validate();
}

Image<Vec3f> Renderer::RenderLinear(const PoseAtTime& world_from_camera, double time_s) const {
  const PinholeCamera& camera = options_.camera;
  Exposure exposure{
      *lit_,
      camera,
      ShutterSamples({options_.samples_per_pixel, options_.exposure_s, options_.time_samples}),
      {},
      0};
  for (const ShutterSample& sample : exposure.samples) {
    exposure.rays.emplace_back(camera, world_from_camera(time_s + sample.time_s));
  }
  const auto count = float(exposure.samples.size());
  exposure.pixel_width = float(1 / std::sqrt(camera.fx * camera.fy)) / std::sqrt(count);

  Image<Vec3f> image(camera.width, camera.height);
  ForTiles(camera.width, camera.height, [&](int left, int top) {
    const int right = std::min(left + kTile, camera.width);
    const int bottom = std::min(top + kTile, camera.height);
    for (std::size_t k = 0; k < exposure.samples.size(); ++k) {
      for (int y = top; y < bottom; y += CameraRays::kBlock) {
        for (int x = left; x < right; x += CameraRays::kBlock) AddSample(exposure, k, x, y, image);
      }
    }
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) image(x, y) = (1 / count) * image(x, y);
    }
  });
  return image;
}

Image<float> Renderer::RenderDepth(const SE3d& world_from_camera) const {
  const PinholeCamera& camera = options_.camera;
  const CameraRays camera_rays(camera, world_from_camera);
  Image<float> depth(camera.width, camera.height);
  const auto block = [&](int x, int y) {
    RayPacket rays;
    camera_rays.Fill(x, y, {}, rays);
    HitPacket hits;
    lit_->tracer().TraceCoherent(rays, hits);
    for (int i = 0; i < kPacketSize; ++i) {
      if (hits.triangle[i] == kNoTriangle) continue;
      const int px = x + i % CameraRays::kBlock, py = y + i / CameraRays::kBlock;
      const double z = PlaneDistance(lit_->scene().mesh, hits.triangle[i], camera_rays.origin(),
                                     camera_rays.Direction(px, py));
      depth(px, py) = z > 0 && std::isfinite(z) ? float(z) : hits.distance[i];
    }
  };
  ForTiles(camera.width, camera.height, [&](int left, int top) {
    for (int y = top; y < std::min(top + kTile, camera.height); y += CameraRays::kBlock) {
      for (int x = left; x < std::min(left + kTile, camera.width); x += CameraRays::kBlock) {
        block(x, y);
      }
    }
  });
  return depth;
}

Image<Rgb8> Renderer::Develop(Image<Vec3f> radiance, const NoiseKey& key) const {
  const auto exposure = float(lit_->scene().exposure);
  for (Vec3f& value : radiance) value = exposure * value;
  if (options_.noise) AddNoise(*options_.noise, key, radiance);
  return EncodeSrgb8(radiance);
}

Frame Renderer::Render(const PoseAtTime& world_from_camera, double time_s, int frame_index) const {
  const NoiseKey key{options_.seed, std::uint32_t(frame_index)};
  return {time_s, Develop(RenderLinear(world_from_camera, time_s), key),
          RenderDepth(world_from_camera(time_s))};
}

}  // namespace silt::sim
