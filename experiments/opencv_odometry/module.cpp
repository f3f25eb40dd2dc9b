// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "module.h"

#include <chrono>
#include <opencv2/imgproc.hpp>
#include <opencv2/rgbd.hpp>

namespace {

using cv::rgbd::Odometry;

cv::Mat Colour(const SiltOdometryInput& in, const SiltOdometryImages& images) {
  return cv::Mat(in.height, in.width, CV_8UC3, const_cast<std::uint8_t*>(images.rgb));
}

cv::Mat Depth(const SiltOdometryInput& in, const SiltOdometryImages& images) {
  return cv::Mat(in.height, in.width, CV_32FC1, const_cast<float*>(images.depth_m));
}

cv::Ptr<Odometry> Make(const SiltOdometryInput& in) {
  const cv::Mat k = (cv::Mat_<double>(3, 3) << in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1);
  if (in.with_icp) return cv::rgbd::RgbdICPOdometry::create(k);
  return cv::rgbd::RgbdOdometry::create(k);
}

// OpenCV's source frame is the reference: its pose takes points of that into the other.
bool Compute(const SiltOdometryInput& in, Odometry& odometry, cv::Mat* pose) {
  cv::Mat reference, current;
  cv::cvtColor(Colour(in, in.reference), reference, cv::COLOR_RGB2GRAY);
  cv::cvtColor(Colour(in, in.current), current, cv::COLOR_RGB2GRAY);
  return odometry.compute(reference, Depth(in, in.reference), cv::Mat(), current,
                          Depth(in, in.current), cv::Mat(), *pose);
}

}  // namespace

extern "C" [[gnu::visibility("default")]] void SiltOpenCvOdometry(const SiltOdometryInput* in,
                                                                  SiltOdometryOutput* out) {
  *out = {};
  try {
    cv::setNumThreads(in->threads);
    const cv::Ptr<Odometry> odometry = Make(*in);
    cv::Mat pose;
    const auto start = std::chrono::steady_clock::now();
    out->found = Compute(*in, *odometry, &pose);
    const std::chrono::duration<double, std::milli> elapsed =
        std::chrono::steady_clock::now() - start;
    out->milliseconds = elapsed.count();
    if (!out->found) return;
    for (int i = 0; i < 16; ++i) out->current_from_reference[i] = pose.at<double>(i / 4, i % 4);
  } catch (const cv::Exception&) {
    out->found = 0;
  }
}
