// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/radiance_pass.h"

#include "silt/sim/image_tiles.h"

namespace silt::sim {

namespace {

// Sums of a packet's pixels.
struct alignas(64) PacketSum {
  Float4 lane[kPacketSize] = {};
};

Float4 WithReflection(const LitScene& lit, const Float4& matt, const RayPacket& rays,
                      const HitPacket& hits, int i) {
  const Reflection* reflection = lit.reflection();
  if (!reflection || !reflection->Reflects(hits.triangle[i])) return matt;
  return Float4From(
      reflection->Over(Vec3From(matt), {hits.triangle[i], hits.u[i], hits.v[i], hits.cosine[i] < 0},
                       {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]}));
}

void AddPacket(const LitScene& lit, const RayPacket& rays, float cone_width, PacketSum& sum) {
  HitPacket hits;
  lit.tracer().TraceCoherent(rays, hits);
  const Shading& shading = lit.shading();
  int lane[kPacketSize], count = 0;  // of those that hit
  for (int i = 0; i < kPacketSize; ++i) {
    if (hits.triangle[i] != kNoTriangle) {
      shading.Prefetch(hits.triangle[i]);
      lane[count++] = i;
    } else if (rays.valid[i] != 0) {
      sum.lane[i] += Float4From(
          lit.scene().Background({rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]}));
    }
  }
  Shading::Place places[kPacketSize];
  for (int j = 0; j < count; ++j) {
    const int i = lane[j];
    shading.Find({hits.triangle[i],
                  hits.u[i],
                  hits.v[i],
                  hits.cosine[i],
                  hits.distance[i] * cone_width,
                  {rays.direction_x[i], rays.direction_y[i], rays.direction_z[i]}},
                 places[j]);
  }
  for (int j = 0; j < count; ++j) {
    const int i = lane[j];
    sum.lane[i] += WithReflection(lit, places[j].Read(), rays, hits, i);
  }
}

// All samples of a tile, one after the other, so that neighbours find their surfaces in the cache.
void RenderTile(const LitScene& lit, const ExposureRays& rays, const ImageTile& tile,
                Image<Vec3f>& image) {
  PacketSum sums[ImageTile::kSide * ImageTile::kSide / kPacketSize];
  for (int k = 0; k < rays.count(); ++k) {
    PacketSum* sum = sums;
    ForEachBlock(tile, [&](int x, int y) {
      RayPacket packet;
      rays.Fill(k, x, y, packet);
      AddPacket(lit, packet, rays.cone_width(), *sum++);
    });
  }
  const float scale = 1 / float(rays.count());
  const PacketSum* sum = sums;
  ForEachBlock(tile, [&](int left, int top) {
    for (int i = 0; i < kPacketSize; ++i) {
      const int x = left + i % CameraRays::kBlock, y = top + i / CameraRays::kBlock;
      if (image.Contains(x, y)) image(x, y) = Vec3From(scale * sum->lane[i]);
    }
    ++sum;
  });
}

}  // namespace

Image<Vec3f> TraceRadiance(const LitScene& lit, const ExposureRays& rays) {
  Image<Vec3f> image(rays.camera().width, rays.camera().height);
  ForEachTile(image.width(), image.height(),
              [&](const ImageTile& tile) { RenderTile(lit, rays, tile, image); });
  return image;
}

}  // namespace silt::sim
