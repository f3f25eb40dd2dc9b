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

// "full", or seconds of at most a frame's time.
double ExposureSeconds(const std::string& blur, double fps) {
  if (blur == "full") return 1 / fps;
  char* end = nullptr;
  const double exposure_s = std::strtod(blur.c_str(), &end);
  const bool number = !blur.empty() && *end == '\0' && std::isfinite(exposure_s);
  if (!number || exposure_s < 0 || exposure_s > 1 / fps + 1e-12) {
    throw Error("--blur: '" + blur + "' is neither full nor seconds from 0 to 1/fps");
  }
  return exposure_s;
}

}  // namespace

RenderPlan SimulationOptions::Plan() const {
  RenderPlan plan;
  if (width % 4 != 0) throw Error("--width: must be a multiple of 4, for a height of 3/4 of it");
  plan.options.camera = IclNuimCameraOfWidth(width);
  plan.options.samples_per_pixel = samples_per_pixel;
  plan.options.shutter.exposure_s = ExposureSeconds(blur, fps);
  plan.options.shutter.time_samples = time_samples;
  if (noise == "handa") plan.options.sensor.noise = sim::HandaNoise{};
  plan.options.seed = seed;
  plan.stretch = {fps, start_s, duration_s};
  return plan;
}

sim::LightingOptions SimulationOptions::Lighting() const {
  sim::LightingOptions lighting;
  if (light == "path") lighting.mode = sim::LightMode::kPath;
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
                        "each pixel, --spp paths each, exact but noisy and slow")
            ->check(CLI::IsMember({"baked", "path"}))
            ->capture_default_str());
  integer("--width", o.width, 16, 8192, "Width of the image; its height is 3/4 of it");
  group(command.add_option("--blur", o.blur, "Exposure: full (1/fps), 0 (an instant), or seconds")
            ->capture_default_str());
  integer("--time-samples", o.time_samples, 1, 4096, "Instants in an exposure, at least");
  group(command.add_option("--noise", o.noise, "Noise of the colours: handa or none")
            ->check(CLI::IsMember({"handa", "none"}))
            ->capture_default_str());
  RequireInteger(
      group(command.add_option("--seed", o.seed, "Seed of all randomness")->capture_default_str()),
      0, 9223372036854775807LL);
  integer("--threads", o.threads, 0, 1024, "Threads; 0: one per processor");
}

}  // namespace silt::experiments
