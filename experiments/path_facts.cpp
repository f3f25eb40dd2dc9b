// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/path_facts.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

std::string Row(const char* name, const char* format, double a, double b, double c = 0) {
  char text[160];
  const int length = std::snprintf(text, sizeof text, "%-20s", name);
  std::snprintf(text + length, sizeof text - std::size_t(length), format, a, b, c);
  return std::string(text) + "\n";
}

}  // namespace

Json PathFacts(const sim::CameraPath& path, const std::filesystem::path& file) {
  const sim::PathStatistics s = path.Statistics();
  const auto corner = [](const Vec3d& v) { return Json{v.x, v.y, v.z}; };
  Json facts{{"file", file.string()},
             {"duration_s", s.duration_s},
             {"length_m", s.length_m},
             {"mean_speed_m_s", s.mean_speed_m_s},
             {"max_speed_m_s", s.max_speed_m_s},
             {"mean_turn_deg_s", s.mean_turn_deg_s},
             {"max_turn_deg_s", s.max_turn_deg_s},
             {"mean_acceleration_m_s2", s.mean_acceleration_m_s2},
             {"max_acceleration_m_s2", s.max_acceleration_m_s2},
             {"max_turn_acceleration_deg_s2", s.max_turn_acceleration_deg_s2},
             {"lowest", corner(s.lowest)},
             {"highest", corner(s.highest)}};
  if (path.fit()) {
    const sim::FitResiduals& fit = *path.fit();
    facts["replay"] = {{"poses", fit.poses},
                       {"residual_rms_m", fit.rms_m},
                       {"residual_max_m", fit.max_m},
                       {"residual_rms_deg", fit.rms_deg},
                       {"residual_max_deg", fit.max_deg}};
  }
  return facts;
}

std::string FormatPathFacts(const Json& facts) {
  const auto number = [](const Json& from, const char* key) { return from[key].get<double>(); };
  const auto at = [&](const char* key) { return number(facts, key); };
  const auto corner = [&](const char* key, int axis) { return facts[key][axis].get<double>(); };
  std::string text = "path:               " + facts["file"].get<std::string>() + "\n";
  text += Row("length:", "%.3f m in %.3f s", at("length_m"), at("duration_s"));
  text += Row("speed:", "mean %.3f, max %.3f m/s", at("mean_speed_m_s"), at("max_speed_m_s"));
  text +=
      Row("turn rate:", "mean %.1f, max %.1f deg/s", at("mean_turn_deg_s"), at("max_turn_deg_s"));
  text += Row("acceleration:", "mean %.3f, max %.3f m/s2", at("mean_acceleration_m_s2"),
              at("max_acceleration_m_s2"));
  text += Row("turn acceleration:", "max %.1f deg/s2", at("max_turn_acceleration_deg_s2"), 0);
  text += Row("from:", "(%.3f, %.3f, %.3f) m", corner("lowest", 0), corner("lowest", 1),
              corner("lowest", 2));
  text += Row("to:", "(%.3f, %.3f, %.3f) m", corner("highest", 0), corner("highest", 1),
              corner("highest", 2));
  if (facts.contains("replay")) {
    const Json& fit = facts["replay"];
    text += "replay of:          " + fit["poses"].dump() + " poses, the spline off by\n";
    text += Row("", "rms %.2f, max %.2f mm", 1000 * number(fit, "residual_rms_m"),
                1000 * number(fit, "residual_max_m"));
    text += Row("", "rms %.3f, max %.3f deg", number(fit, "residual_rms_deg"),
                number(fit, "residual_max_deg"));
  }
  return text;
}

Json ToJson(const sim::PathCheck& check) {
  Json contacts = Json::array();
  for (const sim::PathContact& c : check.contacts) {
    contacts.push_back({{"instance", c.instance},
                        {"crosses", c.crosses},
                        {"start_s", c.start_s},
                        {"end_s", c.end_s},
                        {"nearest_s", c.nearest_s},
                        {"distance_m", c.distance_m}});
  }
  return {{"step_m", check.step_m}, {"crosses", check.Crosses()}, {"contacts", contacts}};
}

void RequireNoCrossing(const World& world, const Stretch& stretch) {
  const sim::PathCheck check =
      CheckPath(world.path, world.scene->scene(),
                {.clearance_m = 0, .start_s = stretch.start_s, .duration_s = stretch.duration_s});
  if (check.contacts.empty()) return;
  throw Error(world.path_file.string() + ": the camera " + Describe(check.contacts.front()) +
              "; --allow-crossing renders it all the same");
}

}  // namespace silt::experiments
