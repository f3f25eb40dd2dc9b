// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/light_comparison.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "silt/core/color.h"
#include "silt/core/error.h"
#include "silt/experiments/case_runner.h"
#include "silt/experiments/resources.h"
#include "silt/sim/camera_rays.h"
#include "silt/sim/path_file.h"
#include "silt/sim/path_renderer.h"
#include "silt/sim/sampling.h"

namespace silt::experiments {
namespace {

// Baked light is looked up at so many places along either side of a pixel: on a regular grid, what
// an edge covers of the pixel is known to half an interval. Fewer for larger pictures.
constexpr int kSubpixels = 32, kLeastSubpixels = 8, kFineWidth = 5120;

// Of red, green and blue.
std::array<double, 3> Steps(const Vec3f& radiance, double exposure) {
  const auto step = [&](float value) {
    return 255.0 * double(SrgbFromLinear(std::clamp(float(exposure) * value, 0.0f, 1.0f)));
  };
  return {step(radiance.x), step(radiance.y), step(radiance.z)};
}

// Steps per radiance: noise, which is large, is taken along the tangent, since the curve would bend
// its mean.
double Slope(double radiance, double exposure) {
  const double step = 0.01 / exposure;
  const auto encoded = [&](double value) {
    return double(SrgbFromLinear(std::clamp(float(exposure * value), 0.0f, 1.0f)));
  };
  return 255 * (encoded(radiance + step) - encoded(radiance - step)) / (2 * step);
}

}  // namespace

std::vector<LightView> ViewsAlong(const std::string& scene, const std::vector<std::string>& paths,
                                  int views) {
  std::vector<LightView> result;
  const std::filesystem::path scene_file = SceneFile(scene);
  for (std::size_t p = 0; p < paths.size(); ++p) {
    const sim::CameraPath path = sim::LoadCameraPath(PathFile(scene_file, paths[p]));
    const int count = (views + int(p)) / int(paths.size());
    for (int i = 0; i < count; ++i) {
      result.push_back({paths[p] + "_" + std::to_string(i),
                        path.WorldFromCamera((i + 0.5) / count * path.duration_s())});
    }
  }
  return result;
}

Image<Vec3f> ReferencePicture::Mean() const {
  Image<Vec3f> mean = half[0];
  for (std::size_t i = 0; i < mean.size(); ++i) {
    mean.data()[i] = 0.5f * (half[0].data()[i] + half[1].data()[i]);
  }
  return mean;
}

ReferencePicture TraceReference(const sim::LitScene& scene, const LightView& view,
                                std::uint32_t number, const PathReference& reference) {
  const PinholeCamera camera = IclNuimCameraOfWidth(reference.width);
  const sim::CameraRays camera_rays(camera, view.world_from_camera);
  sim::PathOptions options;
  options.reflection = reference.reflection;
  const sim::PathTracer tracer(scene.scene(), scene.tracer(), options);
  const int samples = std::max(1, reference.samples_per_pixel / 2);
  const std::vector<Vec2d> places = sim::SquareSamples(samples);
  const auto fill = [&](int k, int x, int y, sim::RayPacket& rays) {
    camera_rays.Fill(x, y, places[std::size_t(k)] - Vec2d{0.5, 0.5}, rays);
  };
  ReferencePicture picture;
  for (const std::uint64_t half : {0, 1}) {
    picture.half[half] = sim::RenderPaths(
        tracer, {camera.width, camera.height, samples, 2 * reference.seed + half, number}, fill);
  }
  return picture;
}

// Many small pixels for each, so that textures are as sharp as paths see them.
Image<Vec3f> RenderBaked(const std::shared_ptr<const sim::LitScene>& scene, const LightView& view,
                         int width) {
  sim::RenderOptions options;
  const int subpixels = std::clamp(kFineWidth / width, kLeastSubpixels, kSubpixels);
  options.camera = IclNuimCameraOfWidth(width * subpixels);
  options.samples_per_pixel = 1;
  const Image<Vec3f> fine =
      sim::Renderer(scene, options).RenderLinear([&](double) { return view.world_from_camera; }, 0);
  Image<Vec3f> picture(width, fine.height() / subpixels);
  const float share = 1 / float(subpixels * subpixels);
  for (int y = 0; y < fine.height(); ++y) {
    for (int x = 0; x < fine.width(); ++x) {
      picture(x / subpixels, y / subpixels) += share * fine(x, y);
    }
  }
  return picture;
}

LightDifference Compare(const std::vector<Image<Vec3f>>& baked,
                        const std::vector<ReferencePicture>& reference, double exposure) {
  SILT_CHECK(baked.size() == reference.size());
  LightDifference result;
  std::vector<double> differences;
  double product = 0, noise = 0;
  for (std::size_t i = 0; i < baked.size(); ++i) {
    const Image<Vec3f> mean = reference[i].Mean();
    for (std::size_t k = 0; k < mean.size(); ++k) {
      const auto b = Steps(baked[i].data()[k], exposure), m = Steps(mean.data()[k], exposure);
      const auto first = Steps(reference[i].half[0].data()[k], exposure);
      const auto second = Steps(reference[i].half[1].data()[k], exposure);
      for (std::size_t c = 0; c < 3; ++c) {
        differences.push_back(std::abs(b[c] - m[c]));
        result.mean += std::abs(b[c] - m[c]);
        result.bias += b[c] - m[c];
        const double slope = Slope((&baked[i].data()[k].x)[c], exposure);
        const auto off = [&](int half) {
          const double traced = (&reference[i].half[half].data()[k].x)[c];
          return slope * ((&baked[i].data()[k].x)[c] - traced);
        };
        product += off(0) * off(1);
        noise += (first[c] - second[c]) * (first[c] - second[c]) / 4;
      }
    }
  }
  if (differences.empty()) return result;
  const auto count = double(differences.size());
  const auto place = std::size_t(0.99 * (count - 1));
  std::nth_element(differences.begin(), differences.begin() + std::ptrdiff_t(place),
                   differences.end());
  result.percentile_99 = differences[place];
  result.mean /= count;
  result.bias /= count;
  result.reference_noise = std::sqrt(noise / count);
  result.rms = std::sqrt(std::max(0.0, product / count));
  return result;
}

double RmsDifference(const std::vector<Image<Vec3f>>& a, const std::vector<Image<Vec3f>>& b,
                     double exposure) {
  SILT_CHECK(a.size() == b.size());
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < a[i].size(); ++k) {
      const auto first = Steps(a[i].data()[k], exposure), second = Steps(b[i].data()[k], exposure);
      for (std::size_t c = 0; c < 3; ++c) {
        squares += (first[c] - second[c]) * (first[c] - second[c]);
        ++count;
      }
    }
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

Image<Rgb8> DifferencePicture(const Image<Vec3f>& baked, const Image<Vec3f>& reference,
                              double exposure) {
  Image<Rgb8> picture(baked.width(), baked.height());
  for (std::size_t k = 0; k < baked.size(); ++k) {
    const auto b = Steps(baked.data()[k], exposure), r = Steps(reference.data()[k], exposure);
    const auto byte = [&](std::size_t c) {
      return std::uint8_t(std::clamp(128 + 8 * (b[c] - r[c]), 0.0, 255.0));
    };
    picture.data()[k] = {byte(0), byte(1), byte(2)};
  }
  return picture;
}

Json ToJson(const LightDifference& d) {
  return {{"mean", d.mean},
          {"percentile_99", d.percentile_99},
          {"bias", d.bias},
          {"reference_noise", d.reference_noise},
          {"rms_without_noise", d.rms}};
}

}  // namespace silt::experiments
