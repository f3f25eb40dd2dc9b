// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "module.h"

#include <open3d/camera/PinholeCameraIntrinsic.h>
#include <open3d/geometry/RGBDImage.h>
#include <open3d/geometry/TriangleMesh.h>
#include <open3d/pipelines/integration/ScalableTSDFVolume.h>

#include <cstring>
#include <exception>

namespace {

namespace integration = open3d::pipelines::integration;

open3d::geometry::RGBDImage ColorsAndDepths(const SiltTsdfInput& in, const SiltTsdfFrame& frame) {
  open3d::geometry::RGBDImage images;
  images.color_.Prepare(in.width, in.height, 3, 1);
  std::memcpy(images.color_.data_.data(), frame.rgb, images.color_.data_.size());
  images.depth_.Prepare(in.width, in.height, 1, sizeof(float));
  std::memcpy(images.depth_.data_.data(), frame.depth_m, images.depth_.data_.size());
  return images;
}

void Compute(const SiltTsdfInput& in, const SiltTsdfSink& out) {
  integration::ScalableTSDFVolume volume(in.voxel_m, in.truncation_m,
                                         integration::TSDFVolumeColorType::RGB8);
  const open3d::camera::PinholeCameraIntrinsic camera(in.width, in.height, in.fx, in.fy, in.cx,
                                                      in.cy);
  using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  for (int i = 0; i < in.frame_count; ++i) {
    volume.Integrate(ColorsAndDepths(in, in.frames[i]), camera,
                     Eigen::Map<const RowMajor>(in.frames[i].camera_from_world));
  }
  const auto mesh = volume.ExtractTriangleMesh();
  for (std::size_t i = 0; i < mesh->vertices_.size(); ++i) {
    out.add_vertex(out.mesh, mesh->vertices_[i].data(), mesh->vertex_colors_[i].data());
  }
  for (const Eigen::Vector3i& t : mesh->triangles_) out.add_triangle(out.mesh, t.data());
}

}  // namespace

extern "C" [[gnu::visibility("default")]] int SiltTsdf(const SiltTsdfInput* in,
                                                       const SiltTsdfSink* out) {
  try {
    Compute(*in, *out);
    return 1;
  } catch (const std::exception&) {
    return 0;
  }
}
