// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "silt/core/color.h"
#include "silt/core/io/image_file.h"
#include "silt/core/lens.h"
#include "silt/experiments/case_runner.h"
#include "silt_program.h"

// Light, exposure, lens and sensors as they are asked for on the command line: the manifest says
// so, and the pictures show it.
namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 64, kHeight = 48;

// A picture that a render wrote, and how it says that it was made.
struct Rendered {
  fs::path folder;
  Json world, plan;

  Image<Rgb8> Rgb(int number = 0) const { return ReadRgb(File("rgb", number)); }
  Image<float> Depth(int number = 0) const { return ReadDepth(File("depth", number)); }
  Image<Rgb8> Sharp(int number = 0) const { return ReadRgb(File("truth/sharp", number)); }
  fs::path File(const char* kind, int number) const {
    return folder / kind / ("00000" + std::to_string(number) + ".png");
  }
};

class RenderOptionsTest : public testing::Test {
 protected:
  Rendered Render(const std::string& more, const std::string& scene = "studio") const {
    const fs::path out = folder_ / std::to_string(runs_++);
    const ProgramResult result = RunSilt("render --scene " + scene + " --width 64 --fps 20 " +
                                         more + " --out '" + out.string() + "'");
    EXPECT_EQ(result.exit_code, 0) << result.error;
    const Json config = Json::parse(ReadText(out / "manifest.json")).at("config");
    return {out, config.at("world"), config.at("render")};
  }
  const Rendered& Plain() {
    if (!plain_) plain_ = Render("--spp 16 --duration 0.1");
    return *plain_;
  }
  TestFolder folder_;

 private:
  std::optional<Rendered> plain_;
  mutable int runs_ = 0;
};

double Linear(std::uint8_t code) { return double(LinearFromSrgb(float(code) / 255)); }

// Mean of f over the pixels.
double Mean(const Image<Rgb8>& picture, const std::function<double(const Rgb8&)>& f) {
  double sum = 0;
  for (const Rgb8& pixel : picture) sum += f(pixel);
  return sum / double(picture.size());
}
double MeanGreen(const Image<Rgb8>& picture) {
  return Mean(picture, [](const Rgb8& pixel) { return Linear(pixel.g); });
}

// Each pixel of `picture` is `factor(x, y)` times as bright as that of `plain`, to the steps of
// both; clipped and dark ones tell nothing.
void ExpectBrighterBy(const std::function<double(int, int)>& factor, const Image<Rgb8>& picture,
                      const Image<Rgb8>& plain) {
  int compared = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::uint8_t before = plain(x, y).g, after = picture(x, y).g;
      if (before < 30 || after < 30 || after > 253 || before > 253) continue;
      const double low = Linear(std::uint8_t(after - 1)), high = Linear(std::uint8_t(after + 1));
      EXPECT_GE(factor(x, y) * Linear(std::uint8_t(before + 1)), low) << x << ' ' << y;
      EXPECT_LE(factor(x, y) * Linear(std::uint8_t(before - 1)), high) << x << ' ' << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, kWidth * kHeight / 2);
}

TEST_F(RenderOptionsTest, PathsShowTheSameSceneWithNoise) {
  const Rendered traced = Render("--light path --spp 16 --duration 0.05");
  EXPECT_EQ(Plain().world["light"], "baked");
  EXPECT_EQ(traced.world["light"], "path");
  EXPECT_NEAR(MeanGreen(traced.Rgb()) / MeanGreen(Plain().Rgb()), 1, 0.03);
  const auto noise = [](const Image<Rgb8>& picture) {
    double sum = 0;
    for (int y = 1; y + 1 < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        sum += std::abs(2 * picture(x, y).g - picture(x, y - 1).g - picture(x, y + 1).g);
      }
    }
    return sum;
  };
  EXPECT_GT(noise(traced.Rgb()), 1.1 * noise(Plain().Rgb()));
  EXPECT_EQ(traced.Depth(), Plain().Depth());
}

