// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/align_bench.h"

#include <algorithm>
#include <memory>

#include "silt/core/error.h"
#include "silt/core/random.h"
#include "silt/tracker/alignment.h"
#include "silt/tracker/stopwatch.h"

namespace silt::dense {
namespace {

struct Prepared {
  std::unique_ptr<const tracker::ReferencePyramid> reference;
  std::unique_ptr<const tracker::CurrentPyramid> current;
};

std::vector<Prepared> Prepare(const tracker::Backend& backend, const std::vector<MovedPair>& pairs,
                              const tracker::AlignmentOptions& options) {
  std::vector<Prepared> prepared;
  const Image<float> none;
  for (const MovedPair& pair : pairs) {
    prepared.push_back(
        {backend.MakeReferenceOfColour(pair.reference.rgb, pair.reference.depth_m, pair.camera,
                                       options.Pyramids()),
         backend.MakeCurrentOfColour(pair.current.rgb,
                                     options.use_current_depth ? pair.current.depth_m : none,
                                     options.Pyramids())});
  }
  return prepared;
}

double Median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

SE3d Near(const SE3d& truth, int index) {
  constexpr double metres = 0.02 / 1.74, radians = 1.0 / 57.3 / 1.74;  // along each axis
  const CounterRandom random(17, std::uint64_t(index));
  const auto component = [&](std::uint64_t k) { return 2 * random.Uniform(k) - 1; };
  return SE3d::Exp({radians * Vec3d{component(0), component(1), component(2)},
                    metres * Vec3d{component(3), component(4), component(5)}}) *
         truth;
}

}  // namespace

double AlignFigures::PerSecond() const { return 1000 / (device_ms > 0 ? device_ms : wall_ms); }

tracker::AlignmentOptions RefinementOptions() {
  tracker::AlignmentOptions options = tracker::PaperPreset().alignment;
  options.min_update_norm = 0;
  return options;
}

AlignFigures MeasureRefinement(const tracker::Backend& backend, const std::vector<MovedPair>& pairs,
                               const tracker::AlignmentOptions& options, int repeats) {
  SILT_CHECK(!pairs.empty() && repeats > 0);
  const std::vector<Prepared> prepared = Prepare(backend, pairs, options);
  std::vector<double> wall_ms, device_ms;
  AlignFigures figures;
  const int warm_up = int(pairs.size());
  for (int i = 0; i < warm_up + repeats; ++i) {
    const std::size_t k = std::size_t(i) % pairs.size();
    double milliseconds = 0;
    tracker::AlignmentResult result;
    {
      const tracker::Stopwatch watch(&milliseconds);
      result = tracker::Align(backend, {*prepared[k].reference, *prepared[k].current},
                              Near(pairs[k].current_from_reference, i), options);
    }
    if (i < warm_up) continue;
    wall_ms.push_back(milliseconds);
    device_ms.push_back(result.batch_ms);
    figures.ok += result.ok;
    figures.work += WorkOf(result, options) * (1.0 / repeats);
  }
  figures.alignments = repeats;
  figures.wall_ms = Median(wall_ms);
  figures.device_ms = Median(device_ms);
  return figures;
}

AlignFigures MeasureBatch(const tracker::Backend& backend, const std::vector<MovedPair>& pairs,
                          const tracker::AlignmentOptions& options, int starts) {
  SILT_CHECK(!pairs.empty() && starts > 0);
  const std::vector<Prepared> prepared = Prepare(backend, pairs, options);
  std::vector<tracker::AlignmentStart> all;
  for (int i = 0; i < starts; ++i) {
    const std::size_t k = std::size_t(i) % pairs.size();
    all.push_back(
        {*prepared[k].reference, *prepared[k].current, Near(pairs[k].current_from_reference, i)});
  }
  tracker::AlignBatch(backend, all, options);  // warms up
  AlignFigures figures;
  std::vector<tracker::AlignmentResult> results;
  {
    const tracker::Stopwatch watch(&figures.wall_ms);
    results = tracker::AlignBatch(backend, all, options);
  }
  for (const tracker::AlignmentResult& result : results) {
    figures.ok += result.ok;
    figures.work += WorkOf(result, options) * (1.0 / starts);
  }
  figures.alignments = starts;
  figures.wall_ms /= starts;
  figures.device_ms = results.front().batch_ms / starts;
  return figures;
}

}  // namespace silt::dense
