// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/optical_flow.h"

#include <algorithm>
#include <cmath>

#include "silt/core/error.h"
#include "silt/sim/camera_rays.h"
#include "silt/sim/image_tiles.h"

namespace silt::sim {
namespace {

bool InPicture(const PinholeCamera& camera, const Vec2d& p) {
  return p.x >= -0.5 && p.y >= -0.5 && p.x < camera.width - 0.5 && p.y < camera.height - 0.5;
}

// Rows lie microseconds apart: between two of them a pose moves evenly.
SE3d PoseOfRow(const RowPoses& poses, double row) {
  const auto index = std::min(std::size_t(row), poses.size() - 1);
  const double share = row - double(index);
  if (share == 0 || index + 1 == poses.size()) return poses[index];
  const SE3d &a = poses[index], &b = poses[index + 1];
  const Vec3d turn = (a.rotation.Conjugate() * b.rotation).Log();
  return {a.rotation * Quaterniond::Exp(share * turn),
          a.translation + share * (b.translation - a.translation)};
}

// Rays that wait until a packet is full, each for a pixel of one row.
class HiddenTest {
 public:
  HiddenTest(const RayTracer& tracer, std::uint8_t* states) : tracer_(tracer), states_(states) {}
  ~HiddenTest() { Flush(); }
  HiddenTest(const HiddenTest&) = delete;
  HiddenTest& operator=(const HiddenTest&) = delete;

  void Add(int x, const Vec3d& eye, const Vec3d& point) {
    const Vec3d ray = point - eye;
    const double distance_m = Norm(ray);
    const auto far = float(1 - double(kHiddenBy_m) / distance_m);
    if (far <= 0) return;
    rays_.Set(count_, {eye.Cast<float>(), ray.Cast<float>(), 0, far});
    pixel_[count_++] = x;
    if (count_ == kPacketSize) Flush();
  }

 private:
  void Flush() {
    const std::uint32_t hidden = count_ > 0 ? tracer_.Occluded(rays_) : 0;
    for (int i = 0; i < count_; ++i) {
      if (hidden >> i & 1) states_[pixel_[i]] = std::uint8_t(FlowState::kHidden);
      rays_.valid[i] = 0;
    }
    count_ = 0;
  }

  const RayTracer& tracer_;
  std::uint8_t* states_;
  RayPacket rays_;
  int pixel_[kPacketSize] = {};
  int count_ = 0;
};

}  // namespace

RowPoses PosesOfRows(const Shutter& shutter, int height, const PoseAtTime& world_from_camera,
                     double time_s) {
  if (shutter.row_time_s == 0) return {world_from_camera(time_s)};
  RowPoses poses;
  for (int y = 0; y < height; ++y) {
    poses.push_back(world_from_camera(time_s + shutter.RowTime(y, height)));
  }
  return poses;
}

OpticalFlow::OpticalFlow(const RayTracer& tracer, const PinholeCamera& camera,
                         const LensDistortion& lens)
    : tracer_(tracer), camera_(camera), lens_(lens) {
  if (!lens.IsNone()) lens_map_.emplace(camera, lens);
}

// Far outside the picture a lens's polynomial turns back into it: what is seen inside must be the
// image of this very point.
std::optional<Vec2d> OpticalFlow::Project(const Vec3d& point) const {
  constexpr double kSame_px = 1e-3;
  if (!(point.z > 0)) return std::nullopt;
  if (!lens_map_) return camera_.Project(point);
  const Vec2d there = ProjectThroughLens(camera_, lens_, point);
  if (!InPicture(camera_, there)) return there;
  const Vec2d gap = lens_map_->PinholePixel(there.x, there.y) - camera_.Project(point);
  if (!(gap.x * gap.x + gap.y * gap.y < kSame_px * kSame_px)) return std::nullopt;
  return there;
}

// The row y in which a point is seen obeys y = v(pose(y)): a contraction, since a shutter rolls
// much faster than what it sees moves.
std::optional<OpticalFlow::Sight> OpticalFlow::See(const Vec3d& world,
                                                   const RowPoses& camera_from_world) const {
  constexpr int kSteps = 8;
  constexpr double kSame_px = 1e-7;
  const auto last = double(camera_from_world.size() - 1);
  double row = last / 2;
  for (int i = 0; i < kSteps; ++i) {
    const SE3d pose = PoseOfRow(camera_from_world, row);
    const std::optional<Vec2d> pixel = Project(pose * world);
    if (!pixel) return std::nullopt;
    const double next = std::clamp(pixel->y, 0.0, last);
    if (std::abs(next - row) < kSame_px || i == kSteps - 1) {
      return Sight{*pixel, pose.Inverse().translation};
    }
    row = next;
  }
  return std::nullopt;
}

FlowField OpticalFlow::Between(const Image<float>& depth_m, const RowPoses& from,
                               const RowPoses& to) const {
  const int width = camera_.width, height = camera_.height;
  SILT_CHECK(depth_m.width() == width && depth_m.height() == height);
  SILT_CHECK(from.size() == 1 || from.size() == std::size_t(height));
  SILT_CHECK(to.size() == 1 || to.size() == std::size_t(height));
  FlowField field{Image<Vec2f>(width, height, {kNoFlow, kNoFlow}),
                  Image<std::uint8_t>(width, height, std::uint8_t(FlowState::kNothing))};
  const Optics optics(camera_, lens_map_ ? &*lens_map_ : nullptr);
  RowPoses camera_from_world;
  for (const SE3d& pose : to) camera_from_world.push_back(pose.Inverse());
  const auto pixel = [&](int x, int y, const CameraRays& rays, HiddenTest& hidden) {
    const double z = depth_m(x, y);
    if (!(z > 0)) return;
    const Vec3d world = rays.origin() + z * rays.Direction(x, y);
    field.state(x, y) = std::uint8_t(FlowState::kOutside);
    const std::optional<Sight> sight = See(world, camera_from_world);
    if (!sight) return;
    field.flow_px(x, y) = {float(sight->pixel.x - x), float(sight->pixel.y - y)};
    if (!InPicture(camera_, sight->pixel)) return;
    field.state(x, y) = std::uint8_t(FlowState::kSeen);
    hidden.Add(x, sight->eye, world);
  };
  ForEachTile(width, height, [&](const ImageTile& tile) {
    for (int y = tile.top; y < tile.bottom; ++y) {
      const CameraRays rays(optics, from[from.size() == 1 ? 0 : std::size_t(y)]);
      HiddenTest hidden(tracer_, field.state.row(y));
      for (int x = tile.left; x < tile.right; ++x) pixel(x, y, rays, hidden);
    }
  });
  return field;
}

}  // namespace silt::sim
