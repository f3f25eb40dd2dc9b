// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/sensor_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

class SensorFile : public testing::Test {
 protected:
  SensorSetup Load(const std::string& text) const {
    return LoadSensorFile(folder_.Write("sensor.toml", text));
  }
  TempFolder folder_;
};

TEST_F(SensorFile, AnEmptyOneIsAPerfectCamera) {
  const SensorSetup setup = Load("");
  EXPECT_EQ(setup.sensor.NoiseName(), "none");
  EXPECT_EQ(setup.sensor.response.name(), "srgb");
  EXPECT_TRUE(setup.sensor.vignetting.IsNone());
  EXPECT_TRUE(setup.lens.IsNone());
  EXPECT_EQ(setup.depth.model, "perfect");
  EXPECT_TRUE(setup.depth.dropouts.AreNone());
}

TEST_F(SensorFile, DescribesAllOfACamera) {
  const SensorSetup setup = Load(R"(
response = "gamma:1.8"
[noise]
model = "emva"
quantum_efficiency = 0.5
full_well_e = 10000
read_noise_e = 3
dark_current_e_per_s = 100
exposure_s = 0.02
photons_at_white = 4000
gain_dn_per_e = 0.4
bits = 10
black_dn = 16
prnu = 0.01
dsnu_e = 2
[vignetting]
cos4 = true
polynomial = [-0.1, -0.02, -0.003]
[lens]
k1 = -0.2
k2 = 0.05
p1 = 0.001
p2 = 0.002
k3 = -0.003
[depth]
model = "nguyen"
grazing_deg = 70
edge_share = 0.1
edge_px = 2
shadow_baseline_m = 0.05
)");
  const auto& emva = std::get<EmvaNoise>(setup.sensor.noise);
  EXPECT_EQ(emva.quantum_efficiency, 0.5);
  EXPECT_EQ(emva.full_well_e, 10000);
  EXPECT_EQ(emva.read_noise_e, 3);
  EXPECT_EQ(emva.dark_current_e_per_s, 100);
  EXPECT_EQ(emva.exposure_s, 0.02);
  EXPECT_EQ(emva.photons_at_white, 4000);
  EXPECT_EQ(emva.gain_dn_per_e, 0.4);
  EXPECT_EQ(emva.bits, 10);
  EXPECT_EQ(emva.black_dn, 16);
  EXPECT_EQ(emva.prnu, 0.01);
  EXPECT_EQ(emva.dsnu_e, 2);
  EXPECT_EQ(setup.sensor.response.name(), "gamma:1.8");
  EXPECT_TRUE(setup.sensor.vignetting.cos4);
  EXPECT_EQ(setup.sensor.vignetting.a3, -0.003);
  EXPECT_EQ(setup.lens, (LensDistortion{-0.2, 0.05, 0.001, 0.002, -0.003}));
  EXPECT_EQ(setup.depth.model, "nguyen");
  EXPECT_EQ(setup.depth.dropouts.grazing_deg, 70);
  EXPECT_EQ(setup.depth.dropouts.edge_share, 0.1);
  EXPECT_EQ(setup.depth.dropouts.edge_px, 2);
  EXPECT_EQ(setup.depth.dropouts.shadow_baseline_m, 0.05);
}

TEST_F(SensorFile, ANoiseModelBringsItsResponseCurve) {
  EXPECT_EQ(Load("[noise]\nmodel = \"emva\"").sensor.response.name(), "linear");
  const SensorSetup handa = Load("[noise]\nmodel = \"handa\"\nsigma_read = [0, 0.1, 0.2]");
  EXPECT_EQ(handa.sensor.response.name(), "srgb");
  EXPECT_EQ(std::get<HandaNoise>(handa.sensor.noise).sigma_read.z, 0.2);
  EXPECT_EQ(std::get<HandaNoise>(handa.sensor.noise).sigma_shot.x, 0.0104);
}

TEST_F(SensorFile, AResponseTableLiesBesideIt) {
  folder_.Write("curve.txt", "0 0\n0.5 0.8\n1 1\n");
  EXPECT_DOUBLE_EQ(Load("response = \"curve.txt\"").sensor.response.Encode(0.25), 0.4);
}

TEST_F(SensorFile, SaysWhereItIsWrong) {
  const auto expect = [&](const std::string& text, int line, const std::string& said) {
    const std::string error = ErrorOf([&] { Load(text); });
    EXPECT_THAT(error, HasSubstr("sensor.toml:" + std::to_string(line) + ": ")) << text;
    EXPECT_THAT(error, HasSubstr(said)) << text;
    EXPECT_EQ(error.find('\n'), std::string::npos);
  };
  expect("respons = \"srgb\"", 1, "unknown key 'respons'");
  expect("response = \"rec709\"", 1, "'rec709' is no file");
  expect("\nresponse = 2.2", 2, "must be a string");
  expect("[noise]\n", 1, "model");
  expect("[noise]\nmodel = \"white\"", 2, "none, handa, emva");
  expect("[noise]\nmodel = \"handa\"\nbits = 8", 3, "unknown key 'bits'");
  expect("[noise]\nmodel = \"emva\"\nbits = 8.5", 3, "whole number");
  expect("[noise]\nmodel = \"emva\"\nquantum_efficiency = 2", 1, "quantum efficiency");
  expect("[noise]\nmodel = \"handa\"\nsigma_shot = [1, 2]", 3, "3 finite numbers");
  expect("[vignetting]\ncos5 = true", 2, "unknown key 'cos5'");
  expect("[lens]\nk1 = \"a\"", 2, "must be a number");
  expect("[lens]\nk4 = 1", 2, "unknown key 'k4'");
  expect("[depth]\nmodel = \"lidar\"", 1, "'lidar' is none of: perfect");
  expect("[depth]\nedge_px = 0", 1, "1 to 16");
  EXPECT_THAT(ErrorOf([] { LoadSensorFile("/none/x.toml"); }), HasSubstr("/none/x.toml"));
}

}  // namespace
}  // namespace silt::sim
