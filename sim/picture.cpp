// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/picture.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/sim/picture_size.h"

namespace silt::sim {
namespace {

constexpr std::uint64_t kMostPixels = 1u << 26;
constexpr std::size_t kMostBytes = std::size_t(1) << 30;

// A picture that would take gigabytes, whatever its file is worth, and all whose size cannot be
// told beforehand: that leaves four formats of those that OpenCV decodes, in this process, and all
// four are fed with broken files in the tests.
void RefuseHuge(const std::string& bytes, const std::string& place) {
  if (bytes.size() > kMostBytes) throw Error(place + ": is larger than 1 GiB");
  const auto size = DeclaredPictureSize(bytes);
  if (!size)
    throw Error(place + ": is not an image, or is damaged: PNG, JPEG, BMP and TIFF are read");
  if (size->width * size->height <= kMostPixels) return;
  throw Error(place + ": has " + std::to_string(size->width) + " x " +
              std::to_string(size->height) + " pixels, more than the " +
              std::to_string(kMostPixels) + " that are read");
}

cv::Mat DecodeFile(const std::string& bytes, const std::string& place) {
  RefuseHuge(bytes, place);
  cv::Mat image;
  if (!bytes.empty()) {
    const cv::Mat view(1, int(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    try {
      image = cv::imdecode(view, cv::IMREAD_UNCHANGED);
    } catch (const cv::Exception& e) {
      throw Error(place + ": cannot be decoded: " + e.err);
    }
  }
  if (image.empty()) throw Error(place + ": is not an image, or is damaged");
  if (image.depth() == CV_16U) image.convertTo(image, CV_8U, 1 / 257.0);
  if (image.depth() != CV_8U) throw Error(place + ": must have 8 or 16 bits per channel");
  return image;
}

Image<Rgba8> RgbaFromMat(const cv::Mat& image, const std::string& place) {
  Image<Rgba8> rgba(image.cols, image.rows);
  cv::Mat view(image.rows, image.cols, CV_8UC4, rgba.data());
  switch (image.channels()) {
    case 1:
      cv::cvtColor(image, view, cv::COLOR_GRAY2RGBA);
      break;
    case 3:
      cv::cvtColor(image, view, cv::COLOR_BGR2RGBA);
      break;
    case 4:
      cv::cvtColor(image, view, cv::COLOR_BGRA2RGBA);
      break;
    default:
      throw Error(place + ": must have 1, 3 or 4 channels");
  }
  return rgba;
}

// One opacity per texel of a picture of that size.
cv::Mat DecodeOpacity(const EncodedPicture& picture, const cv::Size& size) {
  const cv::Mat image = DecodeFile(*picture.opacity, picture.opacity_place);
  cv::Mat opacity;
  if (image.channels() == 4) {
    cv::extractChannel(image, opacity, 3);
  } else if (image.channels() == 3) {
    cv::cvtColor(image, opacity, cv::COLOR_BGR2GRAY);
  } else {
    opacity = image;
  }
  if (opacity.size() != size) cv::resize(opacity, opacity, size, 0, 0, cv::INTER_LINEAR);
  return opacity;
}

}  // namespace

Image<Rgba8> DecodePicture(const EncodedPicture& picture) {
  Image<Rgba8> rgba = picture.colour
                          ? RgbaFromMat(DecodeFile(*picture.colour, picture.place), picture.place)
                          : picture.texels;
  if (picture.opacity) {
    const cv::Mat opacity = DecodeOpacity(picture, {rgba.width(), rgba.height()});
    for (int y = 0; y < rgba.height(); ++y) {
      for (int x = 0; x < rgba.width(); ++x) rgba(x, y).a = opacity.at<std::uint8_t>(y, x);
    }
  }
  return rgba;
}

}  // namespace silt::sim
