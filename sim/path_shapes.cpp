// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "silt/core/error.h"
#include "silt/sim/look_at.h"

namespace silt::sim {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kLongestStep_s = 0.05;
constexpr double kKeysPerPeriod = 60;
constexpr double kMostKeys = 200'000;
constexpr double kLargestTurn_rad = 10 * kRadians;

SE3d PoseAt(const Vec3d& position, const ShapeView& view, double time_s) {
  const Vec3d direction = view.look_at ? *view.look_at - position : view.direction;
  if (!HasHeading(direction)) {
    throw Error("the camera looks straight up or down, or nowhere, at " + std::to_string(time_s) +
                " s: move look_at (or direction)");
  }
  const SE3d pose = LookAt(position, position + direction);
  return {pose.rotation * Quaterniond::Exp({0, 0, view.roll_rad}), position};
}

// Keys of a motion, given on the eased clock, whose fastest part repeats every period_s or slower.
Trajectory Sampled(const std::function<Vec3d(double)>& position_at, double period_s,
                   const ShapeView& view, const ShapeTiming& timing) {
  timing.Validate();
  const double step_s = std::min(kLongestStep_s, period_s / kKeysPerPeriod);
  const double steps = std::max(4.0, std::ceil(timing.duration_s / step_s));
  if (!(steps <= kMostKeys))
    throw Error("the motion is too long for its speed: shorten duration_s");
  Trajectory keys;
  for (int i = 0; i <= int(steps); ++i) {
    const double time_s = timing.duration_s * i / steps;
    keys.push_back({time_s, PoseAt(position_at(timing.Eased(time_s)), view, time_s)});
    if (i == 0) continue;
    const Quaterniond& last = keys[keys.size() - 2].world_from_camera.rotation;
    if (RotationAngle(last.Conjugate() * keys.back().world_from_camera.rotation) >
        kLargestTurn_rad) {
      throw Error("the camera turns too fast at " + std::to_string(time_s) +
                  " s: it passes too near to look_at");
    }
  }
  return keys;
}

}  // namespace

void ShapeTiming::Validate() const {
  if (!(duration_s >= 0.01 && duration_s <= 1e5))
    throw Error("duration_s must be in 0.01 … 100000");
  if (!(ease_s >= 0 && ease_s <= duration_s / 2)) {
    throw Error("ease_s must be in 0 … duration_s/2");
  }
}

double ShapeTiming::Eased(double time_s) const {
  const double middle = duration_s / 2;
  if (time_s > middle) return EasedEnd() - Eased(std::max(0.0, duration_s - time_s));
  if (time_s >= ease_s) return time_s - ease_s / 2;
  const double x = time_s / ease_s;
  return ease_s * x * x * x * (1 - x / 2);
}

Trajectory KeysOf(const Orbit& orbit, const ShapeView& view, const ShapeTiming& timing) {
  if (!(orbit.radius > 0)) throw Error("radius must be above 0");
  if (!(std::abs(orbit.sweep_rad) > 0)) throw Error("sweep_deg must not be 0");
  timing.Validate();
  const double rate = orbit.sweep_rad / timing.EasedEnd();
  const auto position = [&](double t) {
    const double angle = orbit.from_rad + rate * t;
    return orbit.center + orbit.radius * Vec3d{std::cos(angle), std::sin(angle), 0};
  };
  return Sampled(position, 2 * std::numbers::pi / std::abs(rate), view, timing);
}

Trajectory KeysOf(const Line& line, const ShapeView& view, const ShapeTiming& timing) {
  timing.Validate();
  const Vec3d way = line.to - line.from;
  const auto position = [&](double t) { return line.from + (t / timing.EasedEnd()) * way; };
  return Sampled(position, timing.duration_s, view, timing);
}

Trajectory KeysOf(const Lissajous& lissajous, const ShapeView& view, const ShapeTiming& timing) {
  const Vec3d &f = lissajous.frequency_hz, &phase = lissajous.phase_rad;
  for (const double hz : {f.x, f.y, f.z}) {
    if (!(hz >= 0 && hz <= 20)) throw Error("frequency_hz must be in 0 … 20");
  }
  const auto position = [&](double t) {
    const double turn = 2 * std::numbers::pi * t;
    const Vec3d swing{std::sin(turn * f.x + phase.x), std::sin(turn * f.y + phase.y),
                      std::sin(turn * f.z + phase.z)};
    return lissajous.center + lissajous.amplitude * swing;
  };
  const double fastest_hz = std::max({f.x, f.y, f.z, 1e-9});
  return Sampled(position, 1 / fastest_hz, view, timing);
}

}  // namespace silt::sim
