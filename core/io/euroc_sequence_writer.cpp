// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/euroc_sequence_writer.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "silt/core/atomic_file.h"
#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/formatted.h"
#include "silt/core/io/image_file.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

const char* const kIdentity =
    "T_BS:\n"
    "  cols: 4\n"
    "  rows: 4\n"
    "  data: [1.0, 0.0, 0.0, 0.0,\n"
    "         0.0, 1.0, 0.0, 0.0,\n"
    "         0.0, 0.0, 1.0, 0.0,\n"
    "         0.0, 0.0, 0.0, 1.0]\n";

// printf into a string; lines here are short.
long long Nanoseconds(double time_s) { return std::llround(time_s * 1e9); }

std::string ImageName(double time_s) { return Formatted("%019lld.png", Nanoseconds(time_s)); }

std::string StateLine(double time_s, const ImuState& s) {
  const Vec3d &p = s.world_from_imu.translation, &v = s.velocity;
  const Vec3d &g = s.gyro_bias, &a = s.accelerometer_bias;
  const Quaterniond& q = s.world_from_imu.rotation;
  return Formatted("%lld,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f,%.9f", Nanoseconds(time_s),
                   p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z) +
         Formatted(",%.9f,%.9f,%.9f,%.9f,%.9f,%.9f\n", g.x, g.y, g.z, a.x, a.y, a.z);
}

// (p(i + 1) − p(i − 1))/(t(i + 1) − t(i − 1)), one-sided at the ends; 0 for a single frame.
Vec3d VelocityBetween(const Trajectory& poses, std::size_t i) {
  const StampedPose& before = poses[i > 0 ? i - 1 : 0];
  const StampedPose& after = poses[i + 1 < poses.size() ? i + 1 : i];
  if (after.time_s == before.time_s) return {};
  return (1 / (after.time_s - before.time_s)) *
         (after.world_from_camera.translation - before.world_from_camera.translation);
}

double FrameRate(const Trajectory& poses) {
  if (poses.size() < 2) return 0;
  return double(poses.size() - 1) / (poses.back().time_s - poses.front().time_s);
}

}  // namespace

EurocSequenceWriter::EurocSequenceWriter(fs::path folder, SequenceDescription description)
    : mav_(std::move(folder) / "mav0"), description_(std::move(description)) {
  if (description_.lens.k3 != 0) {
    throw Error("format euroc: has no place for a lens's k3; choose nerfstudio or colmap");
  }
  if (!description_.truth.empty() && description_.truth.front().time_s < 0) {
    throw Error(mav_.string() + ": EuRoC's layout cannot have times before 0");
  }
}

std::vector<fs::path> EurocSequenceWriter::FrameFiles(int number) const {
  const std::string name = ImageName(description_.truth.at(std::size_t(number)).time_s);
  return {fs::path("mav0/cam0/data") / name, fs::path("mav0/depth0/data") / name};
}

std::vector<fs::path> EurocSequenceWriter::SequenceFiles() const {
  std::vector<fs::path> files;
  for (const char* sensor : {"cam0", "depth0", "imu0", "state_groundtruth_estimate0"}) {
    if (std::string(sensor) == "imu0" && description_.imu.samples.empty()) continue;
    files.push_back(fs::path("mav0") / sensor / "data.csv");
    files.push_back(fs::path("mav0") / sensor / "sensor.yaml");
  }
  return files;
}

void EurocSequenceWriter::Write(int number, const Frame& frame) {
  const fs::path folder = mav_.parent_path();
  const std::vector<fs::path> files = FrameFiles(number);
  const Image<float> gray = GrayFromRgb(frame.rgb);
  Image<std::uint8_t> gray8(gray.width(), gray.height());
  for (std::size_t i = 0; i < gray.size(); ++i) {
    gray8.data()[i] = std::uint8_t(std::lround(255 * gray.data()[i]));
  }
  WriteGray(folder / files[0], gray8);
  WriteDepth(folder / files[1], frame.depth_m);
}

void EurocSequenceWriter::Finish() {
  WriteCamera();
  WriteDepthList();
  if (!description_.imu.samples.empty()) WriteImu();
  WriteStates();
}

