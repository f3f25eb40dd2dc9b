// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/core/io/sequence_writer.h"

namespace silt {

// The layout of the EuRoC MAV sequences, times in nanoseconds:
//   mav0/cam0/data/<time>.png           gray, 8 bits, the time in 19 digits
//   mav0/cam0/data.csv, sensor.yaml     names; T_BS (the identity), rate, intrinsics
//   mav0/depth0/data/<time>.png         an addition: depth along z, 16 bits, 5000 per metre
//   mav0/depth0/data.csv
//   mav0/imu0/data.csv, sensor.yaml     gyro and accelerometer; noise densities; where there is one
//   mav0/state_groundtruth_estimate0/data.csv, sensor.yaml
// The body is the camera (x right, y down, z forward), the reference frame is the world, z up.
// The states are those of the IMU's readings; without an IMU those of the frames, with velocities
// from the positions' differences.
class EurocSequenceWriter : public SequenceWriter {
 public:
  EurocSequenceWriter(std::filesystem::path folder, SequenceDescription description);

  std::vector<std::filesystem::path> FrameFiles(int number) const override;
  std::vector<std::filesystem::path> SequenceFiles() const override;
  void Write(int number, const Frame& frame) override;
  void Finish() override;

 private:
  void WriteCamera() const;
  void WriteDepthList() const;
  void WriteImu() const;
  void WriteStates() const;
  std::string ImageList() const;

  std::filesystem::path mav_;
  SequenceDescription description_;
};

}  // namespace silt
