// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/light_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "silt/core/parallel.h"
#include "silt/sim/denormals.h"
#include "silt/sim/direct_light.h"
#include "silt/sim/environment_light.h"
#include "silt/sim/gathered_light.h"
#include "silt/sim/indirect_light.h"
#include "silt/sim/light_refinement.h"
#include "silt/sim/surface_colors.h"

namespace silt::sim {

namespace {

// Shares of the work, about, in the office.
constexpr double kDirectDone = 0.2, kBouncesDone = 0.3, kGatheringDone = 0.6;
// After so many passes the rest of the series of reflections is extrapolated.
constexpr int kExtrapolateAfter = 3;
constexpr float kFillInSpacings = 2.5f;
constexpr int kLookingDirections = kPacketSize;

struct ProgressRange {
  double from, to;
};

// Calls body(i) for i in [0, n) in blocks, in parallel, and reports progress between them.
void ForSamples(std::size_t n, const LightingOptions& options, const ProgressRange& range,
                const std::function<void(std::size_t)>& body) {
  constexpr std::size_t block = 64, blocks_per_report = 256;
  for (std::size_t begin = 0; begin < n; begin += block * blocks_per_report) {
    const std::size_t end = std::min(n, begin + block * blocks_per_report);
    ParallelFor(int((end - begin + block - 1) / block), [&](int b) {
      const ScopedFlushDenormals flush;
      const std::size_t first = begin + std::size_t(b) * block;
      for (std::size_t i = first; i < std::min(end, first + block); ++i) body(i);
    });
    if (options.progress) {
      options.progress(range.from + (range.to - range.from) * double(end) / double(n));
    }
  }
}

Vec3d Total(const StoredLight& light) {
  Vec3d sum;
  for (const std::vector<Vec3f>* side : {&light.front, &light.back}) {
    for (const Vec3f& e : *side) sum += e.Cast<double>();
  }
  return sum;
}

// What the rest of a geometric series is of its last term, whose ratio to the one before is given.
float RestOfSeries(double term, double term_before) {
  const double ratio = term_before > 0 ? std::clamp(term / term_before, 0.0, 0.9) : 0;
  return float(ratio / (1 - ratio));
}

void Extrapolate(const Vec3f& factor, const StoredLight& before, StoredLight& now) {
  for (const bool front : {true, false}) {
    for (std::size_t i = 0; i < now.front.size(); ++i) {
      Vec3f& e = now.side(front)[i];
      e += factor * (e - before.side(front)[i]);
      e = {std::max(e.x, 0.0f), std::max(e.y, 0.0f), std::max(e.z, 0.0f)};
    }
  }
}

StoredLight Sum(const StoredLight& a, const StoredLight& b) {
  StoredLight sum = a;
  for (std::size_t i = 0; i < a.front.size(); ++i) {
    sum.front[i] += b.front[i];
    sum.back[i] += b.back[i];
  }
  return sum;
}

StoredLight Blend(const StoredLight& a, const StoredLight& b, float share_of_b) {
  StoredLight mean = a;
  for (std::size_t i = 0; i < a.front.size(); ++i) {
    mean.front[i] += share_of_b * (b.front[i] - a.front[i]);
    mean.back[i] += share_of_b * (b.back[i] - a.back[i]);
  }
  return mean;
}

class LightSolver {
 public:
  LightSolver(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
              const LightingOptions& options)
      : scene_(scene),
        tracer_(tracer),
        grid_(grid),
        samples_(grid.samples()),
        options_(options),
        colors_(scene, grid, options.direct_spacing_m) {}

