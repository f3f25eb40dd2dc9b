// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/sensor_options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt/experiments/option_checks.h"
#include "silt/sim/content_hash.h"
#include "silt/sim/sensor_file.h"

namespace silt::experiments {
namespace {

std::vector<double> CommaSeparated(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    double value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc()) return {};
    numbers.push_back(value);
    if (stop == end) return numbers;
    if (*stop != ',') return {};
    at = stop + 1;
  }
}

// "none", "cos4", "a1,a2,a3" or "cos4,a1,a2,a3".
sim::Vignetting VignettingNamed(const std::string& name) {
  if (name == "none") return {};
  if (name == "cos4") return {.cos4 = true};
  const std::string prefix = "cos4,";
  const bool cos4 = name.compare(0, prefix.size(), prefix) == 0;
  const std::vector<double> a = CommaSeparated(cos4 ? name.substr(prefix.size()) : name);
  if (a.size() != 3) {
    throw Error("--vignetting: " + Quoted(name) +
                " is none of: none, cos4, a1,a2,a3, cos4,a1,a2,a3");
  }
  return {cos4, a[0], a[1], a[2]};
}

Json NoiseJson(const sim::NoiseModel& noise) {
  if (const auto* handa = std::get_if<sim::HandaNoise>(&noise)) {
    const Vec3d &shot = handa->sigma_shot, &read = handa->sigma_read;
    return {{"sigma_shot", {shot.x, shot.y, shot.z}}, {"sigma_read", {read.x, read.y, read.z}}};
  }
  if (const auto* emva = std::get_if<sim::EmvaNoise>(&noise)) {
    return {{"quantum_efficiency", emva->quantum_efficiency},
            {"full_well_e", emva->full_well_e},
            {"read_noise_e", emva->read_noise_e},
            {"dark_current_e_per_s", emva->dark_current_e_per_s},
            {"exposure_s", emva->exposure_s},
            {"photons_at_white", emva->PhotonsAtWhite()},
            {"gain_dn_per_e", emva->Gain()},
            {"bits", emva->bits},
            {"black_dn", emva->black_dn},
            {"prnu", emva->prnu},
            {"dsnu_e", emva->dsnu_e}};
  }
  return Json::object();
}

// Of the 255 places where the output takes its steps: a table changes and keeps its name.
std::string HashOf(const sim::ResponseCurve& response) {
  sim::ContentHash hash;
  for (int code = 1; code < 256; ++code) hash.Add(response.Decode((code - 0.5) / 255));
  return hash.Digest();
}

}  // namespace

void SensorCommandOptions::Apply(sim::RenderOptions& options) const {
  sim::SensorSetup setup;
  if (!file.empty()) setup = sim::LoadSensorFile(file);
  if (!noise.empty()) {
    const sim::SensorOptions preset = sim::SensorOptions::Preset(noise);
    setup.sensor.noise = preset.noise;
    setup.sensor.response = preset.response;
  }
  auto* emva = std::get_if<sim::EmvaNoise>(&setup.sensor.noise);
  if (photons > 0 && emva == nullptr) {
    throw Error("--photons: only the noise model emva counts photons; add --noise emva");
  }
  if (photons > 0) emva->photons_at_white = photons;
  if (emva != nullptr && options.shutter.exposure_s > 0) {
    emva->exposure_s = options.shutter.exposure_s;
  }
  if (!response.empty()) setup.sensor.response = sim::ResponseCurve::Named(response);
  if (!vignetting.empty()) setup.sensor.vignetting = VignettingNamed(vignetting);
  if (!lens.empty()) setup.lens = {lens[0], lens[1], lens[2], lens[3], lens[4]};
  if (!depth_model.empty()) setup.depth.model = depth_model;
  if (depth_dropouts) setup.depth.dropouts = sim::DepthDropouts::Kinect();
  options.sensor = setup.sensor;
  options.lens = setup.lens;
  options.depth_sensor = setup.depth;
  // Refused here rather than after a scene has been loaded.
  const sim::LensMap map(options.camera, options.lens);
  const sim::Sensor sensor(options.sensor, options.camera, &map);
}

void AddSensorOptions(CLI::App& command, SensorCommandOptions& o) {
  const auto text = [&](const char* name, std::string& value, const char* help) {
    return command.add_option(name, value, help)->group("Lens and sensors");
  };
  text("--sensor", o.file,
       "Lens and sensors from a TOML file, such as those in experiments/sensors; the options below "
       "override it");
  text("--noise", o.noise, "Noise of the colours: none, handa (sRGB) or emva (linear)")
      ->check(CLI::IsMember({"none", "handa", "emva"}));
  text("--response", o.response,
       "Response curve: srgb, linear, gamma:G or a table's file; default: the noise model's, in "
       "brackets above");
  text("--vignetting", o.vignetting,
       "Light's fall-off: none, cos4, or a polynomial a1,a2,a3 in r^2 (corner: 1), or "
       "cos4,a1,a2,a3");
  text("--depth-sensor", o.depth_model,
       "Depth: perfect, png16 (its 1/5000 m steps), kinect, kinect-legacy, khoshelham or nguyen; "
       "default: perfect")
      ->check(CLI::IsMember(sim::DepthSensorModels()));
  command
      .add_flag("--depth-dropouts", o.depth_dropouts,
                "No depth at grazing angles, edges and in the projector's shadow")
      ->group("Lens and sensors");
  command
      .add_option("--lens", o.lens,
                  "Brown-Conrady distortion k1 k2 p1 p2 k3, as OpenCV orders them")
      ->expected(5)
      ->group("Lens and sensors");
  RequireNumber(command
                    .add_option("--photons", o.photons,
                                "Photons of a white pixel, for --noise emva: fewer are noisier; "
                                "default: as many as fill its well")
                    ->group("Lens and sensors"),
                1, 1e12);
}

Json SensorJson(const sim::RenderOptions& options) {
  const sim::SensorOptions& sensor = options.sensor;
  const sim::Vignetting& v = sensor.vignetting;
  const LensDistortion& l = options.lens;
  const sim::DepthDropouts& d = options.depth_sensor.dropouts;
  return {{"noise", sensor.NoiseName()},
          {"noise_parameters", NoiseJson(sensor.noise)},
          {"response", sensor.response.name()},
          {"response_hash", HashOf(sensor.response)},
          {"vignetting", {{"cos4", v.cos4}, {"polynomial", {v.a1, v.a2, v.a3}}}},
          {"lens", {l.k1, l.k2, l.p1, l.p2, l.k3}},
          {"depth_sensor",
           {{"model", options.depth_sensor.model},
            {"grazing_deg", d.grazing_deg},
            {"edge_share", d.edge_share},
            {"edge_px", d.edge_px},
            {"shadow_baseline_m", d.shadow_baseline_m}}}};
}

}  // namespace silt::experiments
