// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "silt/experiments/statistics.h"
#include "silt/experiments/track_bench.h"

namespace silt::experiments {
namespace {

using Value = std::function<double(const PairRun&)>;
using Chosen = std::function<bool(const BenchPair&)>;

// Of some runs, the pairs' medians.
class Medians {
 public:
  Medians(const TrackBench& bench, const std::vector<PairRun>& runs, const Chosen& chosen) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      if (!chosen(bench.pairs[i])) continue;
      runs_.push_back(runs[i]);
      load_ms_.push_back(bench.pairs[i].load_ms);
    }
  }

  double Of(const Value& value) const {
    std::vector<double> values;
    for (const PairRun& run : runs_) values.push_back(value(run));
    return Median(values);
  }
  double Milliseconds() const {
    return Of([](const PairRun& r) { return r.milliseconds; });
  }
  double Load() const { return Median(load_ms_); }
  int Lost() const {
    int lost = 0;
    for (const PairRun& run : runs_) lost += !run.found;
    return lost;
  }

 private:
  std::vector<PairRun> runs_;
  std::vector<double> load_ms_;
};

bool All(const BenchPair&) { return true; }

struct Differences {
  Interval t_mm, r_deg;
};

Differences Between(const TrackBench& bench, const MethodRuns& a, const MethodRuns& b, int gap) {
  const auto of = [&](const MethodRuns& method, double PairRun::*error) {
    std::vector<double> values;
    for (std::size_t i = 0; i < method.threads.size(); ++i) {
      if (bench.pairs[i].gap == gap) values.push_back(method.threads[i].*error);
    }
    return values;
  };
  return {MedianDifference(of(a, &PairRun::t_mm), of(b, &PairRun::t_mm)),
          MedianDifference(of(a, &PairRun::r_deg), of(b, &PairRun::r_deg))};
}

// Of each of silt's methods and each of the others.
void ForRivals(const TrackBench& bench,
               const std::function<void(const MethodRuns&, const MethodRuns&)>& visit) {
  for (const MethodRuns& own : bench.methods) {
    for (const MethodRuns& other : bench.methods) {
      if (own.has_stages && !other.has_stages) visit(own, other);
    }
  }
}

Json MethodJson(const TrackBench& bench, const MethodRuns& method, const Chosen& chosen) {
  const Medians runs(bench, method.threads, chosen);
  return {{"ms", runs.Milliseconds()},
          {"t_mm", runs.Of([](const PairRun& r) { return r.t_mm; })},
          {"r_deg", runs.Of([](const PairRun& r) { return r.r_deg; })},
          {"ms_one_thread", Medians(bench, method.one_thread, chosen).Milliseconds()},
          {"lost", runs.Lost()}};
}

// Stages of a frame against a keyframe that is there; what a keyframe takes stands beside them.
Json StagesJson(const Medians& runs) {
  using tracker::StageTimes;
  const auto stage = [&](double StageTimes::*member) {
    return runs.Of([member](const PairRun& r) { return r.stages.*member; });
  };
  const double total_ms = stage(&StageTimes::total_ms);
  const Value rate = [](const PairRun& r) {
    const StageTimes& s = r.stages;
    return 1000 * r.pixel_iterations / (s.residual_ms + s.jacobian_ms + s.update_ms);
  };
  const double device_ms = runs.Of([](const PairRun& r) { return r.device_ms; });
  Json json{{"load", runs.Load()},
            {"pyramid", stage(&StageTimes::pyramid_ms)},
            {"initialization", stage(&StageTimes::initial_estimate_ms)},
            {"warp_residual", stage(&StageTimes::residual_ms)},
            {"jacobian", stage(&StageTimes::jacobian_ms)},
            {"solve", stage(&StageTimes::update_ms)},
            {"keyframe", runs.Of([](const PairRun& r) { return r.keyframe_ms; })},
            {"total", total_ms},
            {"frames_per_s", 1000 / total_ms},
            {"pixel_iterations_per_s", runs.Of(rate)}};
  if (device_ms > 0) {
    json["device_total"] = device_ms;
    json["device_frames_per_s"] = 1000 / device_ms;
  }
  return json;
}

std::set<int> Gaps(const TrackBench& bench) {
  std::set<int> gaps;
  for (const BenchPair& pair : bench.pairs) gaps.insert(pair.gap);
  return gaps;
}

