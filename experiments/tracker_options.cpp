// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/tracker_options.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>
#include <type_traits>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

// Shows every option to `visit(group, name, value)`: the one list of them that there is.
template <typename Options, typename Visitor>
void VisitOptions(Options& o, const Visitor& visit) {
  auto& a = o.alignment;
  visit("alignment", "max_iterations", a.max_iterations);
  visit("alignment", "initial_damping", a.initial_damping);
  visit("alignment", "damping_factor", a.damping_factor);
  visit("alignment", "min_update_norm", a.min_update_norm);
  visit("alignment", "coarser_update_norm", a.coarser_update_norm);
  visit("alignment", "take_last_step", a.take_last_step);
  visit("alignment", "scaled_damping", a.scaled_damping);
  visit("alignment", "min_overlap", a.min_overlap);
  visit("alignment", "exclude_hidden", a.exclude_hidden);
  visit("alignment", "use_current_depth", a.use_current_depth);
  visit("alignment", "depth_edge_margin_px", a.depth_edge_margin_px);
  visit("alignment", "robust_loss", a.robust_loss);
  visit("alignment", "robust_scale", a.robust_scale);
  visit("alignment", "robust_gradient", a.robust_gradient);
  visit("alignment", "scale_rounds", a.scale_rounds);
  visit("alignment", "depth_residual", a.depth_residual);
  visit("alignment", "interpolant", a.interpolant);
  visit("alignment", "reference_gradient", a.reference_gradient);
  visit("alignment", "affine_brightness", a.affine_brightness);
  visit("alignment", "depth_patch_px", a.depth_patch_px);
  visit("alignment", "max_disagreement", a.max_disagreement);
  visit("alignment", "registered_contrast", a.registered_contrast);
  visit("alignment", "rotation_only", a.rotation_only);
  visit("alignment", "covariance_factor", a.covariance_factor);
  auto& k = o.keyframes;
  visit("keyframes", "max_distance_m", k.max_distance_m);
  visit("keyframes", "max_rotation_deg", k.max_rotation_deg);
  visit("keyframes", "min_measured_depth", k.min_measured_depth);
  visit("keyframes", "metres_per_radian", k.metres_per_radian);
  visit("keyframes", "joint", k.joint);
  visit("keyframes", "trusted_only", k.trusted_only);
  visit("keyframes", "min_keyframe_overlap", k.min_overlap);
  visit("keyframes", "stale_share", k.stale_share);
  visit("keyframes", "polish_iterations", k.polish_iterations);
  auto& t = o.trust;
  visit("trust", "max_unexplained_variance", t.max_unexplained_variance);
  visit("trust", "max_depth_disagreement", t.max_depth_disagreement);
  visit("trust", "min_inlier_ratio", t.min_inlier_ratio);
  visit("trust", "max_uncertainty_rad", t.max_uncertainty_rad);
  visit("trust", "doubtful_unexplained_variance", t.doubtful_unexplained_variance);
  visit("trust", "doubtful_depth_disagreement", t.doubtful_depth_disagreement);
  visit("trust", "doubtful_inlier_ratio", t.doubtful_inlier_ratio);
  visit("trust", "doubtful_overlap", t.doubtful_overlap);
  visit("trust", "doubtful_uncertainty_rad", t.doubtful_uncertainty_rad);
  visit("", "always_initialize", o.always_initialize);
  visit("", "start", o.start);
  visit("", "relocalization_candidates", o.relocalization_candidates);
}

// The values of an option that have names.
template <typename T>
struct Named {
  const char* name;
  T value;
};
constexpr Named<tracker::Start> kStarts[] = {
    {"keyframe", tracker::Start::kKeyframe},
    {"previous", tracker::Start::kPrevious},
    {"constant-velocity", tracker::Start::kConstantVelocity}};