  BakedLight Solve() {
    for (const bool front : {true, false}) near_[front] = LookAround(front);
    StoredLight direct = SolveDirect();
    for (const bool front : {true, false}) Fill(front, Buried(front), direct);
    const std::vector<float> widths(samples_.size(), options_.bounce_spacing_m);
    const SampleClusters coarse = ClusterSamples(samples_, widths);
    const StoredLight sent = colors_.Radiance(Sum(direct, SolveBounces(direct, coarse)));
    StoredLight indirect(samples_.size());
    for (const bool front : {true, false}) GatherSide(front, sent, coarse, direct, indirect);
    const LightRefinement refinement(scene_, tracer_, grid_, options_);
    FineLight fine = refinement.Refine({direct, indirect, near_}, [&](double done) {
      if (options_.progress) options_.progress(kGatheringDone + (1 - kGatheringDone) * done);
    });
    return {Sum(direct, indirect), std::move(fine)};
  }

 private:
  StoredLight SolveDirect() const {
    StoredLight light(samples_.size());
    const DirectLight direct(scene_, tracer_, options_.light_points);
    const EnvironmentLight background(scene_, tracer_, options_.environment_directions);
    ForSamples(samples_.size(), options_, {0, kDirectDone}, [&](std::size_t i) {
      for (const bool front : {true, false}) {
        const Vec3f& position = samples_[i].position;
        const Vec3f normal = front ? samples_[i].normal : -samples_[i].normal;
        light.side(front)[i] =
            direct.Irradiance(position, normal) + background.Irradiance(position, normal);
      }
    });
    return light;
  }

  // Reflection after reflection, with few rays each, whose errors are of many samples and average
  // out in the gathering that follows: E₀ = 0, E_{k+1} = gathered from direct + E_k. The rest of
  // the series follows from the ratio of its last terms.
  StoredLight SolveBounces(const StoredLight& direct, const SampleClusters& coarse) {
    StoredLight indirect(samples_.size());
    Vec3d last_gain;
    const double step = (kBouncesDone - kDirectDone) / (2 * std::max(options_.bounces, 1));
    double done = kDirectDone;
    for (std::vector<double>& nearness : nearness_) nearness.assign(coarse.leaders.size(), 0);
    const std::vector<bool> buried[2] = {Buried(false), Buried(true)};
    for (int pass = 0; pass < options_.bounces; ++pass) {
      const StoredLight before = std::move(indirect);
      indirect = StoredLight(samples_.size());
      const StoredLight sent = colors_.Radiance(Sum(direct, before));
      for (const bool front : {true, false}) {
        const std::uint64_t draw = (options_.seed * 64 + std::uint64_t(pass)) * 2 + (front ? 0 : 1);
        const std::vector<Gathered> gathered =
            Gather(front, sent, coarse.AnyOfEach(buried[front], draw),
                   {options_.bounce_directions, std::uint64_t(pass) + 1, {done, done + step}});
        done += step;
        for (std::size_t i = 0; i < gathered.size(); ++i) {
          nearness_[front][i] += 1 / double(gathered[i].distance_m) / options_.bounces;
        }
        for (std::size_t i = 0; i < samples_.size(); ++i) {
          indirect.side(front)[i] = gathered[coarse.leader_of[i]].irradiance;
        }
      }
      // Once they have settled, passes are estimates of the same, each from other places.
      const int settled = pass - kExtrapolateAfter;
      if (settled > 1) indirect = Blend(before, indirect, 1.0f / float(settled));
      const Vec3d gain = Total(indirect) - Total(before);
      if (pass == kExtrapolateAfter) {
        Extrapolate({RestOfSeries(gain.x, last_gain.x), RestOfSeries(gain.y, last_gain.y),
                     RestOfSeries(gain.z, last_gain.z)},
                    before, indirect);
      }
      last_gain = gain;
    }
    return indirect;
  }

