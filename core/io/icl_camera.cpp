// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/icl_camera.h"

#include <cmath>
#include <cstdio>

#include "silt/core/error.h"

namespace silt {
namespace {

constexpr Mat3d kExchangeYz{{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}};
constexpr Mat3d kFlipY{{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};

Vec3d Column(const Mat3d& m, int i) { return Transposed(m).row[i]; }

// "cam_pos      = [1, 2, 3]';"
std::string VectorLine(const char* name, const Vec3d& v) {
  char line[128];
  std::snprintf(line, sizeof line, "%-12s = [%.12g, %.12g, %.12g]';\n", name, v.x, v.y, v.z);
  return line;
}

Vec3d ParseVector(const std::string& text, const char* name, const std::string& file) {
  const std::size_t at = text.find(name);
  Vec3d v;
  const bool read = at != text.npos && std::sscanf(text.c_str() + at + std::string(name).size(),
                                                   " = [ %lf , %lf , %lf ]", &v.x, &v.y, &v.z) == 3;
  if (!read || !std::isfinite(Dot(v, v))) {
    throw Error(file + ": has no line \"" + name + " = [x, y, z]';\"");
  }
  return v;
}

}  // namespace

SE3d IclFromSilt(const SE3d& pose) {
  const Mat3d rotation = kExchangeYz * pose.rotation.Matrix() * kFlipY;
  return {QuaternionFromMatrix(rotation), kExchangeYz * pose.translation};
}

SE3d SiltFromIcl(const SE3d& pose) {
  // S and D are their own inverses.
  return IclFromSilt(pose);
}

std::string FormatIclCamera(const IclCamera& camera) {
  const SE3d pose = IclFromSilt(camera.world_from_camera);
  const Mat3d axes = pose.rotation.Matrix();
  return VectorLine("cam_pos", pose.translation) + VectorLine("cam_dir", Column(axes, 2)) +
         VectorLine("cam_up", camera.height * Column(axes, 1)) +
         VectorLine("cam_lookat", {0, 0, 1}) + VectorLine("cam_sky", {0, 1, 0}) +
         VectorLine("cam_right", camera.width * Column(axes, 0)) +
         VectorLine("cam_fpoint", {0, 0, 10}) + "cam_angle    = 90;\n";
}

// The published code (computeRT) takes z = dir, x = up × z, y = z × x, all normalised.
IclCamera ParseIclCamera(const std::string& text, const std::string& name) {
  const Vec3d direction = ParseVector(text, "cam_dir", name),
              up = ParseVector(text, "cam_up", name), right = ParseVector(text, "cam_right", name);
  const Vec3d across = Cross(up, direction);
  if (!(Norm(across) > 1e-6 * Norm(up) * Norm(direction)) || Norm(right) == 0) {
    throw Error(name + ": cam_dir, cam_up and cam_right do not span a camera");
  }
  const Vec3d z = Normalized(direction), x = Normalized(across), y = Cross(z, x);
  const SE3d pose{QuaternionFromMatrix(Transposed(Mat3d{{x, y, z}})),
                  ParseVector(text, "cam_pos", name)};
  return {SiltFromIcl(pose), Norm(right) / Norm(direction), Norm(up) / Norm(direction)};
}

}  // namespace silt
