// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/imu_sample.h"
#include "silt/core/trajectory.h"
#include "silt/experiments/case_runner.h"
#include "silt/experiments/json.h"
#include "silt/sim/geometry_buffers.h"
#include "silt/sim/optical_flow.h"
#include "silt/sim/renderer.h"

namespace silt::experiments {

// Which truth is written beside a sequence.
struct TruthSelection {
  bool depth = false, normals = false, ids = false, flow = false, imu = false, poses = false;
  bool sharp = false;
  double pose_rate_hz = 1000;

  bool Any() const { return sharp || depth || normals || ids || flow || imu || poses; }
  Json ToJson() const;
};

// Writes what is true of a rendered sequence into its folder's truth/, of the middle of each row's
// exposure. Nothing of it is noisy, and all but the sharp picture is that of the ray through each
// pixel's centre.
//   sharp/                         000000.png: what an instant shows at the frame's own exposure
//   depth_z/ depth_ray/            000000.npy: float32, metres; 0: nothing is seen
//   normal_camera/ normal_world/   000000.npy: float32 × 3, unit, towards the camera
//   instance/ material/            000000.png: 16 bits; what a number means is in legend.json
//   flow_forward/ flow_backward/   000000.flo: to the next and the previous frame, in pixels
//   occlusion_forward/ …_backward/ 000000.png: 8 bits, sim::FlowState
//   imu.csv   poses.txt            readings; poses at a higher rate, in TUM's format
//   legend.json   conventions.json names; what is stated here, for programs
class TruthWriter {
 public:
  // All but the selection must outlive this. `poses` are the frames'.
  TruthWriter(std::filesystem::path folder, const TruthSelection& selection, const World& world,
              const sim::Renderer& renderer, Trajectory poses);

  std::vector<std::filesystem::path> FrameFiles(int number) const;
  std::vector<std::filesystem::path> SequenceFiles() const;
  // `index` is the frame's within the whole path, which noise and patterns are chosen by.
  void Write(int number, int index) const;
  // `imu` as selected; poses from the first frame to `end_s`.
  void Finish(const ImuRecording& imu, double end_s) const;

 private:
  sim::RowPoses PosesOf(int number) const;
  void WriteSharp(int number, int index) const;
  void WriteDepth(int number, const sim::GeometryBuffers& geometry) const;
  void WriteNormals(int number, const sim::GeometryBuffers& geometry) const;
  void WriteIds(int number, const sim::GeometryBuffers& geometry) const;
  void WriteFlow(int number, const sim::GeometryBuffers& geometry) const;
  Json Legend() const;

  std::filesystem::path folder_;
  TruthSelection selection_;
  const World& world_;
  const sim::Renderer& renderer_;
  sim::OpticalFlow flow_;
  std::optional<sim::LensMap> lens_;
  Trajectory poses_;
};

}  // namespace silt::experiments
