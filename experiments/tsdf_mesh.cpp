// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tsdf_mesh.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include "open3d_tsdf/module.h"
#include "silt/core/pyramid.h"
#include "silt/tracker/depth_edges.h"

namespace silt::experiments {
namespace {

constexpr int kEdgeMargin_px = 2;
constexpr double kTruncation_voxels = 4;

SiltTsdfFunction Load() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return nullptr;
  const auto file = program.parent_path().parent_path() / "lib/silt/silt_open3d_tsdf.so";
  void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed
  void* const function = module ? dlsym(module, kSiltTsdfSymbol) : nullptr;
  return reinterpret_cast<SiltTsdfFunction>(function);
}

Image<float> SureDepth(const tracker::Keyframe& keyframe) {
  Image<float> depth_m = tracker::WithoutDepthEdges(keyframe.frame.depth_m, kEdgeMargin_px);
  for (float& z : depth_m) z = IsMeasured(z) ? z : 0.0f;
  return depth_m;
}

SiltTsdfFrame FrameOf(const tracker::Keyframe& keyframe, const Image<float>& depth_m) {
  SiltTsdfFrame frame{&keyframe.frame.rgb.data()->r, depth_m.data(), {}};
  const SE3d camera_from_world = keyframe.world_from_camera.Inverse();
  const Mat3d r = camera_from_world.rotation.Matrix();
  const Vec3d& t = camera_from_world.translation;
  const double m[16] = {r.row[0].x, r.row[0].y, r.row[0].z, t.x,        r.row[1].x, r.row[1].y,
                        r.row[1].z, t.y,        r.row[2].x, r.row[2].y, r.row[2].z, t.z,
                        0,          0,          0,          1};
  std::copy_n(m, 16, frame.camera_from_world);
  return frame;
}

void AddVertex(void* mesh, const double point[3], const double color[3]) {
  const auto byte = [](double c) { return std::uint8_t(std::lround(255 * std::clamp(c, 0., 1.))); };
  auto& model = *static_cast<PlyModel*>(mesh);
  model.points.push_back({float(point[0]), float(point[1]), float(point[2])});
  model.colors.push_back({byte(color[0]), byte(color[1]), byte(color[2])});
}

void AddTriangle(void* mesh, const int vertices[3]) {
  static_cast<PlyModel*>(mesh)->triangles.push_back({vertices[0], vertices[1], vertices[2]});
}

}  // namespace

std::optional<PlyModel> TsdfMesh(const std::vector<tracker::Keyframe>& keyframes,
                                 const PinholeCamera& camera, double voxel_m) {
  const SiltTsdfFunction tsdf = Load();
  if (!tsdf) return std::nullopt;
  std::vector<Image<float>> depths_m;
  for (const tracker::Keyframe& keyframe : keyframes) depths_m.push_back(SureDepth(keyframe));
  std::vector<SiltTsdfFrame> frames;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    frames.push_back(FrameOf(keyframes[i], depths_m[i]));
  }
  const SiltTsdfInput input{
      camera.width,  camera.height,     camera.fx, camera.fy,
      camera.cx,     camera.cy,         voxel_m,   kTruncation_voxels * voxel_m,
      frames.data(), int(frames.size())};
  PlyModel mesh;
  const SiltTsdfSink sink{&mesh, AddVertex, AddTriangle};
  if (!tsdf(&input, &sink)) return std::nullopt;
  return mesh;
}

}  // namespace silt::experiments
