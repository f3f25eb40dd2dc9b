// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/optical_flow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_builder.h"
#include "silt/sim/path_file.h"
#include "silt/sim/renderer.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{120.3, 120, 79.5, 59.5, 160, 120};

LightingOptions NoLight() {
  LightingOptions options;
  options.direct_spacing_m = options.indirect_spacing_m = 10;
  options.gather_directions = options.bounce_directions = 16;
  return options;
}

FlowState StateAt(const FlowField& field, int x, int y) { return FlowState(field.state(x, y)); }

// Flow between two poses of a camera in a scene.
FlowField Flow(const Renderer& renderer, const SE3d& from, const SE3d& to) {
  return OpticalFlow(renderer.lit_scene()->tracer(), renderer.options().camera)
      .Between(renderer.RenderDepth(from), from, to);
}

// A wall 4 m ahead (world y = 4) that fills the view and a board 2 m ahead, |x| < 0.3 m,
// |z − 1| < 0.2 m, before it. Cameras look along y.
Scene WallAndBoard() {
  SceneBuilder builder;
  const int gray = builder.AddMaterial(Vec3f{0.5f, 0.5f, 0.5f});
  builder.AddQuad({-50, 4, -50}, {100, 0, 0}, {0, 0, 100}, gray);
  builder.AddQuad({-0.3f, 2, 0.8f}, {0.6f, 0, 0}, {0, 0, 0.4f}, gray);
  return builder.scene;
}

class BoardFlow : public testing::Test {
 protected:
  const Renderer renderer_{WallAndBoard(), {.camera = kCamera}, NoLight()};
  const SE3d here_ = LookAt({0, 0, 1}, {0, 4, 1});

  static bool OnBoard(int x, int y) {
    return std::abs(x - kCamera.cx) / kCamera.fx * 2 < 0.3 &&
           std::abs(y - kCamera.cy) / kCamera.fy * 2 < 0.2;
  }
};

// Through a lens: what the pinhole's flow joins, seen through the lens at both ends.
TEST_F(BoardFlow, GoesThroughTheLens) {
  const LensDistortion lens{-0.25, 0.06, 0.002, -0.001, 0};
  const Renderer renderer(renderer_.lit_scene(), {.camera = kCamera, .lens = lens});
  const SE3d there = LookAt({0.2, 0.1, 1.05}, {0.1, 4, 1});
  const FlowField flow = OpticalFlow(renderer.lit_scene()->tracer(), kCamera, lens)
                             .Between(renderer.RenderDepth(here_), here_, there);
  double worst_px = 0;
  int count = 0;
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      if (StateAt(flow, x, y) != FlowState::kSeen) continue;
      const Vec2d ray =
          lens.Undistort(Vec2d{(x - kCamera.cx) / kCamera.fx, (y - kCamera.cy) / kCamera.fy});
      const double z = std::abs(ray.x) * 2 < 0.3 && std::abs(ray.y) * 2 < 0.2 ? 2 : 4;
      const Vec3d point = there.Inverse() * (here_ * Vec3d{z * ray.x, z * ray.y, z});
      const Vec2d expected = ProjectThroughLens(kCamera, lens, point);
      worst_px = std::max(worst_px, std::hypot(flow.flow_px(x, y).x - (expected.x - x),
                                               flow.flow_px(x, y).y - (expected.y - y)));
      ++count;
    }
  }
  EXPECT_GT(count, 10000);
  EXPECT_LT(worst_px, 1e-3);
}

// A camera that rises at w m/s behind a shutter that rolls by r s a row sees a point of the wall at
// height H in the row v with v − cy = fy·(w·(t + r·(v − cy)) − H)/z: linear in v.
TEST_F(BoardFlow, GoesThroughARollingShutter) {
  const double rise_m_s = 2, row_s = 2e-4, z = 4, next_s = 0.1;
  const Shutter shutter{.row_time_s = row_s};
  const auto pose = [&](double t) {
    return LookAt({0, 0, 1 + rise_m_s * t}, {0, 4, 1 + rise_m_s * t});
  };
  const RowPoses from = PosesOfRows(shutter, kCamera.height, pose, 0),
                 to = PosesOfRows(shutter, kCamera.height, pose, next_s);
  const OpticalFlow flow(renderer_.lit_scene()->tracer(), kCamera);
  const FlowField rolling =
      flow.Between(Image<float>(kCamera.width, kCamera.height, float(z)), from, to);
  double worst_px = 0;
  for (int y = 0; y < kCamera.height; ++y) {
    const double down = y - kCamera.cy;
    const double height_m = rise_m_s * row_s * down - down / kCamera.fy * z;
    const double there = kCamera.cy + kCamera.fy * (rise_m_s * next_s - height_m) / z /
                                          (1 - kCamera.fy * rise_m_s * row_s / z);
    // Beyond the last row there is none to tell the time.
    if (there > kCamera.height - 1) continue;
    worst_px = std::max(worst_px, std::abs(double(rolling.flow_px(80, y).y) - (there - y)));
    EXPECT_NEAR(rolling.flow_px(80, y).x, 0, 1e-4);
  }
  EXPECT_LT(worst_px, 1e-4);
  EXPECT_EQ(PosesOfRows({}, kCamera.height, pose, 0).size(), 1u);
}

