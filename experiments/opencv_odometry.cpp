// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/opencv_odometry.h"

#include <dlfcn.h>

#include <filesystem>
#include <limits>

#include "opencv_odometry/module.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/core/pyramid.h"

namespace silt::experiments {
namespace {

static_assert(sizeof(Rgb8) == 3);

// OpenCV takes a depth of 0 for one and mixes it into its pyramids.
Image<float> WithNan(Image<float> depth_m) {
  for (float& z : depth_m) {
    if (!IsMeasured(z)) z = std::numeric_limits<float>::quiet_NaN();
  }
  return depth_m;
}

SE3d PoseOf(const double (&m)[16]) {
  const Mat3d rotation{{{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}}};
  return {QuaternionFromMatrix(rotation), {m[3], m[7], m[11]}};
}

}  // namespace

std::optional<OpenCvOdometry> OpenCvOdometry::Load() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const auto file = program.parent_path().parent_path() / "lib/silt/silt_opencv_odometry.so";
  // Never closed: OpenCV's threads may outlive the call.
  void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = module ? dlsym(module, kSiltOpenCvOdometrySymbol) : nullptr;
  if (!function) return std::nullopt;
  return OpenCvOdometry(function);
}

OdometryRun OpenCvOdometry::Run(const FramePair& pair, Kind kind) const {
  if (pair.reference.depth_m.empty() || pair.current.depth_m.empty()) {
    throw Error("OpenCV's odometry needs the depth of both frames");
  }
  const Image<float> reference_m = WithNan(pair.reference.depth_m);
  const Image<float> current_m = WithNan(pair.current.depth_m);
  const auto rgb = [](const Frame& frame) { return &frame.rgb.data()->r; };
  const PinholeCamera& c = pair.camera;
  const SiltOdometryInput input{c.width,
                                c.height,
                                c.fx,
                                c.fy,
                                c.cx,
                                c.cy,
                                {rgb(pair.reference), reference_m.data()},
                                {rgb(pair.current), current_m.data()},
                                kind == Kind::kRgbdIcp,
                                ThreadCount()};
  SiltOdometryOutput output;
  reinterpret_cast<SiltOpenCvOdometryFunction>(function_)(&input, &output);
  OdometryRun run{output.found != 0, output.milliseconds, {}};
  if (run.found) run.current_from_reference = PoseOf(output.current_from_reference);
  return run;
}

}  // namespace silt::experiments
