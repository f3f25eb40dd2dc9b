// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/ray_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene_builder.h"

namespace silt::sim {
namespace {

HitPacket TraceOne(const RayTracer& tracer, const RayPacket::Segment& ray) {
  RayPacket rays;
  rays.Set(5, ray);
  HitPacket hits;
  tracer.Trace(rays, hits);
  return hits;
}

TEST(RayTracer, NamesTheNearestTriangleAndItsSide) {
  SceneBuilder builder;
  const int material = builder.AddMaterial(Vec3f{1, 1, 1});
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, material);  // triangles 0, 1; front is +z
  builder.AddQuad({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, material);  // triangles 2, 3
  const RayTracer tracer(builder.scene);
  const HitPacket above = TraceOne(tracer, {{0.5f, -0.25f, 3}, {0, 0, -2}});
  EXPECT_EQ(above.triangle[5], 2u);
  EXPECT_FLOAT_EQ(above.distance[5], 1);
  EXPECT_FLOAT_EQ(above.cosine[5], -1);
  const HitPacket below = TraceOne(tracer, {{-0.5f, 0.25f, -1}, {0.6f, 0, 0.8f}});
  EXPECT_EQ(below.triangle[5], 0u);
  EXPECT_FLOAT_EQ(below.cosine[5], 0.8f);
  EXPECT_EQ(above.triangle[4], kNoTriangle);  // not a valid ray
}

TEST(RayTracer, BarycentricsLeadToThePoint) {
  SceneBuilder builder;
  builder.AddQuad({0, 0, 0}, {2, 0, 0}, {0, 1, 0}, builder.AddMaterial(Vec3f{1, 1, 1}));
  const RayTracer tracer(builder.scene);
  const HitPacket hits = TraceOne(tracer, {{1.5f, 0.3f, 1}, {0, 0, -1}});
  const Mesh& mesh = builder.scene.mesh;
  const Vec2f uv = TexcoordAt(mesh, mesh.triangles[hits.triangle[5]], hits.u[5], hits.v[5]);
  EXPECT_NEAR(uv.x, 0.75f, 1e-6f);
  EXPECT_NEAR(uv.y, 0.3f, 1e-6f);
}

// Whatever they hold. Processors that take eight rays at a time hand such lanes to Embree too.
TEST(RayTracer, LanesWithoutARayMeetNothing) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{1, 1, 1}));
  const RayTracer tracer(builder.scene);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  RayPacket rays;
  for (int lane = 0; lane < kPacketSize; ++lane) {
    rays.Set(lane, {{0, 0.5f, 1}, {0, 0, lane % 2 == 0 ? -1.0f : nan}, lane % 3 == 0 ? -1.0f : 0});
    rays.valid[lane] = 0;
  }
  rays.Set(9, {{0, 0.5f, 1}, {0, 0, -1}});
  HitPacket hits;
  tracer.Trace(rays, hits);
  for (int lane = 0; lane < kPacketSize; ++lane) {
    EXPECT_EQ(hits.triangle[lane] == kNoTriangle, lane != 9) << lane;
  }
  EXPECT_EQ(tracer.Occluded(rays), 1u << 9);
}

TEST(RayTracer, OcclusionEndsWithTheSegment) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{1, 1, 1}));
  const RayTracer tracer(builder.scene);
  RayPacket rays;
  rays.Set(0, {{0, 0.5f, 1}, {0, 0, -1}, 0, 1.01f});
  rays.Set(1, {{0, 0.5f, 1}, {0, 0, -1}, 0, 0.99f});
  rays.Set(2, {{0, 0.5f, 1}, {0, 0, -1}, 1.01f, 5});
  rays.Set(15, {{0, 0.5f, -1}, {0, 0, 1}});
  EXPECT_EQ(tracer.Occluded(rays), 1u | 1u << 15);
}

// A texture whose left half is opaque and right half clear.
Scene HalfCutOut() {
  SceneBuilder builder;
  Image<Rgba8> picture(8, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) picture(x, y).a = x < 4 ? 255 : 0;
  }
  builder.scene.textures.emplace_back(picture);
  Material leaf;
  leaf.texture = 0;
  leaf.cutout = true;
  builder.AddQuad({0, 0, 1}, {1, 0, 0}, {0, 1, 0}, builder.AddMaterial(leaf));
  builder.AddQuad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, builder.AddMaterial(Vec3f{1, 1, 1}));
  return builder.scene;
}

TEST(RayTracer, CutOutsLetRaysAndShadowsThrough) {
  const Scene scene = HalfCutOut();
  const RayTracer tracer(scene);
  EXPECT_FLOAT_EQ(TraceOne(tracer, {{0.25f, 0.6f, 2}, {0, 0, -1}}).distance[5], 1);
  EXPECT_FLOAT_EQ(TraceOne(tracer, {{0.75f, 0.6f, 2}, {0, 0, -1}}).distance[5], 2);
  RayPacket rays;
  rays.Set(0, {{0.25f, 0.6f, 2}, {0, 0, -1}, 0, 1.5f});
  rays.Set(1, {{0.75f, 0.6f, 2}, {0, 0, -1}, 0, 1.5f});
  EXPECT_EQ(tracer.Occluded(rays), 1u);
}

TEST(RayTracer, AMeshWithoutTrianglesIsEmptySpace) {
  const Scene scene;
  EXPECT_EQ(TraceOne(RayTracer(scene), {{0, 0, 0}, {0, 0, 1}}).triangle[5], kNoTriangle);
}

// Rays from inside a closed ball towards points of its edges hit it.
TEST(RayTracer, NoRaySlipsBetweenTwoTriangles) {
  SceneBuilder builder;
  builder.AddSphere({0, 0, 0}, 1, 64, builder.AddMaterial(Vec3f{1, 1, 1}));
  const RayTracer tracer(builder.scene);
  const Mesh& mesh = builder.scene.mesh;
  const Vec3f eye{0.01f, 0.02f, 0.03f};
  int missed = 0;
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3f a = mesh.positions[triangle.vertex[0]], b = mesh.positions[triangle.vertex[1]];
    RayPacket rays;
    for (int k = 0; k < kPacketSize; ++k) {
      const float along = (float(k) + 0.5f) / kPacketSize;
      rays.Set(k, {eye, (1 - along) * a + along * b - eye});
    }
    HitPacket hits;
    tracer.Trace(rays, hits);
    for (const std::uint32_t hit : hits.triangle) missed += hit == kNoTriangle;
  }
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace silt::sim
