// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/path_file.h"

#include <optional>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/path_tables.h"
#include "silt/sim/toml_table.h"

namespace silt::sim {
namespace {

namespace fs = std::filesystem;

HandShake ParseHandShake(const TomlTable& file) {
  const std::optional<TomlTable> table = file.Table("hand_shake");
  if (!table) return {};
  HandShakeOptions options;
  options.position_mm = table->Number("position_mm", options.position_mm);
  options.rotation_deg = table->Number("rotation_deg", options.rotation_deg);
  const int seed = table->Integer("seed", 0);
  if (seed < 0) table->Fail("seed", "must not be negative");
  options.seed = std::uint64_t(seed);
  if (table->Has("band_hz")) {
    const std::vector<double> band = table->Numbers("band_hz", 2);
    options.low_hz = band[0];
    options.high_hz = band[1];
  }
  table->RejectUnknownKeys();
  try {
    return HandShake(options);
  } catch (const Error& error) {
    throw Error(table->place() + ": " + error.what());
  }
}

struct BaseMotion {
  PoseSpline spline;
  std::optional<FitResiduals> fit;
};

BaseMotion ReadBaseMotion(const TomlTable& file, const fs::path& folder) {
  if (const auto table = file.Table("replay")) {
    const SmoothedTrajectory replay = ReadReplay(*table, folder);
    return {replay.spline, replay.residuals};
  }
  if (const auto table = file.Table("orbit")) return {ReadOrbit(*table), {}};
  if (const auto table = file.Table("line")) return {ReadLine(*table), {}};
  if (const auto table = file.Table("lissajous")) return {ReadLissajous(*table), {}};
  return {ReadKeys(file), {}};
}

CameraPath ReadPath(const TomlTable& file, const fs::path& folder) {
  std::string first;
  for (const char* const kind : {"replay", "orbit", "line", "lissajous", "key"}) {
    if (!file.Has(kind)) continue;
    if (!first.empty()) file.Fail(kind, "and " + first + " exclude each other: keep one motion");
    first = kind;
  }
  BaseMotion motion = ReadBaseMotion(file, folder);
  HandShake shake = ParseHandShake(file);
  file.RejectUnknownKeys();
  return CameraPath(std::move(motion.spline), std::move(shake), motion.fit);
}

}  // namespace

CameraPath LoadCameraPath(const fs::path& file) {
  return ReadPath(TomlTable::ReadFile(file), file.parent_path());
}

CameraPath ParseCameraPath(const std::string& text, const std::string& name) {
  return ReadPath(TomlTable::Parse(text, name), fs::path(name).parent_path());
}

}  // namespace silt::sim
