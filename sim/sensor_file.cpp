// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sensor_file.h"

#include <optional>
#include <string>
#include <utility>

#include "silt/core/error.h"
#include "silt/sim/toml_table.h"

namespace silt::sim {

namespace {

// Calls body, and says of an error from it where the file asks for that.
template <typename Body>
void At(const std::string& place, const Body& body) {
  try {
    body();
  } catch (const Error& error) {
    throw Error(place + ": " + error.what());
  }
}

HandaNoise ReadHanda(const TomlTable& table) {
  HandaNoise noise;
  noise.sigma_shot = table.Vector("sigma_shot", noise.sigma_shot);
  noise.sigma_read = table.Vector("sigma_read", noise.sigma_read);
  return noise;
}

EmvaNoise ReadEmva(const TomlTable& table) {
  EmvaNoise noise;
  const auto read = [&](const char* key, double& value) { value = table.Number(key, value); };
  read("quantum_efficiency", noise.quantum_efficiency);
  read("full_well_e", noise.full_well_e);
  read("read_noise_e", noise.read_noise_e);
  read("dark_current_e_per_s", noise.dark_current_e_per_s);
  read("exposure_s", noise.exposure_s);
  read("photons_at_white", noise.photons_at_white);
  read("gain_dn_per_e", noise.gain_dn_per_e);
  read("black_dn", noise.black_dn);
  read("prnu", noise.prnu);
  read("dsnu_e", noise.dsnu_e);
  noise.bits = table.Integer("bits", noise.bits);
  return noise;
}

void ReadNoise(const TomlTable& table, SensorOptions& sensor) {
  At(table.PlaceOf("model"), [&] { sensor = SensorOptions::Preset(table.String("model")); });
  if (std::holds_alternative<HandaNoise>(sensor.noise)) sensor.noise = ReadHanda(table);
  if (std::holds_alternative<EmvaNoise>(sensor.noise)) sensor.noise = ReadEmva(table);
  table.RejectUnknownKeys();
  At(table.place(), [&] { sensor.Validate(); });
}

// A table of one's own lies beside the file.
ResponseCurve ReadResponse(const TomlTable& table, const std::filesystem::path& folder) {
  const std::string name = table.String("response");
  const bool own = std::filesystem::is_regular_file(folder / name);
  std::optional<ResponseCurve> curve;
  At(table.PlaceOf("response"),
     [&] { curve = ResponseCurve::Named(own ? (folder / name).string() : name); });
  return *curve;
}

Vignetting ReadVignetting(const TomlTable& table) {
  const Vec3d polynomial = table.Vector("polynomial", {});
  const Vignetting vignetting{table.Bool("cos4", false), polynomial.x, polynomial.y, polynomial.z};
  table.RejectUnknownKeys();
  return vignetting;
}

LensDistortion ReadLens(const TomlTable& table) {
  const LensDistortion lens{table.Number("k1", 0), table.Number("k2", 0), table.Number("p1", 0),
                            table.Number("p2", 0), table.Number("k3", 0)};
  table.RejectUnknownKeys();
  return lens;
}

DepthSensorOptions ReadDepth(const TomlTable& table) {
  DepthSensorOptions depth;
  depth.model = table.String("model", depth.model);
  DepthDropouts& dropouts = depth.dropouts;
  dropouts.grazing_deg = table.Number("grazing_deg", dropouts.grazing_deg);
  dropouts.edge_share = table.Number("edge_share", dropouts.edge_share);
  dropouts.edge_px = table.Integer("edge_px", dropouts.edge_px);
  dropouts.shadow_baseline_m = table.Number("shadow_baseline_m", dropouts.shadow_baseline_m);
  table.RejectUnknownKeys();
  At(table.place(), [&] { depth.Validate(); });
  return depth;
}

}  // namespace

SensorSetup LoadSensorFile(const std::filesystem::path& file) {
  const TomlTable table = TomlTable::ReadFile(file);
  SensorSetup setup;
  if (const auto noise = table.Table("noise")) ReadNoise(*noise, setup.sensor);
  if (table.Has("response")) setup.sensor.response = ReadResponse(table, file.parent_path());
  if (const auto vignetting = table.Table("vignetting")) {
    setup.sensor.vignetting = ReadVignetting(*vignetting);
  }
  if (const auto lens = table.Table("lens")) setup.lens = ReadLens(*lens);
  if (const auto depth = table.Table("depth")) setup.depth = ReadDepth(*depth);
  table.RejectUnknownKeys();
  return setup;
}

}  // namespace silt::sim
