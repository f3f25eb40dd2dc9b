// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/image_file.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "silt/core/atomic_file.h"
#include "silt/core/error.h"
#include "silt/core/pyramid.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

cv::Mat ReadAny(const fs::path& file, int flags) {
  if (!fs::is_regular_file(file)) throw Error(file.string() + ": no such image file");
  cv::Mat image;
  try {
    image = cv::imread(file.string(), flags);
  } catch (const cv::Exception& e) {
    throw Error(file.string() + ": cannot be decoded: " + e.err);
  }
  if (image.empty()) throw Error(file.string() + ": is not an image, or is damaged");
  return image;
}

// Encoded in memory: OpenCV's own writer takes no notice of a disk that is full when it closes the
// file.
void WritePng(const fs::path& file, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  // Level 1 of deflate: half the time of the default for a tenth more bytes.
  if (!cv::imencode(".png", image, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1})) {
    throw Error(file.string() + ": cannot be encoded as PNG");
  }
  WriteFileAtomically(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

template <typename T>
void WriteChannel(const fs::path& file, const Image<T>& gray, int type) {
  if (gray.empty()) throw Error(file.string() + ": an empty image cannot be written");
  WritePng(file, cv::Mat(gray.height(), gray.width(), type, const_cast<T*>(gray.data())));
}

template <typename T>
Image<T> ReadChannel(const fs::path& file, int type) {
  const cv::Mat raw = ReadAny(file, cv::IMREAD_UNCHANGED);
  if (raw.type() != type) {
    throw Error(file.string() + ": is not an image of one channel of " +
                std::to_string(8 * sizeof(T)) + " bits");
  }
  Image<T> gray(raw.cols, raw.rows);
  for (int y = 0; y < raw.rows; ++y) std::copy_n(raw.ptr<T>(y), raw.cols, gray.row(y));
  return gray;
}

}  // namespace

Image<Rgb8> ReadRgb(const fs::path& file) {
  const cv::Mat bgr = ReadAny(file, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  Image<Rgb8> rgb(bgr.cols, bgr.rows);
  cv::Mat view(rgb.height(), rgb.width(), CV_8UC3, rgb.data());
  cv::cvtColor(bgr, view, cv::COLOR_BGR2RGB);
  return rgb;
}

Image<float> ReadDepth(const fs::path& file, double per_metre) {
  const cv::Mat raw = ReadAny(file, cv::IMREAD_UNCHANGED);
  if (raw.type() != CV_16UC1) {
    throw Error(file.string() + ": a depth image has one 16-bit channel, this one has not");
  }
  Image<float> depth_m(raw.cols, raw.rows);
  for (int y = 0; y < raw.rows; ++y) {
    const auto* in = raw.ptr<std::uint16_t>(y);
    for (int x = 0; x < raw.cols; ++x) depth_m(x, y) = float(in[x] / per_metre);
  }
  return depth_m;
}

void WriteRgb(const fs::path& file, const Image<Rgb8>& rgb) {
  if (rgb.empty()) throw Error(file.string() + ": an empty image cannot be written");
  const cv::Mat view(rgb.height(), rgb.width(), CV_8UC3, const_cast<Rgb8*>(rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(view, bgr, cv::COLOR_RGB2BGR);
  WritePng(file, bgr);
}

void WriteDepth(const fs::path& file, const Image<float>& depth_m, double per_metre) {
  if (depth_m.empty()) throw Error(file.string() + ": an empty image cannot be written");
  cv::Mat raw(depth_m.height(), depth_m.width(), CV_16UC1);
  for (int y = 0; y < raw.rows; ++y) {
    auto* out = raw.ptr<std::uint16_t>(y);
    for (int x = 0; x < raw.cols; ++x) {
      const double steps = std::round(depth_m(x, y) * per_metre);
      out[x] = IsMeasured(depth_m(x, y)) && steps <= 65535 ? std::uint16_t(steps) : 0;
    }
  }
  WritePng(file, raw);
}

void WriteGray(const fs::path& file, const Image<std::uint8_t>& gray) {
  WriteChannel(file, gray, CV_8UC1);
}
void WriteGray(const fs::path& file, const Image<std::uint16_t>& gray) {
  WriteChannel(file, gray, CV_16UC1);
}
Image<std::uint8_t> ReadGray8(const fs::path& file) {
  return ReadChannel<std::uint8_t>(file, CV_8UC1);
}
Image<std::uint16_t> ReadGray16(const fs::path& file) {
  return ReadChannel<std::uint16_t>(file, CV_16UC1);
}

}  // namespace silt
