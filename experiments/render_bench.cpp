// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/render_bench.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "silt/core/error.h"
#include "silt/core/parallel.h"
#include "silt/experiments/interrupt.h"
#include "silt/sim/centre_rays.h"
#include "silt/sim/exposure_rays.h"
#include "silt/sim/image_tiles.h"
#include "silt/sim/radiance_pass.h"

namespace silt::experiments {
namespace {

using sim::RayPacket;

constexpr double kExposure_s = 1.0 / 60;

double ProcessSeconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double WallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Seconds {
  double cpu = std::numeric_limits<double>::infinity();
  double wall = std::numeric_limits<double>::infinity();

  void KeepLeast(const std::function<void()>& work) {
    const double cpu_before = ProcessSeconds(), wall_before = WallSeconds();
    work();
    cpu = std::min(cpu, ProcessSeconds() - cpu_before);
    wall = std::min(wall, WallSeconds() - wall_before);
  }
};

// Makes the rays of a block of pixels.
using FillPacket = std::function<void(int sample, int x, int y, RayPacket& rays)>;

// A picture in lots of a few tiles, whose packets fit into the cache while they are traced.
std::vector<std::vector<sim::ImageTile>> Lots(const PinholeCamera& camera) {
  constexpr int kSide = sim::ImageTile::kSide;
  constexpr std::size_t kTilesInLot = 10;
  std::vector<std::vector<sim::ImageTile>> lots(1);
  for (int y = 0; y < camera.height; y += kSide) {
    for (int x = 0; x < camera.width; x += kSide) {
      if (lots.back().size() == kTilesInLot) lots.emplace_back();
      lots.back().push_back(
          {x, y, std::min(x + kSide, camera.width), std::min(y + kSide, camera.height)});
    }
  }
  return lots;
}

// Processor time of Embree alone for samples of a whole picture.
double RawSeconds(const sim::RayTracer& tracer, const PinholeCamera& camera, int samples,
                  const FillPacket& fill) {
  const auto lots = Lots(camera);
  std::vector<double> seconds(lots.size());
  ParallelFor(int(lots.size()), [&](int i) {
    for (int k = 0; k < samples; ++k) {
      std::vector<RayPacket> packets;
      for (const sim::ImageTile& tile : lots[std::size_t(i)]) {
        ForEachBlock(tile, [&](int x, int y) { fill(k, x, y, packets.emplace_back()); });
      }
      seconds[std::size_t(i)] += tracer.TimeTracing(packets);
    }
  });
  return std::accumulate(seconds.begin(), seconds.end(), 0.0);
}

// Rays made, traced and their hits unpacked, but not looked at.
void TraceOnly(const sim::RayTracer& tracer, const sim::ExposureRays& rays) {
  sim::ForEachTile(rays.camera().width, rays.camera().height, [&](const sim::ImageTile& tile) {
    for (int k = 0; k < rays.count(); ++k) {
      ForEachBlock(tile, [&](int x, int y) {
        RayPacket packet;
        rays.Fill(k, x, y, packet);
        sim::HitPacket hits;
        tracer.TraceCoherent(packet, hits);
      });
    }
  });
}

// The measurements at one instant.
class Instant {
 public:
  Instant(const World& world, const RenderBenchOptions& options, double time_s)
      : tracer_(world.scene->tracer()),
        pose_(world.Pose()),
        time_s_(time_s),
        sharp_(world.scene, Rendering(options, 0)),
        blurred_(world.scene, Rendering(options, kExposure_s)),
        centre_(camera(), {}, pose_, time_s),
        sharp_rays_(RaysOf(sharp_)),
        blurred_rays_(RaysOf(blurred_)) {}

  void Repeat() {
    raw_centre_ = std::min(
        raw_centre_, RawSeconds(tracer_, camera(), 1, [&](int, int x, int y, RayPacket& rays) {
          centre_.Fill(x, y, rays);
        }));
    geometry_.KeepLeast([&] { (void)sharp_.RenderGeometry(pose_, time_s_); });
    raw_sharp_ = std::min(raw_sharp_, RawOf(sharp_rays_));
    trace_.KeepLeast([&] { TraceOnly(tracer_, sharp_rays_); });
    linear_.KeepLeast([&] { (void)sharp_.RenderLinear(pose_, time_s_); });
    sharp_frame_.KeepLeast([&] { (void)sharp_.Render(pose_, time_s_, 0); });
    raw_blurred_ = std::min(raw_blurred_, RawOf(blurred_rays_));
    blurred_frame_.KeepLeast([&] { (void)blurred_.Render(pose_, time_s_, 0); });
  }