// A step to the right by b moves what is at depth z to the left by fx·b/z.
TEST_F(BoardFlow, OfASidewaysStepIsTheDisparity) {
  const double step_m = 0.1;
  const FlowField flow = Flow(renderer_, here_, LookAt({step_m, 0, 1}, {step_m, 4, 1}));
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const double z = OnBoard(x, y) ? 2 : 4;
      ASSERT_NEAR(flow.flow_px(x, y).x, -kCamera.fx * step_m / z, 1e-4) << x << ", " << y;
      ASSERT_NEAR(flow.flow_px(x, y).y, 0, 1e-4);
    }
  }
}

// Seen from the right, the board hides the wall where fx·0.3/2 shifts it over it: known by formula
// for every pixel.
TEST_F(BoardFlow, TellsWhatTheBoardHidesAndWhatLeavesThePicture) {
  const double step_m = 0.4;
  const FlowField flow = Flow(renderer_, here_, LookAt({step_m, 0, 1}, {step_m, 4, 1}));
  int hidden = 0, outside = 0;
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const double z = OnBoard(x, y) ? 2 : 4;
      const double there = x - kCamera.fx * step_m / z;
      FlowState expected = FlowState::kSeen;
      if (there < -0.5) {
        expected = FlowState::kOutside;
      } else if (z == 4) {
        // Where the ray to the wall's point passes the board's plane, half way.
        const double board_x = step_m + 0.5 * ((x - kCamera.cx) / kCamera.fx * 4 - step_m);
        const double board_z = 0.5 * (y - kCamera.cy) / kCamera.fy * 4;
        if (std::abs(board_x) < 0.3 && std::abs(board_z) < 0.2) expected = FlowState::kHidden;
      }
      ASSERT_EQ(StateAt(flow, x, y), expected) << x << ", " << y;
      hidden += expected == FlowState::kHidden;
      outside += expected == FlowState::kOutside;
    }
  }
  EXPECT_GT(hidden, 100);
  EXPECT_GT(outside, 100);
}

TEST_F(BoardFlow, BehindTheCameraThereIsNone) {
  const FlowField flow = Flow(renderer_, here_, LookAt({0, 5, 1}, {0, 9, 1}));
  for (const std::uint8_t state : flow.state) {
    ASSERT_EQ(state, std::uint8_t(FlowState::kOutside));
  }
  EXPECT_EQ(flow.flow_px(80, 60).x, kNoFlow);
}

TEST(OpticalFlow, WhereNothingIsThereIsNone) {
  SceneBuilder builder;
  builder.AddQuad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, builder.AddMaterial(Vec3f{}));
  const Renderer renderer(builder.scene, {.camera = kCamera}, NoLight());
  const SE3d pose = LookAt({0, 0, 1}, {5, 0, 1});
  const FlowField flow = Flow(renderer, pose, pose);
  EXPECT_EQ(StateAt(flow, 80, 10), FlowState::kNothing);
  EXPECT_EQ(flow.flow_px(80, 10).y, kNoFlow);
}

// Distance along a ray whose z is 1 in the camera to a sphere; NaN beside it.
double SphereDepth(const Vec3d& origin, const Vec3d& direction, const Vec3d& center,
                   double radius) {
  const Vec3d o = origin - center;
  const double a = Dot(direction, direction), b = Dot(o, direction),
               c = Dot(o, o) - radius * radius;
  return (-b - std::sqrt(b * b - a * c)) / a;
}