  // The last gathering, fine where things are near, of one side of all surfaces.
  void GatherSide(bool front, const StoredLight& sent, const SampleClusters& coarse,
                  StoredLight& direct, StoredLight& indirect) {
    std::vector<float> distance_m;
    for (const double nearness : nearness_[front]) {
      distance_m.push_back(nearness > 0 ? float(1 / nearness) : 1e30f);
    }
    std::vector<float> widths = GatherWidths(
        samples_, coarse, distance_m, options_.direct_spacing_m, options_.indirect_spacing_m);
    NarrowBy(near_[front], options_.direct_spacing_m, widths);
    const SampleClusters fine = ClusterSamples(samples_, widths);
    const double middle = (kGatheringDone + kBouncesDone) / 2;
    std::vector<Gathered> gathered =
        Gather(front, sent, fine.leaders,
               {options_.gather_directions,
                0,
                front ? ProgressRange{kBouncesDone, middle} : ProgressRange{middle, kGatheringDone},
                {options_.gather_rounds, options_.gather_tolerance},
                &direct});
    std::vector<bool> buried = Buried(front);
    for (std::size_t i = 0; i < gathered.size(); ++i) {
      gathered[i].buried = gathered[i].buried || buried[fine.leaders[i]];
    }
    indirect.side(front) = Interpolated(samples_, fine, widths, gathered);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      buried[i] = buried[i] || gathered[fine.leader_of[i]].buried;
    }
    Fill(front, buried, direct);
    Fill(front, buried, indirect);
  }

  void Fill(bool front, const std::vector<bool>& buried, StoredLight& light) const {
    FillBuried(samples_, buried, kFillInSpacings * options_.direct_spacing_m, light.side(front));
  }

  std::vector<bool> Buried(bool front) const {
    std::vector<bool> buried;
    for (const Gathered& near : near_[front]) buried.push_back(near.buried);
    return buried;
  }

  // How far things are from each sample, by few rays: those of all bakes, whatever their seed.
  std::vector<Gathered> LookAround(bool front) const {
    const IndirectLight light(scene_, tracer_, kLookingDirections, 0);
    std::vector<Gathered> near(samples_.size());
    ForSamples(samples_.size(), {}, {0, 1}, [&](std::size_t i) {
      const SurfaceSample& sample = samples_[i];
      near[i] = light.Gather(sample.position, front ? sample.normal : -sample.normal,
                             2 * std::uint64_t(i) + (front ? 0 : 1),
                             [](const TriangleHit&, const Vec3f&) { return Vec3f{}; });
    });
    return near;
  }

  struct GatherPlan {
    int directions;
    std::uint64_t pass;
    ProgressRange range;
    IndirectLight::Rounds rounds = {1, 0};
    const StoredLight* known = nullptr;
  };
  std::vector<Gathered> Gather(bool front, const StoredLight& sent,
                               const std::vector<std::uint32_t>& at, const GatherPlan& plan) const {
    const IndirectLight light(scene_, tracer_, plan.directions, options_.seed * 64 + plan.pass,
                              plan.rounds);
    const SurfaceRadiance radiance = [&](const TriangleHit& hit, const Vec3f&) {
      return sent.At(grid_.Locate(hit.triangle, hit.u, hit.v), hit.front);
    };
    std::vector<Gathered> gathered(at.size());
    ForSamples(at.size(), options_, plan.range, [&](std::size_t i) {
      const SurfaceSample& sample = samples_[at[i]];
      gathered[i] = light.Gather(sample.position, front ? sample.normal : -sample.normal,
                                 2 * std::uint64_t(at[i]) + (front ? 0 : 1), radiance,
                                 plan.known ? plan.known->side(front)[at[i]] : Vec3f{});
    });
    return gathered;
  }

  const Scene& scene_;
  const RayTracer& tracer_;
  const SurfaceGrid& grid_;
  const std::vector<SurfaceSample>& samples_;
  const LightingOptions& options_;
  SurfaceColors colors_;
  std::vector<Gathered> near_[2];    // by side (front: 1) and sample, by few rays
  std::vector<double> nearness_[2];  // by side (front: 1) and coarse leader, in 1/m
};

}  // namespace

BakedLight SolveLight(const Scene& scene, const RayTracer& tracer, const SurfaceGrid& grid,
                      const LightingOptions& options) {
  return LightSolver(scene, tracer, grid, options).Solve();
}

}  // namespace silt::sim
