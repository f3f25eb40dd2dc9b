// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/icl_sequence.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/core/io/icl_camera.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

constexpr double kFramesPerSecond = 30;
const char* const kPoses = "scene.gt.freiburg";

std::string Name(int number, const char* extension) {
  char name[32];
  std::snprintf(name, sizeof name, "scene_00_%04d", number);
  return std::string(name) + extension;
}

std::string ReadWhole(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !fs::is_regular_file(file)) throw Error(file.string() + ": cannot be read");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// |ray| for a ray of z = 1.
double RayLength(const PinholeCamera& camera, int x, int y) {
  return Norm(camera.Unproject(double(x), double(y), 1.0));
}

std::string FormatRayDepth(const Image<float>& depth_m, const PinholeCamera& camera) {
  std::string text;
  text.reserve(depth_m.size() * 10);
  char number[32];
  for (int y = 0; y < depth_m.height(); ++y) {
    for (int x = 0; x < depth_m.width(); ++x) {
      const float z = depth_m(x, y);
      const auto ray = float(std::isfinite(z) ? z * RayLength(camera, x, y) : 0);
      text.append(number, std::to_chars(number, number + sizeof number, ray).ptr);
      text += ' ';
    }
  }
  return text;
}

Image<float> ReadRayDepth(const fs::path& file, const PinholeCamera& camera) {
  const std::string text = ReadWhole(file);
  const char *at = text.data(), *const end = at + text.size();
  Image<float> depth_m(camera.width, camera.height);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      while (at != end && std::isspace(static_cast<unsigned char>(*at))) ++at;
      float ray = 0;
      const auto [next, error] = std::from_chars(at, end, ray);
      if (error != std::errc() || !std::isfinite(ray)) {
        throw Error(file.string() + ": number " + std::to_string(y * camera.width + x + 1) +
                    " of " + std::to_string(depth_m.size()) + " is none");
      }
      at = next;
      depth_m(x, y) = float(ray / RayLength(camera, x, y));
    }
  }
  return depth_m;
}

// The poses' times from the first *.gt.freiburg file, if it tells one for each frame.
void TakeTimes(const fs::path& folder, Trajectory& truth) {
  for (std::size_t i = 0; i < truth.size(); ++i) truth[i].time_s = double(i) / kFramesPerSecond;
  if (!fs::is_regular_file(folder / kPoses)) return;
  const Trajectory stamped = ReadTumTrajectory(folder / kPoses);
  if (stamped.size() != truth.size()) return;
  for (std::size_t i = 0; i < truth.size(); ++i) truth[i].time_s = stamped[i].time_s;
}

}  // namespace

IclSequenceWriter::IclSequenceWriter(fs::path folder, SequenceDescription description)
    : folder_(std::move(folder)), description_(std::move(description)) {
  RequirePinhole(description_, "icl");
  const PinholeCamera& camera = description_.camera;
  if (std::abs(camera.cx - (camera.width - 1) / 2.0) > 1e-6 ||
      std::abs(camera.cy - (camera.height - 1) / 2.0) > 1e-6) {
    throw Error(folder_.string() +
                ": ICL-NUIM's layout has no place for a principal point that is not the middle of "
                "the image; choose another format");
  }
}

std::vector<fs::path> IclSequenceWriter::FrameFiles(int number) const {
  return {Name(number, ".png"), Name(number, ".depth"), Name(number, ".txt")};
}

std::vector<fs::path> IclSequenceWriter::SequenceFiles() const { return {kPoses}; }

void IclSequenceWriter::Write(int number, const Frame& frame) {
  const PinholeCamera& camera = description_.camera;
  const SE3d& pose = description_.truth.at(std::size_t(number)).world_from_camera;
  WriteRgb(folder_ / Name(number, ".png"), frame.rgb);
  WriteFileAtomically(folder_ / Name(number, ".depth"), FormatRayDepth(frame.depth_m, camera));
  WriteFileAtomically(folder_ / Name(number, ".txt"),
                      FormatIclCamera({pose, camera.width / camera.fx, camera.height / camera.fy}));
}

void IclSequenceWriter::Finish() {
  Trajectory poses = description_.truth;
  for (StampedPose& pose : poses) pose.world_from_camera = IclFromSilt(pose.world_from_camera);
  WriteTumTrajectory(folder_ / kPoses, poses);
}

IclSequence::IclSequence(const fs::path& folder) : folder_(folder) {
  if (!fs::is_regular_file(folder / Name(0, ".png"))) {
    throw Error((folder / Name(0, ".png")).string() + ": no such image; ICL-NUIM's begin with it");
  }
  const Image<Rgb8> first = ReadRgb(folder / Name(0, ".png"));
  for (int number = 0; fs::is_regular_file(folder / Name(number, ".png")); ++number) {
    const fs::path file = folder / Name(number, ".txt");
    const IclCamera camera = ParseIclCamera(ReadWhole(file), file.string());
    const PinholeCamera pinhole{first.width() / camera.width,
                                first.height() / camera.height,
                                (first.width() - 1) / 2.0,
                                (first.height() - 1) / 2.0,
                                first.width(),
                                first.height()};
    if (number == 0) camera_ = pinhole;
    // Files round to six digits.
    if (std::abs(pinhole.fx / camera_.fx - 1) > 1e-3 ||
        std::abs(pinhole.fy / camera_.fy - 1) > 1e-3) {
      throw Error(file.string() + ": its focal lengths differ from those of the first frame");
    }
    truth_.push_back({0, camera.world_from_camera});
  }
  TakeTimes(folder, truth_);
}

std::optional<Frame> IclSequence::Next() {
  if (next_ == size()) return std::nullopt;
  const int number = next_++;
  const fs::path image = folder_ / Name(number, ".png"), depth = folder_ / Name(number, ".depth");
  Frame frame{truth_[std::size_t(number)].time_s, ReadRgb(image), {}};
  if (frame.rgb.width() != camera_.width || frame.rgb.height() != camera_.height) {
    throw Error(image.string() + ": its size differs from the first frame's");
  }
  if (fs::exists(depth)) frame.depth_m = ReadRayDepth(depth, camera_);
  return frame;
}

std::vector<double> IclSequence::times_s() const {
  std::vector<double> times;
  for (const StampedPose& pose : truth_) times.push_back(pose.time_s);
  return times;
}

}  // namespace silt
