// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/initializer_choice.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "silt/core/error.h"
#include "silt/experiments/success_rate.h"
#include "silt/tracker/coarse_initializer.h"
#include "silt/tracker/cpu_backend.h"
#include "silt/tracker/sparse/sparse_initializer.h"

namespace silt::experiments {
namespace {

struct NamedFeature {
  const char* name;
  tracker::FeatureKind kind;
};
constexpr NamedFeature kFeatures[] = {{"surf", tracker::FeatureKind::kSurf},
                                      {"sift", tracker::FeatureKind::kSift},
                                      {"orb", tracker::FeatureKind::kOrb},
                                      {"akaze", tracker::FeatureKind::kAkaze}};

[[noreturn]] void Unreadable(const std::string& text) {
  throw Error("--init '" + text + "': write truth, or truth:0.02m,1deg for a perturbed one");
}

// The number before the unit; all of the text must be that.
double Quantity(const std::string& text, const std::string& unit, const std::string& whole) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const bool good = error == std::errc() && std::string(rest, end) == unit;
  if (!good || !std::isfinite(value) || value < 0) Unreadable(whole);
  return value;
}

}  // namespace

std::vector<std::string> InitializerNames() {
  return {"auto", "identity", "previous", "constant-velocity", "rotation", "surf", "sift",
          "orb",  "akaze",    "truth"};
}

InitializerChoice ParseInitializer(const std::string& text) {
  if (text == "sparse") return {};  // what "auto" was called before there were others
  const std::size_t colon = text.find(':');
  InitializerChoice choice{text.substr(0, colon), {}};
  const std::vector<std::string> names = InitializerNames();
  if (std::find(names.begin(), names.end(), choice.kind) == names.end()) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw Error("no initializer is named '" + choice.kind + "'; there are: " + list);
  }
  if (colon == std::string::npos) return choice;
  const std::string amounts = text.substr(colon + 1);
  const std::size_t comma = amounts.find(',');
  if (!choice.uses_truth() || comma == std::string::npos) Unreadable(text);
  choice.perturbation = {Quantity(amounts.substr(0, comma), "m", text),
                         Quantity(amounts.substr(comma + 1), "deg", text)};
  return choice;
}

std::unique_ptr<tracker::Initializer> MakeInitializer(
    const InitializerChoice& choice, const tracker::TrackerOptions& preset,
    std::shared_ptr<const tracker::Backend> backend) {
  if (!backend) backend = tracker::MakeCpuBackend();
  if (choice.kind == "auto") {
    auto surf = std::make_unique<tracker::SparseInitializer>();
    if (preset.always_initialize) return surf;
    return std::make_unique<tracker::CoarseInitializer>(std::move(backend), tracker::WideStart(),
                                                        std::move(surf));
  }
  for (const NamedFeature& feature : kFeatures) {
    if (choice.kind != feature.name) continue;
    return std::make_unique<tracker::SparseInitializer>(tracker::OptionsFor(feature.kind));
  }
  if (choice.kind != "rotation") return nullptr;
  return std::make_unique<tracker::CoarseInitializer>(std::move(backend), tracker::TurnAlone());
}

tracker::TrackerOptions WithInitializer(const tracker::TrackerOptions& preset,
                                        const InitializerChoice& choice) {
  tracker::TrackerOptions options = preset;
  if (choice.kind == "auto") return options;
  options.always_initialize = true;
  if (choice.kind == "identity") options.start = tracker::Start::kKeyframe;
  if (choice.kind == "previous") options.start = tracker::Start::kPrevious;
  if (choice.kind == "constant-velocity") options.start = tracker::Start::kConstantVelocity;
  return options;
}

SE3d PerturbedTruth(const SE3d& world_from_camera, const PoseDifference& perturbation,
                    std::uint64_t seed, int frame_index) {
  return RandomStart(world_from_camera.Inverse(), perturbation, seed, frame_index).Inverse();
}

}  // namespace silt::experiments
