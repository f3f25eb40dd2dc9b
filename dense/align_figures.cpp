// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/dense/align_figures.h"

#include <algorithm>

#include "silt/core/formatted.h"

namespace silt::dense {
namespace {

void AddKnown(const char* key, double value, JsonText* json) {
  value > 0 ? json->Add(key, value) : json->AddNull(key);
}

double Share(double reached, double ceiling) { return ceiling > 0 ? reached / ceiling : 0; }

}  // namespace

double FloorMilliseconds(const Work& work, const Ceilings& ceilings) {
  if (ceilings.bytes_per_s <= 0 || ceilings.operations_per_s <= 0) return 0;
  return 1000 *
         std::max(work.bytes / ceilings.bytes_per_s, work.operations / ceilings.operations_per_s);
}

JsonText FiguresJson(const AlignFigures& figures, const Ceilings& ceilings) {
  JsonText json;
  const double bytes_per_s = figures.work.bytes * figures.PerSecond();
  const double operations_per_s = figures.work.operations * figures.PerSecond();
  json.Add("alignments", figures.alignments).Add("ok", figures.ok);
  AddKnown("device_ms", figures.device_ms, &json);
  json.Add("wall_ms", figures.wall_ms)
      .Add("per_s", figures.PerSecond())
      .Add("floor_passes", figures.work.passes)
      .Add("floor_bytes", figures.work.bytes)
      .Add("floor_operations", figures.work.operations)
      .Add("bytes_per_s", bytes_per_s)
      .Add("operations_per_s", operations_per_s);
  AddKnown("floor_ms", FloorMilliseconds(figures.work, ceilings), &json);
  AddKnown("share_of_bytes_ceiling", Share(bytes_per_s, ceilings.bytes_per_s), &json);
  AddKnown("share_of_operations_ceiling", Share(operations_per_s, ceilings.operations_per_s),
           &json);
  return json;
}

std::string FiguresText(const std::string& name, const AlignFigures& figures,
                        const Ceilings& ceilings) {
  const Work& work = figures.work;
  std::string text = Formatted("%-12s ", name.c_str());
  if (figures.device_ms > 0) {
    text += Formatted("%.4g ms by the device's clock (%.4g ms by the host's)", figures.device_ms,
                      figures.wall_ms);
  } else {
    text += Formatted("%.4g ms by the host's clock", figures.wall_ms);
  }
  text +=
      Formatted(", %.5g per s; %d of %d ok\n", figures.PerSecond(), figures.ok, figures.alignments);
  text += Formatted("%-12s floor of each: %.3g bytes, %.3g operations; %.3g GB/s, %.3g GFLOP/s", "",
                    work.bytes, work.operations, 1e-9 * work.bytes * figures.PerSecond(),
                    1e-9 * work.operations * figures.PerSecond());
  if (const double floor_ms = FloorMilliseconds(work, ceilings); floor_ms > 0) {
    text += Formatted(", %.2g %% and %.2g %% of the device's %.4g and %.5g; no less than %.3g ms",
                      100 * Share(work.bytes * figures.PerSecond(), ceilings.bytes_per_s),
                      100 * Share(work.operations * figures.PerSecond(), ceilings.operations_per_s),
                      1e-9 * ceilings.bytes_per_s, 1e-9 * ceilings.operations_per_s, floor_ms);
  }
  return text + "\n";
}

}  // namespace silt::dense
