// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/camera.h"

#include <gtest/gtest.h>

#include "silt/core/image.h"
#include "silt/core/pyramid.h"

namespace silt {
namespace {

constexpr PinholeCamera kSkewed{90, 70, 31.25, 17.5, 67, 45};

// A ramp painted on the plane z = 1: its block mean is its value at the block's centre.
double Ramp(const Vec3d& p) { return 0.3 * p.x - 0.7 * p.y + 0.5; }

Image<float> Project(const PinholeCamera& camera) {
  Image<float> image(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) image(x, y) = float(Ramp(camera.Unproject(x, y, 1.0)));
  }
  return image;
}

float LargestDifference(const Image<float>& a, const Image<float>& b) {
  EXPECT_EQ(a.width(), b.width());
  EXPECT_EQ(a.height(), b.height());
  float largest = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      largest = std::max(largest, std::abs(a(x, y) - b(x, y)));
    }
  }
  return largest;
}

TEST(CameraTest, ProjectInvertsUnproject) {
  for (double z : {0.3, 1.0, 7.5}) {
    const Vec2d pixel = kSkewed.Project(kSkewed.Unproject(12.25, 40.5, z));
    EXPECT_NEAR(pixel.x, 12.25, 1e-12);
    EXPECT_NEAR(pixel.y, 40.5, 1e-12);
    EXPECT_EQ(kSkewed.Unproject(12.25, 40.5, z).z, z);
  }
}

TEST(CameraTest, ProjectsRightAndDownToGrowingPixels) {
  const Vec2d pixel = kSkewed.Project({0.2, 0.1, 2.0});
  EXPECT_DOUBLE_EQ(pixel.x, 90 * 0.1 + 31.25);
  EXPECT_DOUBLE_EQ(pixel.y, 70 * 0.05 + 17.5);
}

// What the coarser camera sees of the ramp is what the 2×2 means show of it, on every level: so
// a halved principal point is (c + ½)/2 − ½, even where a column or a row drops.
TEST(CameraTest, HalvedCameraSeesTheBlockMeans) {
  PinholeCamera camera = kSkewed;
  Image<float> image = Project(camera);
  for (int level = 1; level <= 3; ++level) {
    camera = camera.Halved();
    image = HalvedIntensity(image);
    EXPECT_LT(LargestDifference(image, Project(camera)), 1e-6f) << "level " << level;
  }
}

// The twin that must fail: c/2 puts level 1 a quarter of a pixel off.
TEST(CameraTest, TheRampTellsAQuarterPixel) {
  PinholeCamera off = kSkewed.Halved();
  off.cx = kSkewed.cx / 2;
  EXPECT_GT(LargestDifference(HalvedIntensity(Project(kSkewed)), Project(off)), 1e-3f);
}

TEST(CameraTest, IclNuimCameraIsCentred) {
  // The centre of the image lies between the middle pixels, on every level.
  PinholeCamera camera = kIclNuimCamera;
  for (int level = 0; level < 4; ++level, camera = camera.Halved()) {
    EXPECT_DOUBLE_EQ(camera.cx, (camera.width - 1) / 2.0);
    EXPECT_DOUBLE_EQ(camera.cy, (camera.height - 1) / 2.0);
  }
}

TEST(CameraTest, CastKeepsEveryField) {
  const auto camera = kSkewed.Cast<float>();
  EXPECT_EQ(camera.fx, 90.0f);
  EXPECT_EQ(camera.fy, 70.0f);
  EXPECT_EQ(camera.cx, 31.25f);
  EXPECT_EQ(camera.cy, 17.5f);
  EXPECT_EQ(camera.width, 67);
  EXPECT_EQ(camera.height, 45);
}

}  // namespace
}  // namespace silt
