// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <numbers>
#include <string>

#include "silt/core/error.h"
#include "silt/sim/path_tables.h"

namespace silt::sim {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

// Keys that all shapes have.
ShapeTiming ReadTiming(const TomlTable& shape) {
  return {shape.Number("duration_s"), shape.Number("ease_s", 0)};
}

// look_at or direction, and the roll; `fallback` where neither is given.
ShapeView ReadView(const TomlTable& shape, const ShapeView& fallback) {
  ShapeView view = fallback;
  if (shape.Has("look_at") && shape.Has("direction")) {
    shape.Fail("direction", "and look_at exclude each other");
  }
  if (shape.Has("look_at")) view.look_at = shape.Vector("look_at");
  if (shape.Has("direction")) {
    view.look_at.reset();
    view.direction = shape.Vector("direction");
  }
  view.roll_rad = kRadians * shape.Number("roll_deg", 0);
  return view;
}

template <typename Shape>
PoseSpline ThroughShape(const TomlTable& table, const Shape& shape, const ShapeView& view) {
  const ShapeTiming timing = ReadTiming(table);
  table.RejectUnknownKeys();
  try {
    return PoseSpline::Through(KeysOf(shape, view, timing));
  } catch (const Error& error) {
    throw Error(table.place() + ": " + error.what());
  }
}

}  // namespace

PoseSpline ReadOrbit(const TomlTable& table) {
  Orbit orbit;
  orbit.center = table.Vector("center");
  orbit.radius = table.Number("radius");
  orbit.from_rad = kRadians * table.Number("from_deg", 0);
  orbit.sweep_rad = kRadians * table.Number("sweep_deg", 360);
  return ThroughShape(table, orbit, ReadView(table, {.look_at = orbit.center, .direction = {}}));
}

PoseSpline ReadLine(const TomlTable& table) {
  const Line line{table.Vector("from"), table.Vector("to")};
  const Vec3d way = line.to - line.from;
  if (!(Norm(way) > 1e-6)) table.Fail("to", "is the same point as from");
  return ThroughShape(table, line, ReadView(table, {.look_at = {}, .direction = way}));
}

PoseSpline ReadLissajous(const TomlTable& table) {
  Lissajous lissajous;
  lissajous.center = table.Vector("center");
  lissajous.amplitude = table.Vector("amplitude");
  lissajous.frequency_hz = table.Vector("frequency_hz");
  lissajous.phase_rad = kRadians * table.Vector("phase_deg", {});
  if (!table.Has("look_at") && !table.Has("direction")) {
    table.Fail("look_at", "is missing: give a point to look at, or a direction");
  }
  return ThroughShape(table, lissajous, ReadView(table, {}));
}

}  // namespace silt::sim
