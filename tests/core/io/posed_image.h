// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "silt/core/color.h"
#include "silt/core/io/sequence_writer.h"
#include "silt/core/lens.h"

// Whether a layout's images, depths, poses and intrinsics fit together, told by the pictures alone:
// one frame is warped onto another. Readers in tests give them in the layout's own conventions.
namespace silt {

// An image with its depth and pose. The camera may look along ±z and have its y up (fy < 0):
//   X = x·z,   Y = sign(fy)·y·z,   Z = z_sign·z,
//   where the lens shows (x, y), y down, at ((u − cx)/fx, (v − cy)/|fy|).
struct PosedImage {
  Image<float> gray;     // [0, 1]
  Image<float> depth_m;  // z ≥ 0
  double fx = 0, fy = 0, cx = 0, cy = 0, z_sign = 1;
  Mat3d rotation;  // world from camera
  Vec3d position;
  LensDistortion lens = {};
  Image<Rgb8> rgb = {};  // where a reader keeps the colours

  double y_sign() const { return fy < 0 ? -1 : 1; }
  Vec3d ToWorld(int u, int v) const {
    const double z = depth_m(u, v);
    const Vec2d ray = lens.Undistort(Vec2d{(u - cx) / fx, (v - cy) / std::abs(fy)});
    return rotation * Vec3d{ray.x * z, y_sign() * ray.y * z, z_sign * z} + position;
  }
  Vec2d ToImage(const Vec3d& world) const {
    const Vec3d p = Transposed(rotation) * (world - position);
    const double z = z_sign * p.z;
    const Vec2d shown = lens.Distort(Vec2d{p.x / z, y_sign() * p.y / z});
    return {cx + fx * shown.x, cy + std::abs(fy) * shown.y};
  }
};

// Catmull-Rom's cubic through four values.
inline double Cubic(const double* p, double t) {
  return p[1] +
         0.5 * t *
             (p[2] - p[0] +
              t * (2 * p[0] - 5 * p[1] + 4 * p[2] - p[3] + t * (3 * (p[1] - p[2]) + p[3] - p[0])));
}

// Mean |ΔI| × 255 when `to` is looked up where each pixel of `from` is seen in it; 255 where hardly
// any pixel is. A right convention leaves the quantisation, some 0.4.
inline double WarpError(const PosedImage& from, const PosedImage& to) {
  double sum = 0;
  int count = 0;
  for (int v = 0; v < from.gray.height(); ++v) {
    for (int u = 0; u < from.gray.width(); ++u) {
      if (!(from.depth_m(u, v) > 0)) continue;
      const Vec2d at = to.ToImage(from.ToWorld(u, v));
      if (!(at.x >= 1 && at.y >= 1 && at.x < to.gray.width() - 2 && at.y < to.gray.height() - 2)) {
        continue;
      }
      const int x = int(at.x), y = int(at.y);
      double rows[4];
      for (int j = 0; j < 4; ++j) {
        const float* row = to.gray.row(y - 1 + j) + x - 1;
        const double values[4] = {row[0], row[1], row[2], row[3]};
        rows[j] = Cubic(values, at.x - x);
      }
      sum += std::abs(Cubic(rows, at.y - y) - double(from.gray(u, v)));
      ++count;
    }
  }
  return count > int(from.gray.size() / 4) ? 255 * sum / count : 255;
}

// The three mistakes that converters make; each returns the image as they would have it.
inline PosedImage WithFyFlipped(PosedImage image) {
  image.fy = -image.fy;
  return image;
}
inline PosedImage WithPoseInverted(PosedImage image) {
  image.rotation = Transposed(image.rotation);
  image.position = -(image.rotation * image.position);
  return image;
}
// Where the layout's depth is along z it is taken for the ray's (sign −1), or the reverse (+1).
inline PosedImage WithDepthMistaken(PosedImage image, int sign) {
  for (int v = 0; v < image.depth_m.height(); ++v) {
    for (int u = 0; u < image.depth_m.width(); ++u) {
      const double ray = Norm(Vec3d{(u - image.cx) / image.fx, (v - image.cy) / image.fy, 1.0});
      image.depth_m(u, v) = float(image.depth_m(u, v) * std::pow(ray, sign));
    }
  }
  return image;
}

inline PosedImage WithoutLens(PosedImage image) {
  image.lens = {};
  return image;
}

// The inside of a box 6 × 8 × 3 m on the floor z = 0, painted with smooth waves.
inline double BoxPattern(const Vec3d& p) {
  const double s = std::sin(4.1 * p.x + 0.3) * std::sin(3.7 * p.y - 0.2) +
                   std::sin(2.9 * p.z + 1.1 * p.x) + 0.6 * std::sin(7.3 * p.x - 6.1 * p.y) +
                   0.6 * std::sin(5.7 * p.y + 6.7 * p.z);
  return 0.5 + 0.14 * s;
}

// ICL-NUIM's camera at a quarter of its size: fx ≠ fy, wide enough to tell z from the ray.
inline constexpr PinholeCamera kBoxCamera{120.3, 120, 79.5, 59.5, 160, 120};

inline Frame BoxFrame(const SE3d& world_from_camera, double time_s,
                      const LensDistortion& lens = {}) {
  const PinholeCamera& camera = kBoxCamera;
  Frame frame{time_s, Image<Rgb8>(camera.width, camera.height),
              Image<float>(camera.width, camera.height)};
  const Vec3d& o = world_from_camera.translation;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Vec2d ray =
          lens.Undistort(Vec2d{(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy});
      const Vec3d d = world_from_camera.rotation * Vec3d{ray.x, ray.y, 1};
      const double z = std::min({((d.x > 0 ? 3 : -3) - o.x) / d.x, ((d.y > 0 ? 4 : -4) - o.y) / d.y,
                                 ((d.z > 0 ? 3 : 0) - o.z) / d.z});
      const auto gray = std::uint8_t(std::lround(255 * BoxPattern(o + z * d)));
      frame.rgb(u, v) = {gray, gray, gray};
      frame.depth_m(u, v) = float(z);
    }
  }
  return frame;
}

