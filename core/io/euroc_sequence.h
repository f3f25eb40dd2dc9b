// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "silt/core/recorded_sequence.h"

namespace silt {

// Reads camera 0 of a folder in the layout of the EuRoC MAV sequences, as euroc_sequence_writer.h
// states it: mav0/cam0, the states of the body (moved to the camera by its T_BS) and, where silt
// added it, mav0/depth0. Throws silt::Error for a lens with distortion: the frames of silt's
// tracker are those of a pinhole.
class EurocSequence : public RecordedSequence {
 public:
  explicit EurocSequence(const std::filesystem::path& folder);

  const PinholeCamera& camera() const override { return camera_; }
  int size() const override { return int(images_.size()); }
  std::optional<Frame> Next() override;
  std::vector<double> times_s() const override;
  const Trajectory& truth() const override { return truth_; }

 private:
  struct StampedImage {
    double time_s;
    std::string name;
  };

  std::filesystem::path mav_;
  PinholeCamera camera_;
  std::vector<StampedImage> images_;
  Trajectory truth_;
  std::size_t next_ = 0;
};

}  // namespace silt
