// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace silt::sim {

// A function of time at one instant, with its first and second derivative: f, ḟ, f̈ (per s, per s²).
// A pose evaluated on TimeJets yields velocities and accelerations that are exact derivatives of
// the very pose that is rendered, whatever it is composed of.
struct TimeJet {
  double value = 0, d1 = 0, d2 = 0;

  constexpr TimeJet() = default;
  constexpr explicit TimeJet(double constant) : value(constant) {}
  constexpr TimeJet(double f, double df, double ddf) : value(f), d1(df), d2(ddf) {}

  // Time itself.
  static constexpr TimeJet Time(double time_s) { return {time_s, 1, 0}; }

  // g(f) from g, g' and g'' at f: g'·ḟ and g''·ḟ² + g'·f̈.
  constexpr TimeJet Chain(double g, double dg, double ddg) const {
    return {g, dg * d1, ddg * d1 * d1 + dg * d2};
  }
};

constexpr TimeJet operator+(const TimeJet& a, const TimeJet& b) {
  return {a.value + b.value, a.d1 + b.d1, a.d2 + b.d2};
}
constexpr TimeJet operator-(const TimeJet& a) { return {-a.value, -a.d1, -a.d2}; }
constexpr TimeJet operator-(const TimeJet& a, const TimeJet& b) { return a + (-b); }
constexpr TimeJet operator*(const TimeJet& a, const TimeJet& b) {
  return {a.value * b.value, a.d1 * b.value + a.value * b.d1,
          a.d2 * b.value + 2 * a.d1 * b.d1 + a.value * b.d2};
}
constexpr TimeJet operator/(const TimeJet& a, const TimeJet& b) {
  const double r = 1 / b.value;
  return a * b.Chain(r, -r * r, 2 * r * r * r);
}
constexpr bool operator<(const TimeJet& a, const TimeJet& b) { return a.value < b.value; }

inline TimeJet sqrt(const TimeJet& a) {
  const double root = std::sqrt(a.value);
  return a.Chain(root, 0.5 / root, -0.25 / (root * a.value));
}
inline TimeJet sin(const TimeJet& a) {
  const double s = std::sin(a.value);
  return a.Chain(s, std::cos(a.value), -s);
}
inline TimeJet cos(const TimeJet& a) {
  const double c = std::cos(a.value);
  return a.Chain(c, -std::sin(a.value), -c);
}

}  // namespace silt::sim
