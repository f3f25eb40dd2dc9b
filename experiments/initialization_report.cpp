// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/initialization_report.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "silt/experiments/success_rate.h"

namespace silt::experiments {
namespace {

using Group = std::pair<std::string, int>;  // condition and gap

std::vector<Group> Groups(const std::vector<InitializationRecord>& records) {
  std::vector<Group> groups;
  for (const InitializationRecord& record : records) {
    const Group group{record.condition, record.gap};
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  return groups;
}

std::vector<StartOutcome> OutcomesOf(const std::vector<InitializationRecord>& records,
                                     const Group& group) {
  std::vector<StartOutcome> outcomes;
  for (const InitializationRecord& record : records) {
    if (Group{record.condition, record.gap} != group) continue;
    outcomes.insert(outcomes.end(), record.outcomes.begin(), record.outcomes.end());
  }
  return outcomes;
}

Json SummaryRow(const Group& group, const StartSummary& s) {
  const Interval interval = WilsonInterval(s.successes, s.cases);
  return {{"condition", group.first},
          {"gap", group.second},
          {"method", Name(s.method)},
          {"cases", s.cases},
          {"available", s.available},
          {"successes", s.successes},
          {"rate", s.cases > 0 ? double(s.successes) / s.cases : 0},
          {"rate_low", interval.low},
          {"rate_high", interval.high},
          {"start_distance_m", s.start.distance_m},
          {"start_angle_deg", s.start.angle_deg},
          {"end_distance_m", s.end.distance_m},
          {"end_angle_deg", s.end.angle_deg},
          {"inliers", s.inliers},
          {"milliseconds", s.milliseconds}};
}

}  // namespace

Json CaseRows(const std::vector<InitializationRecord>& records) {
  Json rows = Json::array();
  for (const InitializationRecord& record : records) {
    for (const StartOutcome& o : record.outcomes) {
      const auto known = [&](double value) { return o.available ? Json(value) : Json(); };
      rows.push_back({{"condition", record.condition},
                      {"gap", record.gap},
                      {"keyframe_time_s", record.keyframe_time_s},
                      {"method", Name(o.method)},
                      {"available", o.available},
                      {"success", o.success},
                      {"start_distance_m", known(o.start.distance_m)},
                      {"start_angle_deg", known(o.start.angle_deg)},
                      {"end_distance_m", known(o.end.distance_m)},
                      {"end_angle_deg", known(o.end.angle_deg)},
                      {"matches", o.matches},
                      {"inliers", o.inliers},
                      {"milliseconds", o.milliseconds}});
    }
  }
  return rows;
}

Json SummaryRows(const std::vector<InitializationRecord>& records) {
  Json rows = Json::array();
  for (const Group& group : Groups(records)) {
    const std::vector<StartOutcome> outcomes = OutcomesOf(records, group);
    for (const StartMethod method : kStartMethods) {
      rows.push_back(SummaryRow(group, Summarize(method, outcomes)));
    }
  }
  return rows;
}

std::string FormatInitialization(const Json& summary_rows) {
  std::string text =
      "condition  gap  method          success   start: cm    deg   refined: mm    deg"
      "  inliers     ms\n";
  for (const Json& row : summary_rows) {
    char line[200];
    std::snprintf(
        line, sizeof line, "%-9s %4d  %-13s %3d of %-3d %10.2f %6.2f %13.2f %6.3f %8.0f %6.1f\n",
        row.at("condition").get<std::string>().c_str(), row.at("gap").get<int>(),
        row.at("method").get<std::string>().c_str(), row.at("successes").get<int>(),
        row.at("cases").get<int>(), 100 * row.at("start_distance_m").get<double>(),
        row.at("start_angle_deg").get<double>(), 1000 * row.at("end_distance_m").get<double>(),
        row.at("end_angle_deg").get<double>(), row.at("inliers").get<double>(),
        row.at("milliseconds").get<double>());
    text += line;
  }
  return text;
}

}  // namespace silt::experiments
