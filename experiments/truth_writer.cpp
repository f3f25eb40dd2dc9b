// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/truth_writer.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/core/io/flow_file.h"
#include "silt/core/io/image_file.h"
#include "silt/core/io/npy_file.h"
#include "silt/core/io/sequence_writer.h"
#include "silt/experiments/output.h"
#include "silt/sim/camera_rays.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

const fs::path kTruth = "truth";

fs::path FileOf(const char* kind, int number, const char* extension) {
  return kTruth / kind / FrameName(number, extension);
}

Image<std::uint16_t> Narrow(const Image<std::uint32_t>& ids) {
  Image<std::uint16_t> narrow(ids.width(), ids.height());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids.data()[i] > 65535) throw Error("--truth ids: more than 65535 of them");
    narrow.data()[i] = std::uint16_t(ids.data()[i]);
  }
  return narrow;
}

std::string FormatImu(const ImuRecording& imu) {
  std::string text =
      "#time_s,gyro_x,gyro_y,gyro_z,acc_x,acc_y,acc_z,gyro_bias_x,gyro_bias_y,gyro_bias_z,"
      "acc_bias_x,acc_bias_y,acc_bias_z\n";
  for (const ImuSample& s : imu.samples) {
    char line[64];
    std::snprintf(line, sizeof line, "%.9f", s.time_s);
    text += line;
    for (const Vec3d& v :
         {s.angular_velocity, s.acceleration, s.truth.gyro_bias, s.truth.accelerometer_bias}) {
      char values[128];
      std::snprintf(values, sizeof values, ",%.12g,%.12g,%.12g", v.x, v.y, v.z);
      text += values;
    }
    text += "\n";
  }
  return text;
}

Json Conventions() {
  return {
      {"camera_axes", "x right, y down, z forward; pixel centres at integers"},
      {"world_axes", "right-handed, z up, metres"},
      {"time",
       "of a frame: the middle of its exposure, of its middle row where the shutter rolls; depth, "
       "normals, ids and flow hold at the middle of each row's own exposure"},
      {"sharp",
       "8-bit colours without blur and noise, of the middle of each row's exposure, as bright as "
       "the "
       "frame"},
      {"depth_z", "float32 metres along the optical axis; 0: nothing"},
      {"depth_ray", "float32 metres from the camera's centre along the ray; 0: nothing"},
      {"normal", "unit vectors of the surface, on the side that is seen; 0: nothing"},
      {"ids", "uint16, see legend.json; 0: nothing"},
      {"flow",
       "from a pixel to where its point is in the other frame, (u, v) in pixels; "
       "more than 1e9: none"},
      {"occlusion",
       {{"0", "seen in the other frame"},
        {"85", "outside the other frame"},
        {"170", "hidden by something more than 1 mm in front of it"},
        {"255", "the pixel sees nothing"}}},
      {"imu",
       "at the camera's centre, with its axes; rad/s, m/s^2, gravity 9.81 along -z; "
       "readings include the biases"},
      {"poses", "TUM: time tx ty tz qx qy qz qw, world from camera"}};
}

}  // namespace

Json TruthSelection::ToJson() const {
  return {{"sharp", sharp},
          {"depth", depth},
          {"normals", normals},
          {"ids", ids},
          {"flow", flow},
          {"imu", imu},
          {"pose_rate_hz", poses ? pose_rate_hz : 0}};
}

TruthWriter::TruthWriter(fs::path folder, const TruthSelection& selection, const World& world,
                         const sim::Renderer& renderer, Trajectory poses)
    : folder_(std::move(folder)),
      selection_(selection),
      world_(world),
      renderer_(renderer),
      flow_(world.scene->tracer(), renderer.options().camera, renderer.options().lens),
      poses_(std::move(poses)) {
  const sim::RenderOptions& options = renderer.options();
  if (!options.lens.IsNone()) lens_.emplace(options.camera, options.lens);
}

std::vector<fs::path> TruthWriter::FrameFiles(int number) const {
  std::vector<fs::path> files;
  const auto add = [&](bool wanted, const char* kind, const char* extension) {
    if (wanted) files.push_back(FileOf(kind, number, extension));
  };
  const bool forward = selection_.flow && number + 1 < int(poses_.size());
  const bool backward = selection_.flow && number > 0;
  add(selection_.sharp, "sharp", ".png");
  add(selection_.depth, "depth_z", ".npy");
  add(selection_.depth, "depth_ray", ".npy");
  add(selection_.normals, "normal_camera", ".npy");
  add(selection_.normals, "normal_world", ".npy");
  add(selection_.ids, "instance", ".png");
  add(selection_.ids, "material", ".png");
  add(forward, "flow_forward", ".flo");
  add(forward, "occlusion_forward", ".png");
  add(backward, "flow_backward", ".flo");
  add(backward, "occlusion_backward", ".png");
  return files;
}

std::vector<fs::path> TruthWriter::SequenceFiles() const {
  std::vector<fs::path> files;
  if (selection_.Any()) files.push_back(kTruth / "conventions.json");
  if (selection_.ids) files.push_back(kTruth / "legend.json");
  if (selection_.imu) files.push_back(kTruth / "imu.csv");
  if (selection_.poses) files.push_back(kTruth / "poses.txt");
  return files;
}

