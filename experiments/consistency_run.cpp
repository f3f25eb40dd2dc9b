// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/consistency_run.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/interrupt.h"

namespace silt::experiments {
namespace {

using sim::PixelFilter;
using sim::PixelPattern;

constexpr double kConsistent_m = 1e-5;

sim::RenderOptions Rendering(const ConsistencyPlan& plan, const ConsistencyCase& made) {
  sim::RenderOptions options;
  options.camera = IclNuimCameraOfWidth(plan.width);
  options.samples_per_pixel = made.samples_per_pixel;
  options.pattern = made.pattern;
  options.filter = made.filter;
  return options;
}

Image<float> LumaOf8Bits(const Image<Rgb8>& rgb) {
  Image<float> luma = GrayFromRgb(rgb);
  for (float& value : luma) value *= 255;
  return luma;
}

Image<float> LumaOfRadiance(const Image<Vec3f>& radiance, float exposure) {
  Image<float> luma(radiance.width(), radiance.height());
  ParallelFor(luma.height(), [&](int y) {
    for (int x = 0; x < luma.width(); ++x) {
      const auto code = [exposure](float linear) {
        return 255 * SrgbFromLinear(std::clamp(exposure * linear, 0.0f, 1.0f));
      };
      const Vec3f& c = radiance(x, y);
      luma(x, y) = Luma(code(c.x), code(c.y), code(c.z));
    }
  });
  return luma;
}

TrueView ViewAt(const sim::Renderer& renderer, const World& world, double time_s,
                const ConsistencyCase& made) {
  const auto frame = int(std::uint32_t(1e4 * time_s));  // scrambled patterns differ between views
  const Image<Vec3f> linear = renderer.RenderLinear(world.Pose(), time_s, frame);
  const SE3d pose = world.path.WorldFromCamera(time_s);
  const auto exposure = float(world.scene->scene().exposure);
  return {made.eight_bits ? LumaOf8Bits(renderer.Develop(linear, {}))
                          : LumaOfRadiance(linear, exposure),
          renderer.RenderDepth(pose), pose};
}

struct Pair {
  double onto_s, from_s;
};

std::vector<Pair> PairsOf(const World& world, const ConsistencyPlan& plan) {
  const double apart_s = plan.apart / plan.fps, room_s = world.path.duration_s() - apart_s;
  if (!(room_s > 0)) {
    throw Error(world.path_file.string() +
                ": is shorter than a pair; lower --apart or raise --fps");
  }
  std::vector<Pair> pairs;
  for (int i = 0; i < plan.pairs; ++i) {
    const double begin_s = (i + 0.5) / plan.pairs * room_s;
    pairs.push_back({begin_s, begin_s + apart_s});
  }
  return pairs;
}

// The value that a share of all do not exceed; 0 of none.
template <typename T>
double Quantile(std::vector<T>& values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return double(*at);
}

template <typename T>
void Append(std::vector<T>& to, const std::vector<T>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

const std::vector<ConsistencyCase>& ConsistencyCases() {
  static const std::vector<ConsistencyCase> cases{
      {"64 spp, 8 bits, gaussian", 64, PixelPattern::kShared, PixelFilter::kGaussian},
      {"64 spp, float, gaussian", 64, PixelPattern::kShared, PixelFilter::kGaussian, false},
      {"64 spp, 8 bits", 64},
      {"64 spp, float", 64, PixelPattern::kShared, PixelFilter::kBox, false},
      {"64 spp, float, scrambled", 64, PixelPattern::kScrambled, PixelFilter::kBox, false},
      {"4 spp, 8 bits, gaussian", 4, PixelPattern::kShared, PixelFilter::kGaussian},
      {"4 spp, 8 bits", 4},
      {"4 spp, 8 bits, scrambled", 4, PixelPattern::kScrambled},
      {"4 spp, float", 4, PixelPattern::kShared, PixelFilter::kBox, false},
      {"4 spp, float, scrambled", 4, PixelPattern::kScrambled, PixelFilter::kBox, false}};
  return cases;
}

Json ConsistencyPlan::ToJson() const {
  return {{"width", width}, {"pairs", pairs}, {"apart", apart}, {"fps", fps}};
}

ConsistencyResult MeasureConsistency(const World& world, const ConsistencyPlan& plan,
                                     const ConsistencyCase& made) {
  const sim::Renderer renderer(world.scene, Rendering(plan, made));
  ConsistencyResult result{made};
  std::vector<float> all, gradient;
  for (const Pair& pair : PairsOf(world, plan)) {
    ThrowIfInterrupted();
    const PhotoDifferences differences =
        ComparePictures(renderer.options().camera, ViewAt(renderer, world, pair.onto_s, made),
                        ViewAt(renderer, world, pair.from_s, made));
    Append(all, differences.all);
    Append(gradient, differences.at_gradients);
    result.hidden += differences.hidden;
  }
  result.pixels_all = all.size();
  result.pixels_gradient = gradient.size();
  result.median_all = Quantile(all, 0.5);
  result.median_gradient = Quantile(gradient, 0.5);
  return result;
}

DepthConsistency MeasureDepthConsistency(const World& world, const ConsistencyPlan& plan) {
  const sim::Renderer renderer(world.scene, Rendering(plan, {}));
  DepthConsistency depth;
  std::vector<double> all;
  for (const Pair& pair : PairsOf(world, plan)) {
    ThrowIfInterrupted();
    const SE3d onto = world.path.WorldFromCamera(pair.onto_s);
    const DepthDifferences differences = CompareDepths(*world.scene, renderer.options().camera,
                                                       {{}, renderer.RenderDepth(onto), onto},
                                                       world.path.WorldFromCamera(pair.from_s));
    Append(all, differences.m);
    depth.hidden += differences.hidden;
  }
  depth.pixels = all.size();
  depth.median_m = Quantile(all, 0.5);
  depth.percentile_999_m = Quantile(all, 0.999);
  depth.maximum_m = Quantile(all, 1);
  depth.beyond = std::size_t(
      std::count_if(all.begin(), all.end(), [](double d) { return d > kConsistent_m; }));
  return depth;
}

Json DepthConsistency::ToJson() const {
  return {{"median_m", median_m},    {"percentile_99.9_m", percentile_999_m},
          {"maximum_m", maximum_m},  {"pixels", pixels},
          {"beyond_1e-5_m", beyond}, {"hidden", hidden}};
}

Json ToJson(const std::vector<ConsistencyResult>& results) {
  Json rows = Json::array();
  for (const ConsistencyResult& r : results) {
    rows.push_back({{"case", r.made.name},
                    {"samples_per_pixel", r.made.samples_per_pixel},
                    {"scrambled", r.made.pattern == PixelPattern::kScrambled},
                    {"filter", r.made.filter == PixelFilter::kBox ? "box" : "gaussian"},
                    {"eight_bits", r.made.eight_bits},
                    {"median_levels", r.median_all},
                    {"median_levels_at_gradients", r.median_gradient},
                    {"pixels", r.pixels_all},
                    {"pixels_at_gradients", r.pixels_gradient},
                    {"hidden", r.hidden}});
  }
  return rows;
}

std::string FormatConsistency(const std::vector<ConsistencyResult>& results,
                              const DepthConsistency& depth) {
  char line[200];
  std::snprintf(line, sizeof line, "%-28s %12s %24s\n", "median |dI| in levels", "all pixels",
                "gradient 0.5-2 / pixel");
  std::string text = line;
  for (const ConsistencyResult& r : results) {
    std::snprintf(line, sizeof line, "%-28s %12.3f %24.3f\n", r.made.name.c_str(), r.median_all,
                  r.median_gradient);
    text += line;
  }
  std::snprintf(
      line, sizeof line,
      "Depths differ by %.1e m in the median, %.1e m at 99.9 %%, %.1e m at most; %zu of %zu "
      "pixels by more than 1e-5 m.\n",
      depth.median_m, depth.percentile_999_m, depth.maximum_m, depth.beyond, depth.pixels);
  return text + line;
}

}  // namespace silt::experiments
