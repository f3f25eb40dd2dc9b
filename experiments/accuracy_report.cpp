// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/accuracy_report.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "silt/experiments/base64.h"
#include "silt/experiments/comparison_table.h"

namespace silt::experiments {
namespace {

namespace fs = std::filesystem;

const char* const kStyle = R"(<style>
:root { color-scheme: light; --ink: #1c2430; --soft: #5b6675; --line: #d9dee5; --tint: #f4f6f8; }
body { font: 16px/1.5 system-ui, "Helvetica Neue", Arial, sans-serif; color: var(--ink);
  max-width: 1080px; margin: 2.5rem auto; padding: 0 1.5rem; background: #fff; }
h1 { font-size: 1.9rem; margin: 0 0 .3rem; } h2 { font-size: 1.25rem; margin: 2.6rem 0 .6rem; }
p.lead { color: var(--soft); margin-top: 0; max-width: 46rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; margin: 1.2rem 0; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: .3rem 0; }
th, td { padding: .25rem .8rem; text-align: right; white-space: nowrap; }
thead th { font-weight: 500; color: var(--soft); border-bottom: 1px solid var(--line); }
thead th.group { color: var(--ink); text-align: center; border-bottom: none; font-weight: 600; }
tbody th { text-align: left; font-weight: 400; padding-left: 0; }
tbody tr { border-bottom: 1px solid var(--line); }
td.paper { color: var(--soft); background: var(--tint); }
figure { margin: 1.4rem 0; } figure img { max-width: 100%; height: auto; display: block; }
figcaption { color: var(--soft); font-size: .9rem; margin-top: .4rem; max-width: 50rem; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; }
code, pre { font: .86rem/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, monospace; }
pre { background: var(--tint); padding: 1rem; overflow-x: auto; white-space: pre-wrap;
  overflow-wrap: anywhere; border-radius: 6px; }
summary { cursor: pointer; }
</style>
)";

std::string ReadBytes(const fs::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

// Nothing where the file is not there: figures need matplotlib.
std::string Figure(const fs::path& file, const std::string& caption) {
  const std::string bytes = ReadBytes(file);
  if (bytes.empty()) return "";
  const char* const type = file.extension() == ".svg" ? "image/svg+xml" : "image/png";
  return "<figure><img alt=\"" + EscapeHtml(caption) + "\" src=\"data:" + type + ";base64," +
         Base64(bytes) + "\"><figcaption>" + EscapeHtml(caption) + "</figcaption></figure>\n";
}

std::string Lead(const AccuracyResult& result, const Json& manifest) {
  const AccuracyRun& run = result.runs.front();
  const double from_s = run.truth.front().time_s, to_s = run.truth.back().time_s;
  char text[400];
  std::snprintf(text, sizeof text,
                "Scene %s, path %s, %.2f s to %.2f s: %.2f m of %.2f m. Position errors: the first "
                "poses are made equal and nothing else is aligned, as in the paper; it tracked the "
                "whole 6.93 m of its own path.",
                result.world.scene->scene().name.c_str(), result.world.path_file.stem().c_str(),
                from_s, to_s, PathLength(run.truth), result.world.path.LengthM());
  return "<h1>Accuracy of the tracked camera</h1>\n<p class=\"lead\">" + EscapeHtml(text) +
         "</p>\n<p>Made by <code>" + EscapeHtml(manifest["command"].get<std::string>()) +
         "</code></p>\n";
}

std::string Pictures(const fs::path& folder) {
  const fs::path frames = folder / "frames";
  return "<h2>What the tracker is given</h2>\n<div class=\"pair\">\n" +
         Figure(frames / "60fps.png", "Sharp and noise-free: 20fps and 60fps") +
         Figure(frames / "60fps-depth.png", "Its depth, near bright; keyframes alone use it") +
         Figure(frames / "60fps-blur.png",
                "60fps-blur: the shutter open for the whole 1/60 s, Handa's noise") +
         "</div>\n";
}

std::string Figures(const fs::path& folder) {
  const fs::path figures = folder / "figures";
  return Figure(figures / "position_error.svg",
                "Error of the position over time, keyframes as points (the paper's Fig. 6a).") +
         Figure(figures / "orientation_error_60fps.svg",
                "Error of the orientation about the camera's axes, 60fps (Fig. 6b).") +
         Figure(figures / "orientation_error_60fps-blur.svg",
                "The same with blur and noise (Fig. 6c).") +
         Figure(figures / "orientation_error_20fps.svg", "The same at 20 fps.") +
         Figure(figures / "trajectory_60fps.svg",
                "True and estimated positions with the keyframes, 60fps, from above and from the "
                "side (Fig. 5a).") +
         Figure(figures / "turns_60fps.svg", "The camera's true turns since the start (Fig. 5b).");
}

}  // namespace

std::string AccuracyReport(const fs::path& folder, const AccuracyResult& result,
                           const Json& manifest) {
  std::string html =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>silt: accuracy</title>\n";
  html += kStyle;
  html += "</head><body>\n" + Lead(result, manifest);
  html += "<h2>Beside the paper</h2>\n";
  for (const ComparisonTable& table : ComparisonTables(result.runs)) {
    html += "<div class=\"wide\">" + FormatHtml(table) + "</div>\n";
  }
  const std::string figures = Figures(folder);
  if (!figures.empty()) html += "<h2>Over time</h2>\n" + figures;
  html += Pictures(folder);
  html += "<h2>How it was made</h2>\n<details open><summary>Manifest</summary><pre>" +
          EscapeHtml(manifest.dump(2)) + "</pre></details>\n</body></html>\n";
  return html;
}

}  // namespace silt::experiments
