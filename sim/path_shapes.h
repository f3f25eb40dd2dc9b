// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "silt/core/trajectory.h"

// Simple camera motions, as key poses so dense that PoseSpline::Through them follows the shape to
// 1e-5 of its size (at the very ends, where the spline may not accelerate, to 1e-4 without easing).
// All throw silt::Error, without a place, for what cannot be: times, frequencies and sizes out of
// range, a view straight up or down, a camera that would have to turn by more than 10° between
// keys.
namespace silt::sim {

// A motion lasts duration_s. With ease_s it starts from rest and comes to rest: the speed rises as
// smoothstep during the first ease_s, falls likewise during the last, and is constant in between.
struct ShapeTiming {
  double duration_s = 0;
  double ease_s = 0;  // in 0 … duration_s/2

  // The clock τ that the shape runs on; τ(0) = 0 and dτ/dt = 1 between the ramps:
  //   τ(t) = e·(x³ − x⁴/2) for x = t/e ≤ 1, then t − e/2; mirrored at the end.
  double Eased(double time_s) const;
  // τ(duration_s) = duration − ease.
  double EasedEnd() const { return duration_s - ease_s; }
  // Throws silt::Error.
  void Validate() const;
};

// Where the camera looks: at a point, or always in one direction.
struct ShapeView {
  std::optional<Vec3d> look_at;
  Vec3d direction;
  double roll_rad = 0;  // as roll_deg in path_file.h
};

// A circle about a vertical axis, at constant height.
struct Orbit {
  Vec3d center;  // of the circle
  double radius = 0;
  double from_rad = 0;                     // 0: the camera starts at center + (radius, 0, 0)
  double sweep_rad = 6.28318530717958648;  // anticlockwise from above; may be negative
};

struct Line {
  Vec3d from, to;
};

// center + amplitude·sin(2π·frequency·τ + phase), axis by axis.
struct Lissajous {
  Vec3d center, amplitude, frequency_hz, phase_rad;
};

Trajectory KeysOf(const Orbit& orbit, const ShapeView& view, const ShapeTiming& timing);
Trajectory KeysOf(const Line& line, const ShapeView& view, const ShapeTiming& timing);
Trajectory KeysOf(const Lissajous& lissajous, const ShapeView& view, const ShapeTiming& timing);

}  // namespace silt::sim
