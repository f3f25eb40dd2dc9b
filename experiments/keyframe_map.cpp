// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/keyframe_map.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "silt/core/pyramid.h"
#include "silt/experiments/figures.h"
#include "silt/experiments/tsdf_mesh.h"
#include "silt/tracker/depth_edges.h"

namespace silt::experiments {
namespace {

constexpr int kEdgeMargin_px = 2;
constexpr Rgb8 kCameraColor{44, 111, 187}, kPathColor{192, 57, 43};

struct Voxel {
  Vec3d point{}, color{};
  double weight = 0;
};

using Index = std::array<int, 3>;

struct IndexHash {
  std::size_t operator()(const Index& i) const {
    return std::size_t(i[0]) * 73856093u ^ std::size_t(i[1]) * 19349663u ^
           std::size_t(i[2]) * 83492791u;
  }
};

using Voxels = std::unordered_map<Index, Voxel, IndexHash>;

Index IndexOf(const Vec3d& point, double voxel_m) {
  const auto at = [&](double x) { return int(std::floor(x / voxel_m)); };
  return {at(point.x), at(point.y), at(point.z)};
}

void AddKeyframe(const tracker::Keyframe& keyframe, const PinholeCamera& camera, double voxel_m,
                 Voxels* voxels) {
  const Image<float> depth_m = tracker::WithoutDepthEdges(keyframe.frame.depth_m, kEdgeMargin_px);
  for (int y = 0; y < depth_m.height(); ++y) {
    for (int x = 0; x < depth_m.width(); ++x) {
      if (!IsMeasured(depth_m(x, y))) continue;
      const double z = depth_m(x, y), weight = 1 / (z * z);
      const Vec3d point = keyframe.world_from_camera * camera.Unproject(x, y, z);
      const Rgb8& color = keyframe.frame.rgb(x, y);
      Voxel& voxel = (*voxels)[IndexOf(point, voxel_m)];
      voxel.point = voxel.point + weight * point;
      voxel.color = voxel.color + weight * Vec3d{double(color.r), double(color.g), double(color.b)};
      voxel.weight += weight;
    }
  }
}

// Adds a chain of edges through points of one colour.
void AddChain(const std::vector<Vec3d>& points, const Rgb8& color, PlyModel* model) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int index = int(model->points.size());
    model->points.push_back(points[i].Cast<float>());
    model->colors.push_back(color);
    if (i > 0) model->edges.push_back({index - 1, index});
  }
}

}  // namespace

PlyModel FusedCloud(const std::vector<tracker::Keyframe>& keyframes, const PinholeCamera& camera,
                    double voxel_m) {
  Voxels voxels;
  for (const tracker::Keyframe& keyframe : keyframes) {
    AddKeyframe(keyframe, camera, voxel_m, &voxels);
  }
  std::vector<std::pair<Index, Voxel>> ordered(voxels.begin(), voxels.end());
  std::sort(ordered.begin(), ordered.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  PlyModel cloud;
  for (const auto& [index, voxel] : ordered) {
    const double scale = 1 / voxel.weight;
    const auto byte = [&](double sum) { return std::uint8_t(std::lround(scale * sum)); };
    cloud.points.push_back((scale * voxel.point).Cast<float>());
    cloud.colors.push_back({byte(voxel.color.x), byte(voxel.color.y), byte(voxel.color.z)});
  }
  return cloud;
}

PlyModel CameraLines(const std::vector<tracker::Keyframe>& keyframes, const PinholeCamera& camera,
                     const Trajectory& trajectory, double depth_m) {
  PlyModel lines;
  const double right = camera.width - 1, bottom = camera.height - 1;
  for (const tracker::Keyframe& keyframe : keyframes) {
    const auto corner = [&](double x, double y) {
      return keyframe.world_from_camera * camera.Unproject(x, y, depth_m);
    };
    const Vec3d eye = keyframe.world_from_camera.translation;
    const Vec3d a = corner(0, 0), b = corner(right, 0), c = corner(right, bottom),
                d = corner(0, bottom);
    AddChain({eye, a, b, eye, c, d, eye}, kCameraColor, &lines);
    AddChain({a, d}, kCameraColor, &lines);
    AddChain({b, c}, kCameraColor, &lines);
  }
  std::vector<Vec3d> path;
  for (const StampedPose& pose : trajectory) path.push_back(pose.world_from_camera.translation);
  AddChain(path, kPathColor, &lines);
  return lines;
}

Json WriteMap(const std::filesystem::path& folder, const MapInput& input) {
  const PlyModel cloud = FusedCloud(input.keyframes, input.camera, input.voxel_m);
  WritePly(folder / "cloud.ply", cloud);
  WritePly(folder / "cameras.ply", CameraLines(input.keyframes, input.camera, input.trajectory));
  WriteTumTrajectory(folder / "path.txt", input.trajectory);
  Json json{{"keyframes", input.keyframes.size()},
            {"voxel_m", input.voxel_m},
            {"points", cloud.points.size()},
            {"triangles", nullptr}};
  if (const auto mesh = TsdfMesh(input.keyframes, input.camera, input.voxel_m)) {
    WritePly(folder / "mesh.ply", *mesh);
    json["triangles"] = mesh->triangles.size();
  } else {
    spdlog::warn("map: no mesh.ply, as no Open3D was found; install libopen3d-dev and build again");
  }
  DrawFigures("map.py", folder);
  return json;
}

}  // namespace silt::experiments
