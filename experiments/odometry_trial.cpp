// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/odometry_trial.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "silt/core/formatted.h"
#include "silt/core/pyramid.h"
#include "silt/core/random.h"
#include "silt/experiments/interrupt.h"
#include "silt/experiments/tracker_setup.h"

namespace silt::experiments {
namespace {

// Uniform in the cube, then made as long as drawn: as OpenCV does it, whose directions favour the
// cube's corners a little.
Vec3d RandomVector(const CounterRandom& random, std::uint64_t first, double least,
                   double greatest) {
  Vec3d v{2 * random.Uniform(first) - 1, 2 * random.Uniform(first + 1) - 1,
          2 * random.Uniform(first + 2) - 1};
  const double length = least + (greatest - least) * random.Uniform(first + 3);
  return (length / std::max(Norm(v), 1e-12)) * v;
}

// The least and the greatest of what is there.
struct Range {
  float low = std::numeric_limits<float>::infinity(), high = 0;
  void Add(float value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  float Middle() const { return 0.5f * (low + high); }
};

// Of a hole with points around it.
void FillHole(const Frame& warped, int x, int y, Frame* filled) {
  Range depth, red, green, blue;
  for (int v = std::max(0, y - 1); v <= std::min(warped.depth_m.height() - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(warped.depth_m.width() - 1, x + 1); ++u) {
      if (!IsMeasured(warped.depth_m(u, v))) continue;
      depth.Add(warped.depth_m(u, v));
      const Rgb8& colour = warped.rgb(u, v);
      red.Add(colour.r);
      green.Add(colour.g);
      blue.Add(colour.b);
    }
  }
  if (depth.high == 0) return;
  filled->depth_m(x, y) = depth.Middle();
  filled->rgb(x, y) = {std::uint8_t(red.Middle()), std::uint8_t(green.Middle()),
                       std::uint8_t(blue.Middle())};
}

}  // namespace

SE3d TrialMotion(std::uint64_t seed, int index) {
  const CounterRandom random(seed, std::uint64_t(index));
  return {Quaterniond::Exp(RandomVector(random, 0, kTrialMinTurn_rad, kTrialMaxTurn_rad)),
          RandomVector(random, 4, kTrialMinShift_m, kTrialMaxShift_m)};
}

Frame ForwardWarp(const Frame& frame, const PinholeCamera& camera, const SE3d& current_from_frame) {
  Frame warped{frame.time_s, Image<Rgb8>(camera.width, camera.height),
               Image<float>(camera.width, camera.height)};
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (!IsMeasured(frame.depth_m(x, y))) continue;
      const Vec3d p = current_from_frame * camera.Unproject(x, y, double(frame.depth_m(x, y)));
      if (!(p.z > 0)) continue;
      const Vec2d at = camera.Project(p);
      const double u = std::round(at.x), v = std::round(at.y);
      if (!(u >= 0 && v >= 0 && u < camera.width && v < camera.height)) continue;
      float& depth = warped.depth_m(int(u), int(v));
      if (depth > 0 && double(depth) <= p.z) continue;
      depth = float(p.z);
      warped.rgb(int(u), int(v)) = frame.rgb(x, y);
    }
  }
  Frame filled = warped;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      if (!IsMeasured(warped.depth_m(x, y))) FillHole(warped, x, y, &filled);
    }
  }
  return filled;
}

int OdometryTrial::BelowMotion() const {
  return int(std::count_if(errors.begin(), errors.end(), [](const TrialError& e) {
    return e.error_rad < e.motion_rad && e.error_m < e.motion_m;
  }));
}

int OdometryTrial::Below(double rad, double m) const {
  return int(std::count_if(errors.begin(), errors.end(), [&](const TrialError& e) {
    return e.error_rad < rad && e.error_m < m;
  }));
}

TrialError OdometryTrial::Worst() const {
  TrialError worst;
  for (const TrialError& e : errors) {
    worst.motion_rad = std::max(worst.motion_rad, e.motion_rad);
    worst.motion_m = std::max(worst.motion_m, e.motion_m);
    worst.error_rad = std::max(worst.error_rad, e.error_rad);
    worst.error_m = std::max(worst.error_m, e.error_m);
  }
  return worst;
}

OdometryTrial RunTrial(const Frame& frame, const PinholeCamera& camera, const MovedFrame& moved,
                       const std::string& preset, int count, std::uint64_t seed) {
  OdometryTrial trial{preset, "", {}};
  for (int i = 0; i < count; ++i) {
    ThrowIfInterrupted();
    const SE3d truth = TrialMotion(seed, i);
    tracker::KeyframeTracker tracker = MakeTracker(camera, {preset, "cpu", "auto", seed}, SE3d{});
    tracker.Track(frame);
    const SE3d found = tracker.Track(moved(truth), SE3d{}).world_from_camera.Inverse();
    trial.errors.push_back({RotationAngle(truth.rotation), Norm(truth.translation),
                            RotationAngle(truth.rotation.Conjugate() * found.rotation),
                            Norm(truth.translation - found.translation)});
  }
  return trial;
}

Json TrialRows(const std::vector<OdometryTrial>& trials) {
  Json rows = Json::array();
  for (const OdometryTrial& trial : trials) {
    const TrialError worst = trial.Worst();
    rows.push_back({{"preset", trial.preset},
                    {"current", trial.current},
                    {"motions", trial.errors.size()},
                    {"below_motion", trial.BelowMotion()},
                    {"below_4e-3", trial.Below(4e-3, 4e-3)},
                    {"below_1e-4", trial.Below(1e-4, 1e-4)},
                    {"worst_rad", worst.error_rad},
                    {"worst_m", worst.error_m}});
  }
  return rows;
}

std::string FormatTrials(const std::vector<OdometryTrial>& trials) {
  std::string text =
      "The test of OpenCV's odometries, random motions up to 3 deg and 2 cm of one frame:\n"
      "  preset    current   motions  below motion  < 4e-3  < 1e-4 (rad and m)  worst rad, m\n";
  for (const OdometryTrial& trial : trials) {
    const TrialError worst = trial.Worst();
    text +=
        Formatted("  %-9s %-9s %7zu %13d %7d %7d %23.1e %.1e\n", trial.preset.c_str(),
                  trial.current.c_str(), trial.errors.size(), trial.BelowMotion(),
                  trial.Below(4e-3, 4e-3), trial.Below(1e-4, 1e-4), worst.error_rad, worst.error_m);
  }
  return text;
}

}  // namespace silt::experiments
