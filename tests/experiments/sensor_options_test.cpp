// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/sensor_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"
#include "silt_program.h"

namespace silt::experiments {
namespace {

using testing::HasSubstr;

sim::RenderOptions Applied(const SensorCommandOptions& options) {
  sim::RenderOptions rendering;
  options.Apply(rendering);
  return rendering;
}

TEST(SensorOptions, NothingAskedForIsAPerfectCamera) {
  const Json json = SensorJson(Applied({}));
  EXPECT_EQ(json["noise"], "none");
  EXPECT_EQ(json["noise_parameters"], Json::object());
  EXPECT_EQ(json["response"], "srgb");
  EXPECT_EQ(json["lens"], Json({0, 0, 0, 0, 0}));
  EXPECT_EQ(json["depth_sensor"]["model"], "perfect");
}

TEST(SensorOptions, TheManifestTellsAllOfASensor) {
  const Json json = SensorJson(Applied({.noise = "emva",
                                        .vignetting = "cos4,-0.1,0,0.05",
                                        .depth_model = "kinect",
                                        .lens = {-0.1, 0.2, 0.001, 0.002, -0.03},
                                        .photons = 2000,
                                        .depth_dropouts = true}));
  EXPECT_EQ(json["noise"], "emva");
  EXPECT_EQ(json["noise_parameters"]["photons_at_white"], 2000);
  EXPECT_NEAR(json["noise_parameters"]["gain_dn_per_e"].get<double>(), 4031 / 1540.0, 1e-9);
  EXPECT_EQ(json["response"], "linear");
  EXPECT_EQ(json["vignetting"]["cos4"], true);
  EXPECT_EQ(json["vignetting"]["polynomial"], Json({-0.1, 0.0, 0.05}));
  EXPECT_EQ(json["lens"], Json({-0.1, 0.2, 0.001, 0.002, -0.03}));
  EXPECT_EQ(json["depth_sensor"]["model"], "kinect");
  EXPECT_EQ(json["depth_sensor"]["shadow_baseline_m"], 0.075);
  const Json handa = SensorJson(Applied({.noise = "handa"}));
  EXPECT_EQ(handa["noise_parameters"]["sigma_read"], Json({0.0045, 0.0038, 0.0050}));
}

TEST(SensorOptions, OptionsOverrideTheFile) {
  const TestFolder folder;
  const std::string file = (folder / "camera.toml").string();
  std::ofstream(file) << "response = \"gamma:2\"\n[noise]\nmodel = \"emva\"\nbits = 10\n"
                         "[lens]\nk1 = -0.1\n[depth]\nmodel = \"nguyen\"\nedge_share = 0.1\n";
  EXPECT_EQ(Applied({.file = file}).sensor.response.name(), "gamma:2");
  EXPECT_EQ(Applied({.file = file, .noise = "handa"}).sensor.response.name(), "srgb");
  EXPECT_EQ(Applied({.file = file, .response = "linear"}).sensor.NoiseName(), "emva");
  EXPECT_EQ(Applied({.file = file}).lens.k1, -0.1);
  EXPECT_TRUE(Applied({.file = file, .lens = {0, 0, 0, 0, 0}}).lens.IsNone());
  EXPECT_EQ(Applied({.file = file, .depth_model = "kinect"}).depth_sensor.model, "kinect");
  EXPECT_EQ(Applied({.file = file, .depth_model = "kinect"}).depth_sensor.dropouts.edge_share, 0.1);
  const Json json = SensorJson(Applied({.file = file, .photons = 800}));
  EXPECT_EQ(json["noise_parameters"]["photons_at_white"], 800);
  EXPECT_EQ(json["noise_parameters"]["bits"], 10);
}

TEST(SensorOptions, TheExamplesAreRead) {
  const std::string folder = SILT_SOURCE_DIR "/experiments/sensors/";
  EXPECT_EQ(Applied({.file = folder + "kinect.toml"}).depth_sensor.model, "kinect");
  EXPECT_EQ(Applied({.file = folder + "low_light.toml"}).sensor.NoiseName(), "emva");
}

// Dark electrons gather for as long as the shutter is open.
TEST(SensorOptions, TheShutterIsTheExposureOfTheDarkCurrent) {
  sim::RenderOptions rendering;
  rendering.shutter.exposure_s = 0.04;
  SensorCommandOptions{.noise = "emva"}.Apply(rendering);
  EXPECT_EQ(std::get<sim::EmvaNoise>(rendering.sensor.noise).exposure_s, 0.04);
}

}  // namespace
}  // namespace silt::experiments
