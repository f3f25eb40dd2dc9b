// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/colmap_sequence.h"

#include <utility>

#include "silt/core/atomic_file.h"
#include "silt/core/formatted.h"
#include "silt/core/io/image_file.h"
#include "silt/core/pyramid.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

std::string CameraText(const PinholeCamera& c, const LensDistortion& l) {
  if (!l.IsNone()) {
    return "# CAMERA_ID MODEL WIDTH HEIGHT fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6\n" +
           Formatted("1 FULL_OPENCV %d %d %.12g %.12g %.12g %.12g", c.width, c.height, c.fx, c.fy,
                     c.cx + 0.5, c.cy + 0.5) +
           Formatted(" %.12g %.12g %.12g %.12g %.12g 0 0 0\n", l.k1, l.k2, l.p1, l.p2, l.k3);
  }
  return "# CAMERA_ID MODEL WIDTH HEIGHT fx fy cx cy\n" +
         Formatted("1 PINHOLE %d %d %.12g %.12g %.12g %.12g\n", c.width, c.height, c.fx, c.fy,
                   c.cx + 0.5, c.cy + 0.5);
}

// Two lines: the pose, and the points observed.
std::string ImageText(int id, const std::string& name, const SE3d& world_from_camera,
                      const std::vector<ColmapPoint>& points) {
  const SE3d camera_from_world = world_from_camera.Inverse();
  const Quaterniond& q = camera_from_world.rotation;
  const Vec3d& t = camera_from_world.translation;
  std::string text = Formatted("%d %.12g %.12g %.12g %.12g %.12g %.12g %.12g 1 ", id, q.w, q.x, q.y,
                               q.z, t.x, t.y, t.z) +
                     name + "\n";
  for (const ColmapPoint& o : points)
    text += Formatted("%.1f %.1f %lld ", o.x + 0.5, o.y + 0.5, o.id);
  return text + "\n";
}

std::string PointText(const ColmapPoint& o, int image_id, std::size_t index) {
  return Formatted("%lld %.9g %.9g %.9g %d %d %d 0 %d %zu\n", o.id, o.position.x, o.position.y,
                   o.position.z, o.color.r, o.color.g, o.color.b, image_id, index);
}

}  // namespace

ColmapSequenceWriter::ColmapSequenceWriter(fs::path folder, SequenceDescription description)
    : folder_(std::move(folder)), description_(std::move(description)) {}

std::vector<fs::path> ColmapSequenceWriter::FrameFiles(int number) const {
  const std::string name = FrameName(number, ".png");
  return {fs::path("images") / name, fs::path("depth") / name};
}

std::vector<fs::path> ColmapSequenceWriter::SequenceFiles() const {
  return {"sparse/0/cameras.txt", "sparse/0/images.txt", "sparse/0/points3D.txt"};
}

void ColmapSequenceWriter::Write(int number, const Frame& frame) {
  const std::vector<fs::path> files = FrameFiles(number);
  WriteRgb(folder_ / files[0], frame.rgb);
  WriteDepth(folder_ / files[1], frame.depth_m);
}

// The points come from the files, so that frames of an earlier, interrupted run count as well.
void ColmapSequenceWriter::Finish() {
  std::string images = "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME, then X Y POINT3D_ID …\n";
  std::string points = "# POINT3D_ID X Y Z R G B ERROR, then IMAGE_ID POINT2D_IDX …\n";
  long long first_id = 1;
  for (int number = 0; number < int(description_.truth.size()); ++number) {
    const SE3d& pose = description_.truth[std::size_t(number)].world_from_camera;
    std::vector<ColmapPoint> seen;
    if (number % kPointFrames == 0) seen = PointsOf(number, first_id);
    first_id += (long long)(seen.size());
    images += ImageText(number + 1, FrameName(number, ".png"), pose, seen);
    for (std::size_t i = 0; i < seen.size(); ++i) points += PointText(seen[i], number + 1, i);
  }
  const fs::path model = folder_ / "sparse/0";
  WriteFileAtomically(model / "cameras.txt", CameraText(description_.camera, description_.lens));
  WriteFileAtomically(model / "images.txt", images);
  WriteFileAtomically(model / "points3D.txt", points);
}

std::vector<ColmapPoint> ColmapSequenceWriter::PointsOf(int number, long long first_id) const {
  const PinholeCamera& camera = description_.camera;
  const SE3d& pose = description_.truth[std::size_t(number)].world_from_camera;
  const std::vector<fs::path> files = FrameFiles(number);
  const Image<Rgb8> rgb = ReadRgb(folder_ / files[0]);
  const Image<float> depth_m = ReadDepth(folder_ / files[1]);
  std::vector<ColmapPoint> points;
  for (int y = kPointPixels / 2; y < depth_m.height(); y += kPointPixels) {
    for (int x = kPointPixels / 2; x < depth_m.width(); x += kPointPixels) {
      if (!IsMeasured(depth_m(x, y))) continue;
      const double z = depth_m(x, y);
      const Vec2d ray = description_.lens.Undistort(
          Vec2d{(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy});
      const Vec3d point = pose * Vec3d{z * ray.x, z * ray.y, z};
      points.push_back({first_id + (long long)(points.size()), x, y, point, rgb(x, y)});
    }
  }
  return points;
}

}  // namespace silt