// A mirror on the floor before a bright wall.
TEST_F(RenderOptionsTest, ReflectionIsSeenWhereSurfacesReflectAndOnlyIfAskedFor) {
  std::ofstream(folder_ / "scene.toml")
      << "name = \"Mirror\"\nambient = [0.2, 0.2, 0.2]\n"
         "[[material]]\nname = \"mirror\"\ncolor = \"#808080\"\nmirror = true\n"
         "[[material]]\nname = \"wall\"\ncolor = \"#ffffff\"\nemission = [0, 0.5, 0]\n"
         "[[quad]]\nmaterial = \"mirror\"\ncorner = [-2, -2, 0]\nu = [4, 0, 0]\nv = [0, 4, 0]\n"
         "[[quad]]\nmaterial = \"wall\"\ncorner = [-2, 2, 0.1]\nu = [4, 0, 0]\nv = [0, 0, 3]\n";
  std::ofstream(folder_ / "path.toml") << "[line]\nfrom = [0, -1.5, 1]\nto = [0.1, -1.5, "
                                          "1]\nduration_s = 1\nlook_at = [0, 2, 0.4]\n";
  const std::string path =
      "--spp 4 --duration 0.05 --trajectory '" + (folder_ / "path.toml").string() + "' ";
  const std::string scene = "'" + (folder_ / "scene.toml").string() + "'";
  const Rendered matt = Render(path, scene), shiny = Render(path + "--specular", scene);
  EXPECT_EQ(matt.world["specular"], false);
  EXPECT_EQ(shiny.world["specular"], true);
  const Image<Rgb8> before = matt.Rgb(), after = shiny.Rgb();
  const Image<float> depth_m = matt.Depth();
  int wall = 0, floor = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = kWidth / 4; x < 3 * kWidth / 4; ++x) {
      if (depth_m(x, y) == 0) continue;
      if (y < kHeight / 4) wall += before(x, y) == after(x, y);
      if (y > 3 * kHeight / 4) floor += after(x, y).g > after(x, y).r + 20;  // greener than it was
    }
  }
  EXPECT_GT(wall, 200);
  EXPECT_GT(floor, 200);
}

TEST_F(RenderOptionsTest, AGivenExposureIsAFactorOfLight) {
  const Rendered brighter = Render("--spp 16 --exposure 1.5 --duration 0.05");
  EXPECT_EQ(Plain().plan["exposure"], "scene");
  EXPECT_EQ(brighter.plan["exposure"], 1.5);
  ExpectBrighterBy([](int, int) { return 1.5; }, brighter.Rgb(), Plain().Rgb());
}

TEST_F(RenderOptionsTest, AMeteredExposureIsOneForTheSequence) {
  const Rendered metered = Render("--spp 16 --exposure auto --duration 0.1");
  ASSERT_TRUE(metered.plan["exposure"].is_number());
  const double exposure = metered.plan["exposure"];
  EXPECT_GT(std::abs(exposure - 1), 0.02);  // the studio's is 1
  for (const int number : {0, 1}) {
    ExpectBrighterBy([&](int, int) { return exposure; }, metered.Rgb(number), Plain().Rgb(number));
  }
}

// Another exposure for each frame, which the sharp truth beside a blurred frame shares.
TEST_F(RenderOptionsTest, AnExposureMeteredInEachFrameIsThatOfItsSharpTruth) {
  const Rendered metered =
      Render("--spp 16 --exposure auto-frame --blur full --truth sharp --duration 0.5");
  const Rendered fixed = Render("--spp 16 --blur full --truth sharp --duration 0.5");
  EXPECT_EQ(metered.plan["exposure"], "auto-frame");
  std::set<double> exposures;
  for (const int number : {0, 5, 9}) {
    const double exposure =
        MeanGreen(metered.Rgb(number)) / MeanGreen(fixed.Rgb(number));  // about: some are clipped
    EXPECT_NEAR(MeanGreen(metered.Sharp(number)) / MeanGreen(fixed.Sharp(number)) / exposure, 1,
                0.005);
    exposures.insert(exposure);
  }
  EXPECT_GT(*exposures.rbegin() / *exposures.begin(), 1.001);
}