constexpr Named<tracker::Interpolant> kInterpolants[] = {
    {"bilinear", tracker::Interpolant::kBilinear},
    {"catmull-rom", tracker::Interpolant::kCatmullRom},
    {"b-spline", tracker::Interpolant::kBSpline}};
constexpr Named<tracker::RobustLoss> kLosses[] = {
    {"geman-mcclure", tracker::RobustLoss::kGemanMcClure},
    {"huber", tracker::RobustLoss::kHuber},
    {"tukey", tracker::RobustLoss::kTukey},
    {"student-t", tracker::RobustLoss::kStudentT}};

constexpr const auto& NamesOf(tracker::Start) { return kStarts; }
constexpr const auto& NamesOf(tracker::Interpolant) { return kInterpolants; }
constexpr const auto& NamesOf(tracker::RobustLoss) { return kLosses; }

template <typename T>
bool ParseNumber(const std::string& text, T& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

bool Parse(const std::string& text, double& value) { return ParseNumber(text, value); }
bool Parse(const std::string& text, int& value) { return ParseNumber(text, value); }
bool Parse(const std::string& text, bool& value) {
  value = text == "1";
  return value || text == "0";
}
template <typename T, typename = std::enable_if_t<std::is_enum_v<T>>>
bool Parse(const std::string& text, T& value) {
  for (const auto& known : NamesOf(value)) {
    if (text != known.name) continue;
    value = known.value;
    return true;
  }
  return false;
}
bool Parse(const std::string& text, std::vector<int>& value) {
  value.clear();
  std::istringstream entries(text);
  for (std::string entry; std::getline(entries, entry, '-');) {
    if (!ParseNumber(entry, value.emplace_back())) return false;
  }
  return !value.empty();
}

template <typename T>
auto JsonOf(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    const char* name = "";
    for (const auto& known : NamesOf(value)) {
      if (value == known.value) name = known.name;
    }
    return name;
  } else {
    return value;
  }
}

void Change(tracker::TrackerOptions& options, const std::string& change,
            const std::string& preset) {
  const std::size_t equals = change.find('=');
  const std::string name = change.substr(0, equals);
  std::string known;
  bool found = false;
  VisitOptions(options, [&](const char*, const char* option, auto& value) {
    known += (known.empty() ? "" : ", ") + std::string(option);
    if (option != name) return;
    found = true;
    if (equals == std::string::npos || !Parse(change.substr(equals + 1), value)) {
      throw Error("preset " + Quoted(preset) + ": " + Quoted(change) +
                  " gives the option no value that it can have");
    }
  });
  if (found) return;
  throw Error("preset " + Quoted(preset) + ": no option is named " + Quoted(name) +
              "; there are: " + known);
}

tracker::TrackerOptions Unchanged(const std::string& preset) {
  if (preset == "paper") return tracker::PaperPreset();
  if (preset == "paper-all-pixels") return tracker::PaperAllPixelsPreset();
  if (preset == "accurate") return tracker::AccuratePreset();
  if (preset == "fast") return tracker::FastPreset();
  std::string known;
  for (const std::string& one : PresetNames()) known += (known.empty() ? "" : ", ") + one;
  throw Error("no preset is named " + Quoted(preset) + "; there are: " + known);
}

}  // namespace

std::vector<std::string> PresetNames() { return {"paper", "paper-all-pixels", "accurate", "fast"}; }

tracker::TrackerOptions PresetOptions(const std::string& preset) {
  std::istringstream parts(preset);
  std::string part;
  std::getline(parts, part, ':');
  tracker::TrackerOptions options = Unchanged(part);
  while (std::getline(parts, part, ':')) Change(options, part, preset);
  options.Validate();
  return options;
}

Json ToJson(const tracker::TrackerOptions& options) {
  Json json;
  VisitOptions(options, [&](const std::string& group, const char* name, const auto& value) {
    (group.empty() ? json : json[group])[name] = JsonOf(value);
  });
  return json;
}

}  // namespace silt::experiments