void TruthWriter::Write(int number, int index) const {
  const TruthSelection& s = selection_;
  if (s.sharp) WriteSharp(number, index);
  if (!s.depth && !s.normals && !s.ids && !s.flow) return;
  const sim::GeometryBuffers geometry =
      renderer_.RenderGeometry(world_.Pose(), poses_.at(std::size_t(number)).time_s);
  if (s.depth) WriteDepth(number, geometry);
  if (s.normals) WriteNormals(number, geometry);
  if (s.ids) WriteIds(number, geometry);
  if (s.flow) WriteFlow(number, geometry);
}

sim::RowPoses TruthWriter::PosesOf(int number) const {
  const sim::RenderOptions& options = renderer_.options();
  return sim::PosesOfRows(options.shutter, options.camera.height, world_.Pose(),
                          poses_[std::size_t(number)].time_s);
}

// An exposure that is metered in each frame is metered in the blurred one, or the two would differ
// in brightness.
void TruthWriter::WriteSharp(int number, int index) const {
  const double time_s = poses_.at(std::size_t(number)).time_s;
  sim::RenderOptions options = renderer_.options();
  options.sensor.noise = {};
  if (options.exposure.kind == sim::Exposure::Kind::kPerFrame) {
    options.exposure = {
        sim::Exposure::Kind::kGiven,
        sim::MeteredExposure({renderer_.RenderLinear(world_.Pose(), time_s, index)})};
  }
  const sim::Renderer noiseless(renderer_.lit_scene(), options);
  WriteRgb(folder_ / FileOf("sharp", number, ".png"),
           noiseless.Develop(noiseless.RenderSharp(world_.Pose(), time_s, index), {}));
}

void TruthWriter::WriteDepth(int number, const sim::GeometryBuffers& geometry) const {
  Image<float> along_ray = geometry.depth_m;
  const sim::CameraRays rays({renderer_.options().camera, lens_ ? &*lens_ : nullptr}, {});
  for (int y = 0; y < along_ray.height(); ++y) {
    for (int x = 0; x < along_ray.width(); ++x) {
      along_ray(x, y) = float(along_ray(x, y) * Norm(rays.Direction(x, y)));
    }
  }
  WriteNpy(folder_ / FileOf("depth_z", number, ".npy"), geometry.depth_m);
  WriteNpy(folder_ / FileOf("depth_ray", number, ".npy"), along_ray);
}

void TruthWriter::WriteNormals(int number, const sim::GeometryBuffers& geometry) const {
  const sim::RowPoses poses = PosesOf(number);
  Image<Vec3f> world = geometry.normal_camera;
  for (int y = 0; y < world.height(); ++y) {
    const Quaterniond& rotation = poses[poses.size() == 1 ? 0 : std::size_t(y)].rotation;
    for (int x = 0; x < world.width(); ++x) {
      world(x, y) = (rotation * world(x, y).Cast<double>()).Cast<float>();
    }
  }
  WriteNpy(folder_ / FileOf("normal_camera", number, ".npy"), geometry.normal_camera);
  WriteNpy(folder_ / FileOf("normal_world", number, ".npy"), world);
}

void TruthWriter::WriteIds(int number, const sim::GeometryBuffers& geometry) const {
  WriteGray(folder_ / FileOf("instance", number, ".png"), Narrow(geometry.instance));
  WriteGray(folder_ / FileOf("material", number, ".png"), Narrow(geometry.material));
}

void TruthWriter::WriteFlow(int number, const sim::GeometryBuffers& geometry) const {
  const auto write = [&](int other, const char* flow, const char* occlusion) {
    if (other < 0 || other >= int(poses_.size())) return;
    const sim::FlowField field = flow_.Between(geometry.depth_m, PosesOf(number), PosesOf(other));
    silt::WriteFlow(folder_ / FileOf(flow, number, ".flo"), field.flow_px);
    WriteGray(folder_ / FileOf(occlusion, number, ".png"), field.state);
  };
  write(number + 1, "flow_forward", "occlusion_forward");
  write(number - 1, "flow_backward", "occlusion_backward");
}

Json TruthWriter::Legend() const {
  const sim::Scene& scene = world_.scene->scene();
  Json legend{{"instance", {{"0", "nothing"}}}, {"material", {{"0", "nothing"}}}};
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    legend["instance"][std::to_string(i + 1)] = scene.instances[i].name;
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    legend["material"][std::to_string(i + 1)] = scene.materials[i].name;
  }
  return legend;
}

void TruthWriter::Finish(const ImuRecording& imu, double end_s) const {
  const fs::path truth = folder_ / kTruth;
  if (selection_.Any()) WriteJson(truth / "conventions.json", Conventions());
  if (selection_.ids) WriteJson(truth / "legend.json", Legend());
  if (selection_.imu) WriteFileAtomically(truth / "imu.csv", FormatImu(imu));
  if (selection_.poses) {
    const double start_s = poses_.front().time_s;
    WriteTumTrajectory(truth / "poses.txt",
                       world_.path.Sample(selection_.pose_rate_hz, start_s, end_s - start_s));
  }
}

}  // namespace silt::experiments
