// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_renderer.h"

#include "silt/core/random.h"
#include "silt/sim/camera_rays.h"
#include "silt/sim/image_tiles.h"

namespace silt::sim {

namespace {

constexpr int kBlock = CameraRays::kBlock;

void RenderBlock(const PathTracer& tracer, const PathPicture& picture,
                 const RaysOfSample& rays_of_sample, const Vec2<int>& corner, Image<Vec3f>& image) {
  const CounterRandom keys(picture.seed, picture.frame);
  std::uint64_t key[kPacketSize];
  for (int i = 0; i < kPacketSize; ++i) {
    const int x = corner.x + i % kBlock, y = corner.y + i / kBlock;
    key[i] = keys.Bits(std::uint64_t(y) * std::uint64_t(picture.width) + std::uint64_t(x));
  }
  Vec3d sum[kPacketSize];
  for (int k = 0; k < picture.samples_per_pixel; ++k) {
    RayPacket rays;
    rays_of_sample(k, corner.x, corner.y, rays);
    PathSampler samplers[kPacketSize];
    for (int i = 0; i < kPacketSize; ++i) samplers[i] = PathSampler(key[i], std::uint32_t(k));
    Vec3f radiance[kPacketSize];
    tracer.Trace(rays, samplers, radiance);
    for (int i = 0; i < kPacketSize; ++i) sum[i] += radiance[i].Cast<double>();
  }
  for (int i = 0; i < kPacketSize; ++i) {
    const int x = corner.x + i % kBlock, y = corner.y + i / kBlock;
    if (!image.Contains(x, y)) continue;
    image(x, y) = (1.0 / picture.samples_per_pixel * sum[i]).Cast<float>();
  }
}

}  // namespace

Image<Vec3f> RenderPaths(const PathTracer& tracer, const PathPicture& picture,
                         const RaysOfSample& rays_of_sample) {
  Image<Vec3f> image(picture.width, picture.height);
  ForEachTile(picture.width, picture.height, [&](const ImageTile& tile) {
    for (int y = tile.top; y < tile.bottom; y += kBlock) {
      for (int x = tile.left; x < tile.right; x += kBlock) {
        RenderBlock(tracer, picture, rays_of_sample, {x, y}, image);
      }
    }
  });
  return image;
}

}  // namespace silt::sim
