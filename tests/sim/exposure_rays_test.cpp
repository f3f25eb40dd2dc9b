
#include "silt/sim/exposure_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{100, 110, 4.5, 3.5, 10, 8};

// Moves along x at 1 m/s: a ray's origin tells its time.
SE3d Sliding(double time_s) { return SE3d::Exp({{}, {time_s, 0, 0}}); }

struct Ray {
  double time_s;
  Vec2d pixel;
};

// The ray of a pixel in sample k.
Ray RayOf(const ExposureRays& rays, int k, int x, int y) {
  RayPacket packet;
  rays.Fill(k, x / 4 * 4, y / 4 * 4, packet);
  const int i = x % 4 + y % 4 * 4;
  EXPECT_NE(packet.valid[i], 0);
  return {packet.origin_x[i],
          kCamera.Project({packet.direction_x[i], packet.direction_y[i], packet.direction_z[i]})};
}

PixelSampling Scrambled(int n) {
  return {.samples_per_pixel = n, .pattern = PixelPattern::kScrambled};
}

TEST(ExposureRays, AnInstantHasTheSamplesOfThePixelAlone) {
  const ExposureRays rays(kCamera, {.samples_per_pixel = 4}, {0, 16}, Sliding, 3);
  EXPECT_EQ(rays.count(), 4);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(RayOf(rays, k, 5, 6).time_s, 3);
}

TEST(ExposureRays, AnExposureHasAtLeastTheInstantsAskedFor) {
  EXPECT_EQ(ExposureRays(kCamera, {}, {0.01, 16}, Sliding, 0).count(), 16);
  EXPECT_EQ(ExposureRays(kCamera, {.samples_per_pixel = 64}, {0.01, 16}, Sliding, 0).count(), 64);
}

TEST(ExposureRays, ConesAreAsWideAsThePixel) {
  const ExposureRays rays(kCamera, {.samples_per_pixel = 16}, {}, Sliding, 0);
  EXPECT_NEAR(rays.cone_width(), 1 / std::sqrt(100 * 110.0), 1e-9);
}

TEST(ExposureRays, CoverPixelsAndTheExposureAboutItsMiddle) {
  for (const PixelSampling& sampling : {PixelSampling{.samples_per_pixel = 16}, Scrambled(16)}) {
    const double exposure_s = 0.02, middle_s = 0.5;
    const ExposureRays rays(kCamera, sampling, {exposure_s, 1}, Sliding, middle_s);
    for (const Vec2d& pixel : {Vec2d{0, 0}, Vec2d{9, 7}, Vec2d{6, 2}}) {
      std::set<int> parts;
      for (int k = 0; k < 16; ++k) {
        const Ray ray = RayOf(rays, k, int(pixel.x), int(pixel.y));
        EXPECT_LE(std::abs(ray.pixel.x - pixel.x), 0.5001);
        EXPECT_LE(std::abs(ray.pixel.y - pixel.y), 0.5001);
        const double share = (ray.time_s - middle_s) / exposure_s + 0.5;
        parts.insert(int(std::floor(share * 16 + 1e-4)));
        EXPECT_TRUE(share > -1e-4 && share < 1 + 1e-4) << share;
      }
      EXPECT_EQ(parts.size(), 16u);
    }
  }
}

TEST(ExposureRays, SharedOnesAreTheSameInEveryPixelAndScrambledOnesAreNot) {
  const auto offset = [](const ExposureRays& rays, int x, int y) {
    const Vec2d pixel = RayOf(rays, 2, x, y).pixel;
    return Vec2d{pixel.x - x, pixel.y - y};
  };
  const ExposureRays shared(kCamera, {}, {}, Sliding, 0),
      own(kCamera, Scrambled(4), {}, Sliding, 0);
  EXPECT_NEAR(offset(shared, 1, 2).x, offset(shared, 8, 7).x, 1e-4);
  EXPECT_GT(std::abs(offset(own, 1, 2).x - offset(own, 8, 7).x), 1e-3);
  const ExposureRays shared_in_time(kCamera, {}, {0.1, 4}, Sliding, 0);
  EXPECT_EQ(RayOf(shared_in_time, 1, 1, 2).time_s, RayOf(shared_in_time, 1, 8, 7).time_s);
  const ExposureRays own_in_time(kCamera, Scrambled(4), {0.1, 4}, Sliding, 0);
  EXPECT_NE(RayOf(own_in_time, 1, 1, 2).time_s, RayOf(own_in_time, 1, 8, 7).time_s);
}

TEST(ExposureRays, RowsOfARollingShutterAreLateByTheirPlace) {
  const double row_time_s = 1e-3, middle_s = 0.25;
  for (const double exposure_s : {0.0, 0.004}) {
    const Shutter shutter{exposure_s, 4, row_time_s};
    for (const PixelSampling& sampling : {PixelSampling{}, Scrambled(4)}) {
      const ExposureRays rays(kCamera, sampling, shutter, Sliding, middle_s);
      for (int y = 0; y < kCamera.height; ++y) {
        const double row_s = middle_s + (y - 3.5) * row_time_s;
        for (int k = 0; k < 4; ++k) {
          const double part_s = row_s + ((k + 0.5) / 4 - 0.5) * exposure_s;
          EXPECT_NEAR(RayOf(rays, k, 6, y).time_s, part_s, exposure_s / 8 + 1e-7);
        }
      }
    }
  }
}

// What lies between two of the poses that were asked for.
TEST(ExposureRays, FollowATurningCameraBetweenPoses) {
  const auto turning = [](double t) { return SE3d::Exp({{0, 30 * t * t, 5 * t}, {0, t, 0}}); };
  const ExposureRays rays(kCamera, {.samples_per_pixel = 1}, {0, 1, 7e-4}, turning, 0.1);
  for (int y = 0; y < kCamera.height; ++y) {
    RayPacket packet;
    rays.Fill(0, 4, y / 4 * 4, packet);
    const int i = 1 + y % 4 * 4;
    const SE3d pose = turning(0.1 + (y - 3.5) * 7e-4);
    const Vec3d truth = pose.rotation * kCamera.Unproject(5, y, 1.0);
    const Vec3d error =
        Vec3f{packet.direction_x[i], packet.direction_y[i], packet.direction_z[i]}.Cast<double>() -
        truth;
    EXPECT_LT(Norm(error), 1e-6);
  }
}

}  // namespace
}  // namespace silt::sim
