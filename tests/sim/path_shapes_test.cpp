// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "silt/sim/camera_path.h"
#include "silt/sim/look_at.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;
const ShapeView kAhead{.look_at = {}, .direction = {0, 1, 0}};

template <typename Shape>
CameraPath PathOf(const Shape& shape, const ShapeView& view, const ShapeTiming& timing) {
  return CameraPath(PoseSpline::Through(KeysOf(shape, view, timing)));
}

TEST(PathShapes, AnOrbitIsACircleThatLooksAtItsTarget) {
  const Orbit orbit{{1, 2, 1.5}, 0.8, kPi / 2, -kPi};
  const CameraPath path = PathOf(orbit, {.look_at = Vec3d{1, 2, 0.7}, .direction = {}}, {10, 0});
  EXPECT_EQ(path.duration_s(), 10);
  for (double t = 0; t <= 10; t += 0.37) {
    const SE3d pose = path.WorldFromCamera(t);
    const double angle = kPi / 2 - kPi * t / 10;
    const Vec3d expected{1 + 0.8 * std::cos(angle), 2 + 0.8 * std::sin(angle), 1.5};
    EXPECT_LT(Norm(pose.translation - expected), t < 0.1 || t > 9.9 ? 8e-5 : 8e-6) << t;
    const Vec3d seen = pose.Inverse() * Vec3d{1, 2, 0.7};
    EXPECT_LT(std::hypot(seen.x, seen.y), 1e-4) << t;
    EXPECT_GT(seen.z, 0);
  }
  // |v|²/r: a circle at constant speed.
  EXPECT_NEAR(Norm(path.Motion(5).acceleration), std::pow(kPi / 10, 2) * 0.8, 1e-5);
}

TEST(PathShapes, ALineIsStraightAndEven) {
  const Line line{{0, 0, 1}, {3, 0, 2}};
  const CameraPath path = PathOf(line, kAhead, {6, 0});
  for (double t = 0; t <= 6; t += 0.31) {
    EXPECT_LT(Norm(path.WorldFromCamera(t).translation - Vec3d{t / 2, 0, 1 + t / 6}), 1e-9);
    EXPECT_LT(Norm(path.WorldFromCamera(t).rotation * Vec3d{0, 0, 1} - Vec3d{0, 1, 0}), 1e-9);
  }
}

TEST(PathShapes, EaseStartsFromRestAndComesToRest) {
  const Line line{{0, 0, 1}, {3, 0, 1}};
  const CameraPath path = PathOf(line, kAhead, {7, 1});
  EXPECT_LT(Norm(path.Motion(0).velocity), 2e-4);
  EXPECT_LT(Norm(path.Motion(7).velocity), 2e-4);
  EXPECT_NEAR(path.Motion(0.5).velocity.x, 0.25, 1e-3);  // smoothstep(½) of 3 m in 6 s
  EXPECT_NEAR(path.Motion(6.5).velocity.x, 0.25, 1e-3);
  for (const double t : {1.1, 3.0, 5.9}) EXPECT_NEAR(path.Motion(t).velocity.x, 0.5, 1e-4);
  EXPECT_LT(Norm(path.WorldFromCamera(7).translation - Vec3d{3, 0, 1}), 1e-9);
  EXPECT_LT(Norm(path.WorldFromCamera(3.5).translation - Vec3d{1.5, 0, 1}), 1e-6);
}

TEST(PathShapes, ALissajousFigureFollowsItsFormula) {
  const Lissajous figure{{0, 0, 1.5}, {0.4, 0.2, 0.1}, {0.5, 1, 3}, {0, kPi / 2, 1}};
  const CameraPath path = PathOf(figure, kAhead, {4, 0});
  for (double t = 0.1; t <= 3.9; t += 0.173) {
    const Vec3d expected{0.4 * std::sin(kPi * t), 0.2 * std::cos(2 * kPi * t),
                         1.5 + 0.1 * std::sin(6 * kPi * t + 1)};
    EXPECT_LT(Norm(path.WorldFromCamera(t).translation - expected), 4e-6) << t;
  }
}

TEST(PathShapes, RollLeansTheCamera) {
  ShapeView view = kAhead;
  view.roll_rad = kPi / 2;
  const CameraPath path = PathOf(Line{{0, 0, 1}, {1, 0, 1}}, view, {1, 0});
  EXPECT_LT(Norm(path.WorldFromCamera(0.5).rotation * Vec3d{1, 0, 0} - Vec3d{0, 0, -1}), 1e-9);
}

TEST(PathShapes, RefuseWhatCannotBe) {
  const Line line{{0, 0, 1}, {3, 0, 1}};
  const auto refused = [](const auto& shape, const ShapeView& view, const ShapeTiming& timing) {
    return ErrorOf([&] { KeysOf(shape, view, timing); });
  };
  EXPECT_THAT(refused(line, kAhead, {0, 0}), HasSubstr("duration_s"));
  EXPECT_THAT(refused(line, kAhead, {NAN, 0}), HasSubstr("duration_s"));
  EXPECT_THAT(refused(line, kAhead, {4, 2.1}), HasSubstr("ease_s"));
  EXPECT_THAT(refused(line, kAhead, {4, -1}), HasSubstr("ease_s"));
  EXPECT_THAT(refused(line, kAhead, {1e5, 0}), HasSubstr("too long"));
  EXPECT_THAT(refused(Orbit{{}, 0}, kAhead, {4, 0}), HasSubstr("radius"));
  EXPECT_THAT(refused(Orbit{{}, 1, 0, 0}, kAhead, {4, 0}), HasSubstr("sweep_deg"));
  EXPECT_THAT(refused(Lissajous{{}, {}, {0, 21, 0}, {}}, kAhead, {4, 0}),
              HasSubstr("frequency_hz"));
  EXPECT_THAT(refused(line, {.look_at = {}, .direction = {0, 0, 1}}, {4, 0}),
              HasSubstr("straight up or down"));
  EXPECT_THAT(refused(line, {.look_at = Vec3d{1.5, 0, 0}, .direction = {}}, {4, 0}),
              testing::AnyOf(HasSubstr("straight up or down"), HasSubstr("turns too fast")));
  EXPECT_THAT(refused(line, {.look_at = Vec3d{1.51, 0.01, 1}, .direction = {}}, {4, 0}),
              HasSubstr("turns too fast"));
}

}  // namespace
}  // namespace silt::sim