TEST_F(RenderOptionsTest, ALensBendsPicturesAndDepth) {
  const Rendered bent = Render("--spp 16 --lens -0.2 0.05 0.001 -0.002 0.01 --duration 0.05");
  EXPECT_EQ(bent.plan["lens"], Json({-0.2, 0.05, 0.001, -0.002, 0.01}));
  EXPECT_NE(ReadText(bent.folder / "camera.txt").find("-0.2 0.05 0.001 -0.002 0.01"),
            std::string::npos);
  // Where the lens shows what the pinhole shows at a corner's neighbour.
  const PinholeCamera camera = IclNuimCameraOfWidth(kWidth);
  const LensDistortion lens{-0.2, 0.05, 0.001, -0.002, 0.01};
  const Image<float> straight_m = Plain().Depth(), bent_m = bent.Depth();
  int same = 0, compared = 0;
  for (int y = 4; y < kHeight - 4; ++y) {
    for (int x = 4; x < kWidth - 4; ++x) {
      const Vec3d ray = camera.Unproject(double(x), double(y), 1.0);
      const Vec2d at = ProjectThroughLens(camera, lens, ray);
      if (!(at.x >= 0 && at.y >= 0 && at.x < kWidth - 1 && at.y < kHeight - 1)) continue;
      const float there = bent_m(int(std::lround(at.x)), int(std::lround(at.y)));
      same += std::abs(there - straight_m(x, y)) < 0.02f * straight_m(x, y);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1500);
  EXPECT_GT(same, 0.9 * compared);
  EXPECT_FALSE(bent_m == straight_m);
  EXPECT_FALSE(bent.Rgb() == Plain().Rgb());
}

// Depth in eighths of a pixel of disparity, 351.3/z being whole; and none at edges and where a
// surface is grazed.
TEST_F(RenderOptionsTest, AKinectsDepthHasItsStepsAndDropouts) {
  const Rendered whole = Render("--spp 1 --depth-sensor kinect --duration 0.05"),
                 holed = Render("--spp 1 --depth-sensor kinect --depth-dropouts --duration 0.05");
  EXPECT_EQ(Plain().plan["depth_sensor"]["model"], "perfect");
  EXPECT_EQ(whole.plan["depth_sensor"]["model"], "kinect");
  EXPECT_EQ(whole.plan["depth_sensor"]["edge_share"], 0);
  EXPECT_GT(holed.plan["depth_sensor"]["edge_share"], 0);
  const auto off_step = [](float z) {
    const double steps = 351.3 / double(z);
    return std::abs(351.3 / std::round(steps) - double(z)) > 1.01e-4;  // of a PNG's depth
  };
  const Image<float> depth_m = whole.Depth(), truth_m = Plain().Depth();
  EXPECT_EQ(std::count_if(depth_m.begin(), depth_m.end(), off_step), 0);
  EXPECT_GT(std::count_if(truth_m.begin(), truth_m.end(), off_step), 1000);
  const Image<float> holes_m = holed.Depth();
  EXPECT_EQ(std::count(depth_m.begin(), depth_m.end(), 0.0f), 0);
  EXPECT_GT(std::count(holes_m.begin(), holes_m.end(), 0.0f), 20);
  EXPECT_LT(std::count(holes_m.begin(), holes_m.end(), 0.0f), kWidth * kHeight / 2);
}

TEST_F(RenderOptionsTest, VignettingDarkensByTheFourthPowerOfTheCosine) {
  const Rendered dark = Render("--spp 16 --vignetting cos4 --duration 0.05");
  EXPECT_EQ(Plain().plan["vignetting"]["cos4"], false);
  EXPECT_EQ(dark.plan["vignetting"]["cos4"], true);
  const PinholeCamera camera = IclNuimCameraOfWidth(kWidth);
  const auto share = [&](int x, int y) {
    return std::pow(Norm(camera.Unproject(double(x), double(y), 1.0)), -4);
  };
  EXPECT_LT(share(0, 0), 0.5);
  ExpectBrighterBy(share, dark.Rgb(), Plain().Rgb());
}

// Time, both sensors' readings, and their biases, which wander from 0.
std::vector<double> LastReading(const fs::path& folder) {
  std::ifstream csv(folder / "truth/imu.csv");
  std::string last;
  for (std::string line; std::getline(csv, line);) last = line;
  std::istringstream fields(last);
  std::vector<double> values;
  for (std::string field; std::getline(fields, field, ',');) values.push_back(std::stod(field));
  return values;
}

TEST_F(RenderOptionsTest, TheInertialSensorIsAsNoisyAsAskedFor) {
  const std::string more = "--duration 0.1 --truth imu --imu-noise ";
  const std::vector<double> clean = LastReading(Render(more + "none").folder);
  const std::vector<double> noisy = LastReading(Render(more + "euroc").folder);
  ASSERT_EQ(clean.size(), 13u);
  ASSERT_EQ(noisy.size(), 13u);
  for (int i = 1; i < 7; ++i) EXPECT_NE(noisy[i], clean[i]) << i;
  for (int i = 7; i < 13; ++i) EXPECT_EQ(clean[i], 0) << i;
  double bias = 0;
  for (int i = 7; i < 13; ++i) bias += std::abs(noisy[i]);
  EXPECT_GT(bias, 0);
}

}  // namespace
}  // namespace silt::experiments
