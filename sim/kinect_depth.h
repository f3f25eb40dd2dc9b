// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include "silt/sim/depth_sensor.h"

namespace silt::sim {

// The Kinect of ICL-NUIM (Handa et al., "A Benchmark for RGB-D Visual Odometry, 3D Reconstruction
// and SLAM", ICRA 2014, after Barron and Malik, CVPR 2013):
//   z' = bilinear depth at (u + N(0, ½), v + N(0, ½)) pixels,
//   z_cm = 35130 / ⌊35130 / z'_cm + N(0, 1/6) + ½⌋,
// that is, disparity rounded to ⅛ pixel: 35130 cm = 8 · 585.5 px · 7.5 cm. The bilinear depth makes
// points fly between what lies before and behind an edge, as ICL-NUIM's do.
class KinectDepth : public DepthSensor {
 public:
  enum class Rounding {
    kFloor,    // as published: unbiased in disparity
    kNearest,  // the public Python code (and ICL-NUIM's noisy frames): ½ a step too near, which
               // makes depths too small by z²·0.5/351.3 metres
  };
  explicit KinectDepth(Rounding rounding) : rounding_(rounding) {}
  Image<float> Measure(const DepthView& view, const NoiseKey& key) const override;

 private:
  Rounding rounding_;
};

}  // namespace silt::sim