  // Adds a share of this instant's to the mean.
  void AddTo(RenderBench& bench, double share) const {
    const double pixels = double(camera().width) * camera().height;
    const auto add = [share](RenderSpeed& speed, double rays, double raw_s, const Seconds& s) {
      speed.rays = rays;
      speed.raw_s += share * raw_s;
      speed.cpu_s += share * s.cpu;
      speed.wall_s += share * s.wall;
    };
    add(bench.geometry, pixels, raw_centre_, geometry_);
    add(bench.baked_4spp, pixels * (sharp_rays_.count() + 1), raw_sharp_ + raw_centre_,
        sharp_frame_);
    add(bench.blur_16, pixels * (blurred_rays_.count() + 1), raw_blurred_ + raw_centre_,
        blurred_frame_);
    const double ns = 1e9 * share / (pixels * sharp_rays_.count());
    bench.costs.embree_ns += ns * raw_sharp_;
    bench.costs.rays_and_hits_ns += ns * (trace_.cpu - raw_sharp_);
    bench.costs.shading_ns += ns * (linear_.cpu - trace_.cpu);
  }

 private:
  static sim::RenderOptions Rendering(const RenderBenchOptions& options, double exposure_s) {
    sim::RenderOptions rendering;
    rendering.camera = IclNuimCameraOfWidth(options.width);
    rendering.shutter.exposure_s = exposure_s;
    return rendering;
  }
  const PinholeCamera& camera() const { return sharp_.options().camera; }
  sim::ExposureRays RaysOf(const sim::Renderer& renderer) const {
    const sim::RenderOptions& o = renderer.options();
    return {o.camera, {.samples_per_pixel = o.samples_per_pixel}, o.shutter, pose_, time_s_};
  }
  double RawOf(const sim::ExposureRays& rays) const {
    return RawSeconds(tracer_, camera(), rays.count(),
                      [&](int k, int x, int y, RayPacket& packet) { rays.Fill(k, x, y, packet); });
  }

  const sim::RayTracer& tracer_;
  sim::PoseAtTime pose_;
  double time_s_;
  sim::Renderer sharp_, blurred_;
  sim::CentreRays centre_;
  sim::ExposureRays sharp_rays_, blurred_rays_;
  double raw_centre_ = std::numeric_limits<double>::infinity();
  double raw_sharp_ = raw_centre_, raw_blurred_ = raw_centre_;
  Seconds geometry_, trace_, linear_, sharp_frame_, blurred_frame_;
};

Json SpeedJson(const RenderSpeed& speed, int threads) {
  return {{"mrays", speed.MegaRays(threads)},
          {"raw_mrays", speed.RawMegaRays(threads)},
          {"ratio", speed.Ratio()},
          {"fps", speed.Fps()},
          {"cpu_s", speed.cpu_s},
          {"wall_s", speed.wall_s}};
}

std::string SpeedRow(const RenderSpeed& speed, int threads) {
  char row[160];
  std::snprintf(row, sizeof row, "%-34s %8.1f %8.1f %7.0f %% %8.1f\n", speed.name.c_str(),
                speed.RawMegaRays(threads), speed.MegaRays(threads), 100 * speed.Ratio(),
                speed.Fps());
  return row;
}

}  // namespace

Json RenderBenchOptions::ToJson() const {
  return {{"width", width}, {"instants", instants}, {"repeats", repeats}};
}

Json RenderBench::ToJson(int threads) const {
  return {{"raw", {{"mrays", geometry.RawMegaRays(threads)}}},
          {"geometry", SpeedJson(geometry, threads)},
          {"baked_4spp", SpeedJson(baked_4spp, threads)},
          {"blur_16", SpeedJson(blur_16, threads)},
          {"ns_per_ray",
           {{"embree", costs.embree_ns},
            {"rays_and_hits", costs.rays_and_hits_ns},
            {"shading", costs.shading_ns}}}};
}

std::string RenderBench::Format(int threads) const {
  char line[160];
  std::snprintf(line, sizeof line, "%-34s %8s %8s %9s %8s\n%-34s %8s %8s %9s %8s\n", "", "Embree",
                "silt", "", "frames", "", "Mrays/s", "Mrays/s", "ratio", "per s");
  std::string text = line;
  for (const RenderSpeed* speed : {&geometry, &baked_4spp, &blur_16}) {
    text += SpeedRow(*speed, threads);
  }
  std::snprintf(line, sizeof line,
                "A ray of the second takes %.0f ns of a core: Embree %.0f, rays and hits %.0f, "
                "shading %.0f.\n",
                costs.embree_ns + costs.rays_and_hits_ns + costs.shading_ns, costs.embree_ns,
                costs.rays_and_hits_ns, costs.shading_ns);
  return text + line;
}

RenderBench MeasureRendering(const World& world, const RenderBenchOptions& options) {
  SILT_CHECK(options.instants >= 1 && options.repeats >= 1);
  RenderBench bench;
  bench.geometry.name = "depth, normals, ids; 1 ray";
  bench.baked_4spp.name = "colour and depth; 4 + 1 rays";
  bench.blur_16.name = "with 16 instants; 16 + 1 rays";
  for (int i = 0; i < options.instants; ++i) {
    Instant instant(world, options, (i + 0.5) / options.instants * world.path.duration_s());
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
      ThrowIfInterrupted();
      instant.Repeat();
    }
    instant.AddTo(bench, 1.0 / options.instants);
  }
  return bench;
}

}  // namespace silt::experiments
