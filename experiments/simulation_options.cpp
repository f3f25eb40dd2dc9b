// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/simulation_options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>

#include "silt/core/error.h"
#include "silt/experiments/option_checks.h"

namespace silt::experiments {
namespace {

// "full" or a share such as "50%" of a frame's time, or "8ms" or "0.008" seconds of it.
double ExposureSeconds(const std::string& blur, double fps) {
  if (blur == "full") return 1 / fps;
  char* end = nullptr;
  double exposure_s = std::strtod(blur.c_str(), &end);
  const std::string unit = blur.empty() ? "?" : end;
  if (unit == "ms") exposure_s *= 1e-3;
  if (unit == "%") exposure_s *= 0.01 / fps;
  const bool known = (unit.empty() || unit == "s" || unit == "ms" || unit == "%") &&
                     end != blur.c_str() && std::isfinite(exposure_s);
  if (!known || exposure_s < 0 || exposure_s > 1 / fps + 1e-12) {
    throw Error("--blur: '" + blur +
                "' is neither full nor a share such as 50% nor a time from 0 to 1/fps such as 8ms");
  }
  return exposure_s;
}

// A camera reads a picture before it takes the next one.
double RowSeconds(double row_time_us, int rows, double fps) {
  if (1e-6 * row_time_us * rows > 1 / fps + 1e-12) {
    throw Error("--row-time: " + std::to_string(rows) + " rows take longer than 1/fps; at most " +
                std::to_string(1e6 / fps / rows) + " is possible");
  }
  return 1e-6 * row_time_us;
}

void SetExposure(const std::string& exposure, RenderPlan& plan) {
  using Kind = sim::Exposure::Kind;
  if (exposure == "scene") return;
  plan.meter_exposure = exposure == "auto";
  if (exposure == "auto") return;
  if (exposure == "auto-frame") {
    plan.options.exposure.kind = Kind::kPerFrame;
    return;
  }
  char* end = nullptr;
  const double value = std::strtod(exposure.c_str(), &end);
  if (exposure.empty() || *end != '\0' || !std::isfinite(value) || value <= 0) {
    throw Error("--exposure: '" + exposure +
                "' is neither scene, auto, auto-frame nor a number above 0");
  }
  plan.options.exposure = {Kind::kGiven, value};
}

}  // namespace

RenderPlan SimulationOptions::Plan() const {
  RenderPlan plan;
  if (width % 4 != 0) throw Error("--width: must be a multiple of 4, for a height of 3/4 of it");
  plan.options.camera = IclNuimCameraOfWidth(width);
  plan.options.samples_per_pixel = samples_per_pixel;
  plan.options.shutter.exposure_s = ExposureSeconds(blur, fps);
  plan.options.shutter.time_samples = time_samples;
  plan.options.shutter.row_time_s = RowSeconds(row_time_us, plan.options.camera.height, fps);
  if (filter == "gaussian") plan.options.filter = sim::PixelFilter::kGaussian;
  if (pattern == "scrambled") plan.options.pattern = sim::PixelPattern::kScrambled;
  sensor.Apply(plan.options);
  SetExposure(exposure, plan);
  plan.options.seed = seed;
  plan.stretch = {fps, start_s, duration_s};
  return plan;
}

sim::LightingOptions SimulationOptions::Lighting() const {
  sim::LightingOptions lighting;
  if (light == "path") lighting.mode = sim::LightMode::kPath;
  lighting.specular = specular;
  return lighting;
}

void AddSimulationOptions(CLI::App& command, SimulationOptions& o, bool required) {
  const auto group = [](CLI::Option* option) { return option->group("Simulation"); };
  CLI::Option* scene = group(command.add_option(
      "--scene", o.scene, "Scene by name (silt info lists them) or path to its scene.toml"));
  if (required) scene->required();
  group(command.add_option("--trajectory", o.trajectory,
                           "Camera path beside the scene, by name, or path to a TOML file; "
                           "default: desk, or the only one"));
  const auto number = [&](const char* name, double& value, double low, double high,
                          const char* help) {
    RequireNumber(group(command.add_option(name, value, help)->capture_default_str()), low, high);
  };
  const auto integer = [&](const char* name, int& value, int low, int high, const char* help) {
    RequireInteger(group(command.add_option(name, value, help)->capture_default_str()), low, high);
  };
  number("--fps", o.fps, 0.1, 10000, "Frames per second");
  number("--start", o.start_s, 0, 1e6, "Start of the stretch of the path, in seconds");
  number("--duration", o.duration_s, 0, 1e6, "Its length in seconds; 0: to the end");
  integer("--spp", o.samples_per_pixel, 1, 65536, "Samples per pixel");
  group(command
            .add_option("--light", o.light,
                        "baked: computed once on all surfaces, without noise; path: traced for "
                        "each pixel, --spp paths each, exact but noisy and slow (and of textures "
                        "without mip levels)")
            ->check(CLI::IsMember({"baked", "path"}))
            ->capture_default_str());
  group(command.add_flag("--specular", o.specular,
                         "Add reflections, which depend on the viewpoint, to baked light (path "
                         "always shows them)"));
  group(command
            .add_option("--exposure", o.exposure,
                        "scene: as the scene says; a number: radiance times it = 1 is white; auto: "
                        "one for the sequence, metered along it; auto-frame: metered in each frame")
            ->capture_default_str());
  integer("--width", o.width, 16, 8192, "Width of the image; its height is 3/4 of it");
  group(command
            .add_option("--blur,--exposure-time", o.blur,
                        "Exposure: full (1/fps), 50% (of it), 8ms, 0.008 (seconds), 0 (an instant)")
            ->capture_default_str());
  integer("--time-samples", o.time_samples, 1, 4096, "Instants in an exposure, at least");
  number("--row-time", o.row_time_us, 0, 1e6,
         "Rolling shutter: microseconds from one row to the next; the pose is the middle's");
  group(command
            .add_option("--filter", o.filter,
                        "Filter of the pixels: box (sharp, aliases) or gaussian (of 0.6 px; with "
                        "--spp 64 the frames agree best with each other)")
            ->check(CLI::IsMember({"box", "gaussian"}))
            ->capture_default_str());
  group(command
            .add_option("--pattern", o.pattern,
                        "Samples of the pixels: shared (no noise) or scrambled (no ghosts)")
            ->check(CLI::IsMember({"shared", "scrambled"}))
            ->capture_default_str());
  RequireInteger(
      group(command.add_option("--seed", o.seed, "Seed of all randomness")->capture_default_str()),
      0, 9223372036854775807LL);
  integer("--threads", o.threads, 0, 1024, "Threads; 0: one per processor");
  AddSensorOptions(command, o.sensor);
}

}  // namespace silt::experiments