Json GapsJson(const TrackBench& bench) {
  Json gaps = Json::array();
  for (const int gap : Gaps(bench)) {
    const Chosen chosen = [gap](const BenchPair& pair) { return pair.gap == gap; };
    Json json{{"frames_apart", gap}};
    for (const MethodRuns& method : bench.methods) {
      json[method.name] = MethodJson(bench, method, chosen);
    }
    ForRivals(bench, [&](const MethodRuns& own, const MethodRuns& other) {
      const auto [t_mm, r_deg] = Between(bench, own, other, gap);
      json[own.name]["less"][other.name] = {{"t_mm_95", {t_mm.low, t_mm.high}},
                                            {"r_deg_95", {r_deg.low, r_deg.high}}};
    });
    gaps.push_back(std::move(json));
  }
  return gaps;
}

std::string MethodLine(const TrackBench& bench, const MethodRuns& method, int gap) {
  const Json json = MethodJson(bench, method, [gap](const BenchPair& p) { return p.gap == gap; });
  char line[160];
  std::snprintf(line, sizeof line, "%5d  %-16s %10.2f %10.2f %10.4f %10.5f %6d\n", gap,
                method.name.c_str(), double(json["ms_one_thread"]), double(json["ms"]),
                double(json["t_mm"]), double(json["r_deg"]), int(json["lost"]));
  return line;
}

std::string DifferencesLine(const TrackBench& bench, const MethodRuns& own, const MethodRuns& other,
                            int gap) {
  const auto [t_mm, r_deg] = Between(bench, own, other, gap);
  char line[200];
  std::snprintf(line, sizeof line, "%5d  %s less %s: %.3f to %.3f mm, %.4f to %.4f deg\n", gap,
                own.name.c_str(), other.name.c_str(), t_mm.low, t_mm.high, r_deg.low, r_deg.high);
  return line;
}

std::string StagesLine(const TrackBench& bench, const MethodRuns& method) {
  const Json json = StagesJson(Medians(bench, method.threads, All));
  std::string text = method.name + ", ms of a frame:";
  for (const auto& [key, value] : json.items()) {
    char item[80];
    std::snprintf(item, sizeof item, " %s %.4g", key.c_str(), double(value));
    text += item;
  }
  return text + "\n";
}

}  // namespace

Json TrackBench::ToJson() const {
  Json by_method = Json::object(), stages = Json::object();
  for (const char* known : {"fast", "accurate", "opencv_rgbd", "opencv_rgbd_icp"}) {
    by_method[known] = nullptr;  // where this machine has no such method
  }
  for (const MethodRuns& method : methods) {
    by_method[method.name] = MethodJson(*this, method, All);
    if (!method.has_stages) continue;
    stages[method.name] = {{"one_thread", StagesJson(Medians(*this, method.one_thread, All))},
                           {"threads", StagesJson(Medians(*this, method.threads, All))}};
  }
  Json refined = Json::object();
  for (const Refinement& refinement : refinements) {
    refined[refinement.name] = Json::parse(dense::FiguresJson(refinement.figures, ceilings).Text());
  }
  return {{"refinement", refined},
          {"device", Json::parse(dense::DeviceFacts(backend, ceilings).Text())},
          {"pairs", by_method},
          {"pair_count", pairs.size()},
          {"threads", threads},
          {"gaps", GapsJson(*this)},
          {"stages_ms", stages},
          {"fused_pass_ms", fused_pass.photometric_ms},
          {"fused_pass_robust_ms", fused_pass.robust_ms},
          {"fused_pass_robust_depth_ms", fused_pass.robust_depth_ms}};
}

std::string TrackBench::Format() const {
  char line[200];
  std::snprintf(line, sizeof line,
                "%zu pairs, medians\n  gap  method           ms, 1 thr. ms, %d thr.  error/mm  "
                "error/deg   lost\n",
                pairs.size(), threads);
  std::string text = line;
  for (const int gap : Gaps(*this)) {
    for (const MethodRuns& method : methods) text += MethodLine(*this, method, gap);
  }
  std::string differences;
  for (const int gap : Gaps(*this)) {
    ForRivals(*this, [&](const MethodRuns& own, const MethodRuns& other) {
      differences += DifferencesLine(*this, own, other, gap);
    });
  }
  if (!differences.empty()) {
    text += "differences of the medians, with a confidence of 95 %; 0 within: not told apart\n" +
            differences;
  }
  for (const MethodRuns& method : methods) {
    if (method.has_stages) text += StagesLine(*this, method);
  }
  std::snprintf(line, sizeof line,
                "fused pass, one thread, ms: %.3f; robust %.3f, with depth %.3f\n",
                fused_pass.photometric_ms, fused_pass.robust_ms, fused_pass.robust_depth_ms);
  text += line;
  text += "refinement alone, on " + backend + ", for each pair:\n";
  for (const auto& [name, figures] : refinements) {
    text += dense::FiguresText(name, figures, ceilings);
  }
  return text;
}

}  // namespace silt::experiments
