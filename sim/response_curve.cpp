// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/response_curve.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"

namespace silt::sim {

namespace {

constexpr int kCells = 4096;
constexpr std::size_t kMostPoints = 65536;

double Unit(double value) { return value > 0 ? std::min(value, 1.0) : 0; }

[[noreturn]] void FailAt(const std::filesystem::path& file, int line, const std::string& what) {
  throw Error(file.string() + ":" + std::to_string(line) + ": " + what);
}

}  // namespace

// A code is reached where the encoded value passes code − ½; `first` gives for each cell of [0, 1]
// the code at its lower end, from which few steps remain.
struct ResponseCurve::CodeTable {
  std::array<float, 257> threshold;
  std::array<std::uint8_t, kCells + 1> first;

  explicit CodeTable(const ResponseCurve& curve) {
    threshold[0] = -1;
    threshold[256] = 2;
    for (int code = 1; code < 256; ++code) {
      threshold[std::size_t(code)] = float(curve.Decode((double(code) - 0.5) / 255));
    }
    int code = 0;
    for (int cell = 0; cell <= kCells; ++cell) {
      while (threshold[std::size_t(code) + 1] <= float(cell) / kCells) ++code;
      first[std::size_t(cell)] = std::uint8_t(code);
    }
  }

  std::uint8_t Code(float linear) const {
    if (!(linear > 0)) return 0;  // also what is not a number
    if (linear >= 1) return 255;
    std::size_t code = first[std::size_t(linear * kCells)];
    while (threshold[code + 1] <= linear) ++code;
    return std::uint8_t(code);
  }
};

ResponseCurve::ResponseCurve(Kind kind, double gamma, std::vector<Point> points, std::string name)
    : kind_(kind), gamma_(gamma), points_(std::move(points)), name_(std::move(name)) {
  codes_ = std::make_shared<const CodeTable>(*this);
}

ResponseCurve::ResponseCurve() : ResponseCurve(Kind::kSrgb, 1, {}, "srgb") {}

// What is wrong with a table's next point; null: nothing.
const char* ResponseCurve::Misplaced(const std::vector<Point>& points, const Point& point) {
  if (points.size() == kMostPoints) return "more than 65536 points";
  if (points.empty()) {
    return point.linear == 0 && point.encoded == 0 ? nullptr : "the first point must be '0 0'";
  }
  const bool above = point.linear > points.back().linear && point.encoded > points.back().encoded;
  return above ? nullptr : "both numbers must be above those of the point before";
}

ResponseCurve ResponseCurve::Linear() { return {Kind::kGamma, 1, {}, "linear"}; }

ResponseCurve ResponseCurve::Gamma(double g) {
  if (!(g >= 0.1 && g <= 10)) throw Error("response curve: gamma must be from 0.1 to 10");
  std::ostringstream name;
  name << "gamma:" << g;
  return {Kind::kGamma, g, {}, name.str()};
}

ResponseCurve ResponseCurve::FromFile(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || !std::filesystem::is_regular_file(file)) {
    throw Error("response curve: " + Quoted(file.string()) +
                " is no file, nor one of: srgb, linear, gamma:G");
  }
  std::vector<Point> points;
  int line = 0;
  for (std::string text; std::getline(in, text);) {
    ++line;
    std::istringstream words(text.substr(0, text.find('#')));
    if ((words >> std::ws).eof()) continue;
    Point point{};
    std::string rest;
    if (!(words >> point.linear >> point.encoded) || (words >> rest)) {
      FailAt(file, line, "expected two numbers, 'linear encoded', not " + Quoted(text));
    }
    if (const char* problem = Misplaced(points, point)) FailAt(file, line, problem);
    points.push_back(point);
  }
  if (points.size() < 2 || points.back().linear != 1 || points.back().encoded != 1) {
    FailAt(file, line, "the last point must be '1 1'");
  }
  return {Kind::kTable, 1, std::move(points), file.string()};
}

ResponseCurve ResponseCurve::Named(const std::string& name) {
  if (name == "srgb") return {};
  if (name == "linear") return Linear();
  const std::string prefix = "gamma:";
  if (name.compare(0, prefix.size(), prefix) != 0) return FromFile(name);
  double g = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + prefix.size(), end, g);
  if (error != std::errc() || stop != end) {
    throw Error("response curve: " + Quoted(name) + ": write gamma:2.2, for instance");
  }
  return Gamma(g);
}

// The upper end of the straight line that `value` lies on.
const ResponseCurve::Point* ResponseCurve::UpperPoint(double value,
                                                      double Point::*coordinate) const {
  const auto above = std::upper_bound(
      points_.begin() + 1, points_.end() - 1, value,
      [coordinate](double v, const Point& point) { return v < point.*coordinate; });
  return &*above;
}

double ResponseCurve::Encode(double linear) const {
  const double x = Unit(linear);
  if (kind_ == Kind::kSrgb) return SrgbFromLinear(float(x));
  if (kind_ == Kind::kGamma) return std::pow(x, 1 / gamma_);
  const Point* b = UpperPoint(x, &Point::linear);
  return b->encoded - (b->linear - x) * Slope(x);
}

double ResponseCurve::Decode(double encoded) const {
  const double y = Unit(encoded);
  if (kind_ == Kind::kSrgb) return LinearFromSrgb(float(y));
  if (kind_ == Kind::kGamma) return std::pow(y, gamma_);
  const Point *b = UpperPoint(y, &Point::encoded), *a = b - 1;
  return b->linear - (b->encoded - y) * (b->linear - a->linear) / (b->encoded - a->encoded);
}

double ResponseCurve::Slope(double linear) const {
  const double x = Unit(linear);
  if (kind_ == Kind::kSrgb) {
    return x <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(x, 1 / 2.4 - 1);
  }
  if (kind_ == Kind::kGamma) return std::pow(x, 1 / gamma_ - 1) / gamma_;
  const Point *b = UpperPoint(x, &Point::linear), *a = b - 1;
  return (b->encoded - a->encoded) / (b->linear - a->linear);
}

std::uint8_t ResponseCurve::Encode8(float linear) const { return codes_->Code(linear); }

Image<Rgb8> ResponseCurve::Encode8(const Image<Vec3f>& linear) const {
  Image<Rgb8> encoded(linear.width(), linear.height());
  ParallelFor(linear.height(), [&](int y) {
    const Vec3f* in = linear.row(y);
    Rgb8* out = encoded.row(y);
    for (int x = 0; x < linear.width(); ++x) {
      out[x] = {codes_->Code(in[x].x), codes_->Code(in[x].y), codes_->Code(in[x].z)};
    }
  });
  return encoded;
}

}  // namespace silt::sim
