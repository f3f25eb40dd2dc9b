// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "scene_builder.h"
#include "silt/core/error.h"
#include "silt/sim/path_file.h"
#include "silt/sim/renderer.h"

// Pictures seen through a lens, against Brown's formula and OpenCV's reading of it.
namespace silt::sim {
namespace {

constexpr LensDistortion kLens{-0.28, 0.09, 0.003, -0.002, -0.01};

LightingOptions NoLight() {
  LightingOptions options;
  options.direct_spacing_m = options.indirect_spacing_m = 10;
  options.gather_directions = options.bounce_directions = 16;
  return options;
}

cv::Mat Coefficients() {
  return (cv::Mat_<double>(1, 5) << kLens.k1, kLens.k2, kLens.p1, kLens.p2, kLens.k3);
}
cv::Matx33d Intrinsics(const PinholeCamera& camera) {
  return {camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1};
}

TEST(RendererLens, ProjectsAsOpenCvDoes) {
  const std::vector<cv::Point3d> points{{0.3, -0.2, 1}, {-1.1, 0.8, 2}, {0, 0.5, 1.25}};
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), Intrinsics(kIclNuimCamera), Coefficients(),
                    pixels);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2d pixel =
        ProjectThroughLens(kIclNuimCamera, kLens, Vec3d{points[i].x, points[i].y, points[i].z});
    EXPECT_NEAR(pixel.x, pixels[i].x, 1e-9);
    EXPECT_NEAR(pixel.y, pixels[i].y, 1e-9);
  }
}

// Depth of a board whose upper left corner is `corner`, in the camera's frame; it reaches beyond
// the picture to the right and below.
Image<float> BoardDepth(const PinholeCamera& camera, const Vec3d& corner) {
  SceneBuilder builder;
  builder.AddQuad(corner.Cast<float>(), {9, 0, 0}, {0, 9, 0}, builder.AddMaterial(Vec3f{}));
  const RenderOptions options{.camera = camera, .lens = kLens};
  return Renderer(builder.scene, options, NoLight()).RenderDepth({});
}

// Where a corner is said to project, the picture shows it: the pixels about it see the board or
// miss it as the camera is shifted by a thousandth of a pixel either way.
TEST(RendererLens, CornersAreWhereTheyProjectToAThousandthOfAPixel) {
  for (const Vec3d& corner : {Vec3d{-0.55, -0.4, 1}, Vec3d{0.5, 0.375, 1}, Vec3d{1.25, -0.75, 2},
                              Vec3d{0.01, -0.02, 0.5}}) {
    // Puts the corner on the centre of pixel (30, 20), whichever part of the lens it is seen
    // through.
    PinholeCamera camera{300, 310, 0, 0, 60, 40};
    const Vec2d at = ProjectThroughLens(camera, kLens, corner);
    camera.cx = 30 - at.x;
    camera.cy = 20 - at.y;
    for (const double shift : {-1e-3, 1e-3}) {
      PinholeCamera shifted = camera;
      shifted.cx += shift;
      // Below the corner, where the lens bends its edge by less than a thousandth of a pixel.
      shifted.cy += -1e-3;
      EXPECT_EQ(BoardDepth(shifted, corner)(30, 20) > 0, shift < 0) << corner.x;
      shifted = camera;
      shifted.cx += -1e-3;
      shifted.cy += shift;
      EXPECT_EQ(BoardDepth(shifted, corner)(30, 20) > 0, shift < 0) << corner.x;
    }
  }
}

// Depth and normals of a wall, seen along the bent ray.
TEST(RendererLens, DepthAndNormalsAreThoseOfTheBentRay) {
  SceneBuilder builder;
  builder.AddQuad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, builder.AddMaterial(Vec3f{}));
  const PinholeCamera camera{120, 121, 79.5, 59.5, 160, 120};
  const SE3d pose = LookAt({0, 0, 3}, {1, 2, 0});
  const Renderer renderer(builder.scene, {.camera = camera, .lens = kLens}, NoLight());
  const GeometryBuffers geometry = renderer.RenderGeometry(pose);
  const Vec3d up = pose.Inverse().rotation * Vec3d{0, 0, 1};
  for (int y = 0; y < camera.height; y += 7) {
    for (int x = 0; x < camera.width; x += 7) {
      const Vec2d p =
          kLens.Undistort(Vec2d{(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy});
      const double z = -pose.translation.z / (pose.rotation * Vec3d{p.x, p.y, 1}).z;
      if (!(z > 0 && z < 40)) continue;
      EXPECT_NEAR(geometry.depth_m(x, y) / z, 1, 1e-6);
      EXPECT_NEAR(Norm(geometry.normal_camera(x, y).Cast<double>() - up), 0, 1e-6);
    }
  }
}

double RootMeanSquare(const Image<Vec3f>& a, const Image<Vec3f>& b) {
  double sum = 0;
  int count = 0;
  for (int y = 8; y < a.height() - 8; ++y) {
    for (int x = 8; x < a.width() - 8; ++x, ++count) {
      const double d = double(a(x, y).x - b(x, y).x);
      sum += d * d;
    }
  }
  return std::sqrt(sum / count);
}

// cv::undistort brings a picture through the lens back to that of a pinhole, up to its bilinear
// interpolation; without it they are far apart.
TEST(RendererLens, OpenCvUndistortsThePicture) {
  const PinholeCamera camera{240, 240, 159.5, 119.5, 320, 240};
  const auto room = std::make_shared<const LitScene>(RoomWithBoxAndBall(), NoLight());
  const SE3d pose = LookAt({0.2, -1.9, 1.5}, {0, 1, 0.7});
  const auto render = [&](const LensDistortion& lens) {
    const RenderOptions options{.camera = camera, .samples_per_pixel = 16, .lens = lens};
    return Renderer(room, options).RenderLinear([&](double) { return pose; }, 0);
  };
  Image<Vec3f> bent = render(kLens), undistorted(camera.width, camera.height);
  const Image<Vec3f> straight = render({});
  cv::Mat out(camera.height, camera.width, CV_32FC3, undistorted.data());
  cv::undistort(cv::Mat(camera.height, camera.width, CV_32FC3, bent.data()), out,
                Intrinsics(camera), Coefficients());
  ASSERT_EQ(out.data, reinterpret_cast<unsigned char*>(undistorted.data()));
  EXPECT_LT(RootMeanSquare(undistorted, straight), 0.15 * RootMeanSquare(bent, straight));
}

TEST(RendererLens, RefusesALensThatFoldsThePicture) {
  const RenderOptions options{.lens = {-2, 0, 0, 0, 0}};
  EXPECT_THROW(Renderer(Scene{}, options, NoLight()), Error);
}

}  // namespace
}  // namespace silt::sim