// The promise: 0.01 px. Truth by formula: a finely tessellated sphere, whose sagitta of r·(π/n)²/2
// = 3e-5 m shows as up to 5e-3 px under this motion.
TEST(OpticalFlow, OnASphereIsWithinAHundredthOfAPixel) {
  SceneBuilder builder;
  builder.AddSphere({0, 3, 1}, 1, 400, builder.AddMaterial(Vec3f{}));
  const Renderer renderer(builder.scene, {.camera = kIclNuimCamera}, NoLight());
  const SE3d here = LookAt({0, 0, 1}, {0, 3, 1}), there = LookAt({0.2, 0.1, 1.1}, {0, 3, 0.9});
  const FlowField flow = Flow(renderer, here, there);
  double worst_px = 0;
  int count = 0;
  for (int y = 0; y < kIclNuimCamera.height; ++y) {
    for (int x = 0; x < kIclNuimCamera.width; ++x) {
      const Vec3d direction = here.rotation * kIclNuimCamera.Unproject(double(x), double(y), 1.0);
      const double z = SphereDepth(here.translation, direction, {0, 3, 1}, 1);
      const Vec3d normal = here.translation + z * direction - Vec3d{0, 3, 1};
      // At the rim, where the ray grazes, depth itself is ill-conditioned.
      if (!(-Dot(normal, Normalized(direction)) > 0.2)) continue;
      const Vec2d expected =
          kIclNuimCamera.Project(there.Inverse() * (here.translation + z * direction));
      worst_px = std::max(worst_px, std::hypot(flow.flow_px(x, y).x - (expected.x - x),
                                               flow.flow_px(x, y).y - (expected.y - y)));
      ++count;
    }
  }
  RecordProperty("worst_px", std::to_string(worst_px));
  EXPECT_GT(count, 30000);
  EXPECT_LT(worst_px, 0.01);
}

// There and back again: the flow at the place that a pixel goes to leads home.
TEST(OpticalFlow, ForwardAndBackwardAreInverse) {
  const Renderer renderer(RoomWithBoxAndBall(), {.camera = kCamera}, NoLight());
  const SE3d a = LookAt({0.5, -1.5, 1.4}, {0, 1, 0.8}),
             b = LookAt({0.6, -1.4, 1.45}, {0.1, 1, 0.8});
  const FlowField forward = Flow(renderer, a, b), backward = Flow(renderer, b, a);
  std::vector<double> gaps_px;
  int seen = 0;
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      if (StateAt(forward, x, y) != FlowState::kSeen) continue;
      ++seen;
      const Vec2f f = forward.flow_px(x, y);
      const double u = double(x) + double(f.x), v = double(y) + double(f.y);
      const int left = int(std::floor(u)), top = int(std::floor(v));
      if (left < 0 || top < 0 || left + 1 >= kCamera.width || top + 1 >= kCamera.height) continue;
      Vec2d back;
      for (int i = 0; i < 4; ++i) {
        const int px = left + i % 2, py = top + i / 2;
        const double weight =
            (i % 2 ? u - left : 1 - (u - left)) * (i / 2 ? v - top : 1 - (v - top));
        back = back + weight * Vec2d{backward.flow_px(px, py).x, backward.flow_px(px, py).y};
      }
      gaps_px.push_back(std::hypot(f.x + back.x, f.y + back.y));
    }
  }
  ASSERT_GT(seen, kCamera.width * kCamera.height / 2);
  // Bilinear interpolation is wrong across edges of depth alone.
  std::sort(gaps_px.begin(), gaps_px.end());
  EXPECT_LT(gaps_px[gaps_px.size() / 2], 2e-3);
  EXPECT_LT(gaps_px[gaps_px.size() * 9 / 10], 0.02);
}

// A camera at rest sees all that it sees, however it is posed: no surface hides itself.
TEST(OpticalFlow, WithoutMotionEverythingIsSeenWhereItIs) {
  const Renderer renderer(RoomWithBoxAndBall(), {.camera = kCamera}, NoLight());
  for (const SE3d& pose :
       {LookAt({0.5, -1.5, 1.4}, {0, 1, 0.8}), LookAt({-1, 1, 0.1}, {1, -1, 0.05})}) {
    const FlowField flow = Flow(renderer, pose, pose);
    int hidden = 0, wandering = 0;
    for (std::size_t i = 0; i < flow.state.size(); ++i) {
      hidden += flow.state.data()[i] == std::uint8_t(FlowState::kHidden);
      const Vec2f& f = flow.flow_px.data()[i];
      wandering += std::hypot(f.x, f.y) > 1e-4;
    }
    EXPECT_EQ(hidden, 0);
    EXPECT_EQ(wandering, 0);
  }
}

}  // namespace
}  // namespace silt::sim