// A camera that walks and turns about all axes, 10 frames a second.
inline SequenceDescription BoxDescription(int frames) {
  SequenceDescription description{kBoxCamera, {}, {}};
  const Mat3d looking{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};  // along world y, upright
  for (int i = 0; i < frames; ++i) {
    const Quaterniond turn = Quaterniond::Exp({0.04 * i, 0.3 + 0.05 * i, 0.1 + 0.06 * i});
    description.truth.push_back({0.1 * i,
                                 {(QuaternionFromMatrix(looking) * turn).Normalized(),
                                  {0.5 + 0.1 * i, -0.4 + 0.07 * i, 1.4 - 0.05 * i}}});
  }
  return description;
}

inline std::vector<Frame> BoxFrames(const SequenceDescription& description) {
  std::vector<Frame> frames;
  for (const StampedPose& pose : description.truth) {
    frames.push_back(BoxFrame(pose.world_from_camera, pose.time_s, description.lens));
  }
  return frames;
}

// All frames, in reversed order, and the end.
inline void WriteBox(SequenceWriter& writer, const SequenceDescription& description) {
  const std::vector<Frame> frames = BoxFrames(description);
  for (int i = int(frames.size()) - 1; i >= 0; --i) writer.Write(i, frames[std::size_t(i)]);
  writer.Finish();
}

// A wide lens, every coefficient at work: its corners move by up to 9 pixels.
inline constexpr LensDistortion kBoxLens{-0.12, 0.03, 0.004, -0.003, 0.002};

// The box's frames with a colour for each pixel and channel, so that one exchanged for another
// shows.
inline std::vector<Frame> ColoredFrames(const SequenceDescription& description) {
  std::vector<Frame> frames = BoxFrames(description);
  for (Frame& frame : frames) {
    for (int v = 0; v < frame.rgb.height(); ++v) {
      for (int u = 0; u < frame.rgb.width(); ++u) {
        frame.rgb(u, v).g = std::uint8_t(u);
        frame.rgb(u, v).b = std::uint8_t(v);
      }
    }
  }
  return frames;
}

// What a reader found is what was written: pose, intrinsics and lens to the digits of text, colours
// exactly, depth to half of the layout's step.
void ExpectSame(const PosedImage& found, const SequenceDescription& written, std::size_t number,
                const Frame& frame, double depth_step_m);

// A folder of the running test's own, empty at the start and gone at the end.
class SequenceFolder {
 public:
  SequenceFolder();
  ~SequenceFolder() { std::filesystem::remove_all(path_); }
  SequenceFolder(const SequenceFolder&) = delete;
  SequenceFolder& operator=(const SequenceFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string ReadText(const std::filesystem::path& file);

}  // namespace silt
