// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/sim/asset_source.h"

namespace silt::sim {

namespace {

constexpr double kPi = std::numbers::pi;

double Luminance(const Vec3f& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

// The interval that holds `value`, of those between cumulative sums, and where in it.
std::pair<int, double> Invert(const double* sums, int intervals, double value) {
  const double target = value * sums[intervals];
  const auto* above = std::upper_bound(sums + 1, sums + intervals, target);
  const int i = int(above - sums) - 1;
  const double width = sums[i + 1] - sums[i];
  return {i, width > 0 ? std::clamp((target - sums[i]) / width, 0.0, 1.0) : 0.5};
}

cv::Mat ReadPicture(const std::filesystem::path& file) {
  const Bytes bytes = FolderSource().Read(file.string());
  if (bytes->empty()) return {};
  try {
    return cv::imdecode(cv::Mat(1, int(bytes->size()), CV_8U, const_cast<char*>(bytes->data())),
                        cv::IMREAD_COLOR | cv::IMREAD_ANYDEPTH);
  } catch (const cv::Exception& e) {
    throw Error(file.string() + ": cannot be decoded: " + e.err);
  }
}

// Linear colour of a texel that counts up to `full`; 0: in floating point, linear already.
Vec3f LinearTexel(const cv::Vec3f& bgr, float full) {
  if (full == 0) return {bgr[2], bgr[1], bgr[0]};
  return {LinearFromSrgb(bgr[2] / full), LinearFromSrgb(bgr[1] / full),
          LinearFromSrgb(bgr[0] / full)};
}

}  // namespace

Vec2d EquirectangularFromDirection(const Vec3d& d) {
  const double azimuth = std::atan2(d.x, d.y);  // clockwise from +y
  const double polar = std::atan2(std::hypot(d.x, d.y), d.z);
  return {std::clamp(0.5 + azimuth / (2 * kPi), 0.0, 1.0), polar / kPi};
}

Vec3d DirectionFromEquirectangular(const Vec2d& uv) {
  const double azimuth = 2 * kPi * (uv.x - 0.5), polar = kPi * uv.y;
  return {std::sin(polar) * std::sin(azimuth), std::sin(polar) * std::cos(azimuth),
          std::cos(polar)};
}

Environment::Environment(Image<Vec3f> radiance, double yaw_rad)
    : radiance_(std::move(radiance)), yaw_rad_(yaw_rad) {
  SILT_CHECK(!radiance_.empty());
  const int width = radiance_.width(), height = radiance_.height();
  rows_up_to_.push_back(0);
  columns_up_to_ = Image<double>(width + 1, height);
  Vec3d sum;
  for (int y = 0; y < height; ++y) {
    solid_angle_.push_back(2 * kPi / width *
                           (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height)));
    for (int x = 0; x < width; ++x) {
      double weight = 0;  // the largest about it, so that it bounds what lies in between
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height - 1); ++j) {
        for (int i = x - 1; i <= x + 1; ++i) {
          weight = std::max(weight, Luminance(radiance_((i + width) % width, j)));
        }
      }
      columns_up_to_(x + 1, y) = columns_up_to_(x, y) + weight;
      sum += solid_angle_.back() * radiance_(x, y).Cast<double>();
    }
    rows_up_to_.push_back(rows_up_to_.back() + solid_angle_.back() * columns_up_to_(width, y));
  }
  mean_ = (1 / (4 * kPi) * sum).Cast<float>();
}

Vec2d Environment::PlaceOf(const Vec3f& direction) const {
  const double c = std::cos(yaw_rad_), s = std::sin(yaw_rad_);
  const Vec3d d = direction.Cast<double>();
  return EquirectangularFromDirection({c * d.x + s * d.y, c * d.y - s * d.x, d.z});
}

Vec3f Environment::Bilinear(const Vec2d& uv) const {
  const int width = radiance_.width(), height = radiance_.height();
  const double x = uv.x * width - 0.5, y = uv.y * height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  Vec3f sum;
  for (const int j : {0, 1}) {
    for (const int i : {0, 1}) {
      const double weight =
          (i == 1 ? x - left : 1 - (x - left)) * (j == 1 ? y - top : 1 - (y - top));
      sum += float(weight) *
             radiance_((int(left) + i + width) % width, std::clamp(int(top) + j, 0, height - 1));
    }
  }
  return sum;
}

Vec3f Environment::Radiance(const Vec3f& direction) const { return Bilinear(PlaceOf(direction)); }

double Environment::TexelDensity(int x, int y) const {
  const double total = rows_up_to_.back();
  return total > 0 ? (columns_up_to_(x + 1, y) - columns_up_to_(x, y)) / total : 0;
}

float Environment::Density(const Vec3f& direction) const {
  const Vec2d uv = PlaceOf(direction);
  const int width = radiance_.width(), height = radiance_.height();
  return float(TexelDensity(std::clamp(int(uv.x * width), 0, width - 1),
                            std::clamp(int(uv.y * height), 0, height - 1)));
}

Environment::Sample Environment::Draw(const Vec2f& random) const {
  if (rows_up_to_.back() <= 0) return {};
  const int width = radiance_.width(), height = radiance_.height();
  const auto [y, down] = Invert(rows_up_to_.data(), height, random.y);
  const auto [x, across] = Invert(columns_up_to_.row(y), width, random.x);
  // Uniform in solid angle within the texel: cos of the polar angle is linear.
  const double upper = std::cos(kPi * y / height), lower = std::cos(kPi * (y + 1) / height);
  const Vec2d uv{(x + across) / width,
                 std::acos(std::clamp(upper + down * (lower - upper), -1.0, 1.0)) / kPi};
  const Vec3d d = DirectionFromEquirectangular(uv);
  const double c = std::cos(yaw_rad_), s = std::sin(yaw_rad_);
  const Vec3d world{c * d.x - s * d.y, c * d.y + s * d.x, d.z};
  return {world.Cast<float>(), Bilinear(uv), float(TexelDensity(x, y))};
}

Environment MakeSky(const Sky& sky) {
  constexpr int height = 64;
  Image<Vec3f> picture(1, height);
  for (int y = 0; y < height; ++y) {
    // Skies brighten towards the horizon fast, hence the root.
    const double up = std::cos(kPi * (y + 0.5) / height);
    const double share = std::sqrt(std::max(up, 0.0));
    const Vec3d color = up < 0 ? sky.ground : (1 - share) * sky.horizon + share * sky.zenith;
    picture(0, y) = color.Cast<float>();
  }
  return Environment(std::move(picture));
}

Environment LoadEnvironment(const std::filesystem::path& file, double strength, double yaw_rad) {
  const cv::Mat picture = ReadPicture(file);
  if (picture.empty()) throw Error(file.string() + ": is not a picture that OpenCV reads");
  const float full = picture.depth() == CV_8U ? 255.0f : picture.depth() == CV_16U ? 65535.0f : 0;
  cv::Mat values;
  picture.convertTo(values, CV_32FC3);
  Image<Vec3f> radiance(values.cols, values.rows);
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) {
      Vec3f texel = float(strength) * LinearTexel(values.at<cv::Vec3f>(y, x), full);
      for (float* c : {&texel.x, &texel.y, &texel.z}) {
        *c = std::isfinite(*c) ? std::max(*c, 0.0f) : 0.0f;
      }
      radiance(x, y) = texel;
    }
  }
  return Environment(std::move(radiance), yaw_rad);
}

}  // namespace silt::sim
