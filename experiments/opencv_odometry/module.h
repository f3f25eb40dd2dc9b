// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

// What the program and the module with OpenCV's rgbd share: plain data and one C function. OpenCV
// has whoever links rgbd link viz too, and with it a hundred libraries that take 35 ms to load, at
// each start of the program; and rgbd is not everywhere. So the module is loaded
// (opencv_odometry.h) only by the one command that wants it.
extern "C" {

struct SiltOdometryImages {
  const std::uint8_t* rgb;  // 8-bit sRGB, row by row without padding
  const float* depth_m;     // NaN: no measurement
};

struct SiltOdometryInput {
  int width, height;
  double fx, fy, cx, cy;  // fy > 0
  SiltOdometryImages reference, current;
  int with_icp;  // 0: cv::rgbd::RgbdOdometry, else RgbdICPOdometry, both with OpenCV's defaults
  int threads;
};

struct SiltOdometryOutput {
  int found;                          // 0: OpenCV gave no pose
  double milliseconds;                // from the images to the pose: gray images and pyramids too
  double current_from_reference[16];  // row by row
};

using SiltOpenCvOdometryFunction = void (*)(const SiltOdometryInput*, SiltOdometryOutput*);
}

inline constexpr const char* kSiltOpenCvOdometrySymbol = "SiltOpenCvOdometry";
