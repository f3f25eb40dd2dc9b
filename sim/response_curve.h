// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "silt/core/image.h"
#include "silt/core/vector.h"

namespace silt::sim {

// How a camera encodes light: f takes a signal in [0, 1], linear in light, to a value in [0, 1],
// strictly increasing from f(0) = 0 to f(1) = 1. What is outside [0, 1] is clipped.
class ResponseCurve {
 public:
  ResponseCurve();  // sRGB, IEC 61966-2-1
  static ResponseCurve Linear();
  // f(x) = x^(1/g), g from 0.1 to 10.
  static ResponseCurve Gamma(double g);
  // Straight lines between points, read from a text file: a point a line, "linear encoded", both
  // strictly increasing, from "0 0" to "1 1"; '#' starts a comment. Throws silt::Error with file
  // and line.
  static ResponseCurve FromFile(const std::filesystem::path& file);
  // "srgb", "linear", "gamma:2.2" (any g), or else a file.
  static ResponseCurve Named(const std::string& name);

  // What Named() would make it of.
  const std::string& name() const { return name_; }

  double Encode(double linear) const;   // f
  double Decode(double encoded) const;  // f⁻¹
  double Slope(double linear) const;    // f′; between two lines of a table, that of the upper one

  // 255·f rounded to nearest.
  std::uint8_t Encode8(float linear) const;
  Image<Rgb8> Encode8(const Image<Vec3f>& linear) const;

 private:
  enum class Kind { kSrgb, kGamma, kTable };
  struct Point {
    double linear, encoded;
  };
  struct CodeTable;

  ResponseCurve(Kind kind, double gamma, std::vector<Point> points, std::string name);
  static const char* Misplaced(const std::vector<Point>& points, const Point& point);
  const Point* UpperPoint(double value, double Point::*coordinate) const;

  Kind kind_;
  double gamma_;
  std::vector<Point> points_;
  std::string name_;
  std::shared_ptr<const CodeTable> codes_;
};

}  // namespace silt::sim