std::string EurocSequenceWriter::ImageList() const {
  std::string list = "#timestamp [ns],filename\n";
  for (const StampedPose& pose : description_.truth) {
    list += Formatted("%lld,", Nanoseconds(pose.time_s)) + ImageName(pose.time_s) + "\n";
  }
  return list;
}

void EurocSequenceWriter::WriteCamera() const {
  const PinholeCamera& c = description_.camera;
  const LensDistortion& lens = description_.lens;
  WriteFileAtomically(mav_ / "cam0/data.csv", ImageList());
  WriteFileAtomically(
      mav_ / "cam0/sensor.yaml",
      std::string("sensor_type: camera\ncomment: rendered; the body is the camera\n") + kIdentity +
          Formatted("rate_hz: %.9g\nresolution: [%d, %d]\ncamera_model: pinhole\n",
                    FrameRate(description_.truth), c.width, c.height) +
          Formatted("intrinsics: [%.9g, %.9g, %.9g, %.9g] #fu, fv, cu, cv\n", c.fx, c.fy, c.cx,
                    c.cy) +
          "distortion_model: radial-tangential\n" +
          Formatted("distortion_coefficients: [%.9g, %.9g, %.9g, %.9g] #k1, k2, p1, p2\n", lens.k1,
                    lens.k2, lens.p1, lens.p2));
}

void EurocSequenceWriter::WriteDepthList() const {
  WriteFileAtomically(mav_ / "depth0/data.csv", ImageList());
  WriteFileAtomically(
      mav_ / "depth0/sensor.yaml",
      std::string("sensor_type: depth\n"
                  "comment: of cam0, along z, 16 bits, 5000 per metre; 0 is none\n") +
          kIdentity);
}

void EurocSequenceWriter::WriteImu() const {
  const ImuNoise& noise = description_.imu.noise;
  std::string list =
      "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],"
      "a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n";
  for (const ImuSample& s : description_.imu.samples) {
    const Vec3d &w = s.angular_velocity, &a = s.acceleration;
    list += Formatted("%lld,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g\n", Nanoseconds(s.time_s), w.x, w.y,
                      w.z, a.x, a.y, a.z);
  }
  WriteFileAtomically(mav_ / "imu0/data.csv", list);
  WriteFileAtomically(
      mav_ / "imu0/sensor.yaml",
      std::string("sensor_type: imu\ncomment: from the exact derivatives of the camera's path\n") +
          kIdentity + Formatted("rate_hz: %.9g\n", description_.imu.rate_hz) +
          Formatted("gyroscope_noise_density: %.9g # [rad/s/sqrt(Hz)]\n"
                    "gyroscope_random_walk: %.9g # [rad/s^2/sqrt(Hz)]\n",
                    noise.gyro_density, noise.gyro_walk) +
          Formatted("accelerometer_noise_density: %.9g # [m/s^2/sqrt(Hz)]\n"
                    "accelerometer_random_walk: %.9g # [m/s^3/sqrt(Hz)]\n",
                    noise.accelerometer_density, noise.accelerometer_walk));
}

void EurocSequenceWriter::WriteStates() const {
  std::string list =
      "#timestamp,p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],"
      "v_RS_R_x [m s^-1],v_RS_R_y [m s^-1],v_RS_R_z [m s^-1],b_w_RS_S_x [rad s^-1],"
      "b_w_RS_S_y [rad s^-1],b_w_RS_S_z [rad s^-1],b_a_RS_S_x [m s^-2],b_a_RS_S_y [m s^-2],"
      "b_a_RS_S_z [m s^-2]\n";
  for (const ImuSample& s : description_.imu.samples) list += StateLine(s.time_s, s.truth);
  if (description_.imu.samples.empty()) {
    const Trajectory& poses = description_.truth;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      list += StateLine(poses[i].time_s,
                        {poses[i].world_from_camera, VelocityBetween(poses, i), {}, {}});
    }
  }
  WriteFileAtomically(mav_ / "state_groundtruth_estimate0/data.csv", list);
  WriteFileAtomically(mav_ / "state_groundtruth_estimate0/sensor.yaml",
                      std::string("sensor_type: pose\ncomment: the truth\n") + kIdentity);
}

}  // namespace silt
