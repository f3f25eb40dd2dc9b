// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/trajectory_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "silt/core/error.h"
#include "silt/sim/band_matrix.h"
#include "silt/sim/spline_basis.h"

namespace silt::sim {
namespace {

constexpr double kMostKnots = 1'000'000;

// A linear combination of up to three or four neighbouring controls.
struct Combination {
  int first = 0;
  std::array<double, 4> weight{};
};

class SplineFitter {
 public:
  SplineFitter(const Trajectory& measured, const SmoothingOptions& options)
      : measured_(measured), normal_(0) {
    const double duration_s = measured.back().time_s;
    const double steps = std::max(1.0, std::round(duration_s / options.knot_spacing_s));
    if (!(steps <= kMostKnots)) throw Error("too many knots: raise knot_spacing_s");
    knots_ = int(steps) + 1;
    spacing_s_ = duration_s / steps;
    pose_weight_ = duration_s / double(measured.size() - 1);
    bend_weight_ = std::pow(options.smoothing_s, 4) / std::pow(spacing_s_, 3);
    for (const StampedPose& pose : measured) combinations_.push_back(WeightsAt(pose.time_s));
    normal_ = NormalMatrix();
  }

  PoseSpline Fit() {
    Trajectory controls = FirstControls();
    for (int step = 0; step < 100; ++step) {
      std::vector<Twistd> correction = Gradient(controls);
      normal_.Solve(correction);
      double largest = 0;
      for (std::size_t i = 0; i < controls.size(); ++i) {
        SE3d& control = controls[i].world_from_camera;
        control.rotation = (Quaterniond::Exp(correction[i].omega) * control.rotation).Normalized();
        control.translation += correction[i].v;
        largest = std::max({largest, Norm(correction[i].omega), Norm(correction[i].v)});
      }
      if (largest < 1e-10) return PoseSpline::WithControls(controls);
    }
    throw Error(
        "no smooth motion fits the trajectory: it turns too far between knots; lower "
        "knot_spacing_s");
  }

 private:
  // The weights of the controls in the pose at a time. Those beyond the ends are mirror images:
  // P₋₁ = 2P₀ − P₁.
  Combination WeightsAt(double time_s) const {
    const int segment = std::clamp(int(time_s / spacing_s_), 0, knots_ - 2);
    const double u = time_s / spacing_s_ - segment;
    const double even[6] = {-2, -1, 0, 1, 2, 3};
    const CumulativeBasis basis = MakeCumulativeBasis(even);
    const double lambda[5] = {1, basis.Lambda(1, u), basis.Lambda(2, u), basis.Lambda(3, u), 0};
    Combination c;
    c.first = std::clamp(segment - 1, 0, std::max(0, knots_ - 4));
    const auto add = [&](int control, double weight) {
      if (control < 0 || control >= knots_) {
        const int end = control < 0 ? 0 : knots_ - 1, inner = control < 0 ? 1 : knots_ - 2;
        c.weight[std::size_t(end - c.first)] += 2 * weight;
        c.weight[std::size_t(inner - c.first)] -= weight;
      } else {
        c.weight[std::size_t(control - c.first)] += weight;
      }
    };
    for (int j = 0; j < 4; ++j) add(segment - 1 + j, lambda[j] - lambda[j + 1]);
    return c;
  }

  static Combination Bend(int middle) { return {middle - 1, {1, -2, 1, 0}}; }

  void Accumulate(BandMatrix& matrix, const Combination& c, double factor) const {
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b <= a; ++b) {
        if (c.first + a >= knots_) continue;
        matrix.At(c.first + a, c.first + b) +=
            factor * c.weight[std::size_t(a)] * c.weight[std::size_t(b)];
      }
    }
  }

  BandMatrix NormalMatrix() const {
    BandMatrix matrix(knots_);
    for (const Combination& c : combinations_) Accumulate(matrix, c, pose_weight_);
    for (int i = 1; i + 1 < knots_; ++i) Accumulate(matrix, Bend(i), bend_weight_);
    matrix.Factorize();
    return matrix;
  }

  // The measured pose nearest in time to each knot.
  Trajectory FirstControls() const {
    Trajectory controls;
    std::size_t nearest = 0;
    for (int i = 0; i < knots_; ++i) {
      const double time_s = i * spacing_s_;
      const auto distance = [&](std::size_t k) { return std::abs(measured_[k].time_s - time_s); };
      while (nearest + 1 < measured_.size() && distance(nearest + 1) <= distance(nearest)) {
        ++nearest;
      }
      controls.push_back({time_s, measured_[nearest].world_from_camera});
    }
    return controls;
  }

  // Half the negative gradient of the cost by left, world-side changes of the controls.
  std::vector<Twistd> Gradient(const Trajectory& controls) const {
    std::vector<Twistd> gradient(controls.size());
    const auto add = [&](const Combination& c, double factor, const Twistd& r) {
      for (int j = 0; j < 4 && c.first + j < knots_; ++j) {
        const double f = factor * c.weight[std::size_t(j)];
        Twistd& g = gradient[std::size_t(c.first + j)];
        g = {g.omega + f * r.omega, g.v + f * r.v};
      }
    };
    const PoseSpline spline = PoseSpline::WithControls(controls);
    for (std::size_t k = 0; k < measured_.size(); ++k) {
      const SE3d pose = spline.At(measured_[k].time_s);
      add(combinations_[k], pose_weight_, WorldDifference(pose, measured_[k].world_from_camera));
    }
    for (int i = 1; i + 1 < knots_; ++i) {
      const SE3d& middle = controls[std::size_t(i)].world_from_camera;
      const Twistd back = WorldDifference(middle, controls[std::size_t(i - 1)].world_from_camera);
      const Twistd on = WorldDifference(middle, controls[std::size_t(i + 1)].world_from_camera);
      add(Bend(i), -bend_weight_, {back.omega + on.omega, back.v + on.v});
    }
    return gradient;
  }

  static Twistd WorldDifference(const SE3d& from, const SE3d& to) {
    return {(to.rotation * from.rotation.Conjugate()).Log(), to.translation - from.translation};
  }

  const Trajectory& measured_;
  int knots_ = 0;
  double spacing_s_ = 0, pose_weight_ = 0, bend_weight_ = 0;
  std::vector<Combination> combinations_;  // one for each pose
  BandMatrix normal_;
};

Trajectory FromZero(const Trajectory& measured, double max_gap_s) {
  Trajectory shifted = measured;
  for (StampedPose& pose : shifted) pose.time_s -= measured.front().time_s;
  for (std::size_t i = 1; i < shifted.size(); ++i) {
    const double gap_s = shifted[i].time_s - shifted[i - 1].time_s;
    if (gap_s <= max_gap_s) continue;
    throw Error("the trajectory has no pose for " + std::to_string(gap_s) + " s after " +
                std::to_string(measured[i - 1].time_s) + " s: raise max_gap_s to bridge that");
  }
  return shifted;
}

FitResiduals ResidualsOf(const PoseSpline& spline, const Trajectory& measured) {
  FitResiduals r;
  r.poses = int(measured.size());
  for (const StampedPose& pose : measured) {
    const SE3d fitted = spline.At(pose.time_s);
    const double m = Norm(fitted.translation - pose.world_from_camera.translation);
    const double deg = 180 / std::numbers::pi *
                       RotationAngle(fitted.rotation.Conjugate() * pose.world_from_camera.rotation);
    r.rms_m += m * m / r.poses;
    r.rms_deg += deg * deg / r.poses;
    r.max_m = std::max(r.max_m, m);
    r.max_deg = std::max(r.max_deg, deg);
  }
  r.rms_m = std::sqrt(r.rms_m);
  r.rms_deg = std::sqrt(r.rms_deg);
  return r;
}

}  // namespace

void SmoothingOptions::Validate() const {
  const auto require = [](const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return;
    throw Error(std::string(name) + " = " + std::to_string(value) + " must be in " +
                std::to_string(low) + " … " + std::to_string(high));
  };
  require("knot_spacing_s", knot_spacing_s, 0.001, 10);
  require("smoothing_s", smoothing_s, 0.001, 10);
  require("max_gap_s", max_gap_s, 0.001, 1000);
}

SmoothedTrajectory SmoothTrajectory(const Trajectory& measured, const SmoothingOptions& options) {
  options.Validate();
  if (measured.size() < 2) throw Error("a trajectory of fewer than two poses has no motion");
  const Trajectory shifted = FromZero(measured, options.max_gap_s);
  const PoseSpline spline = SplineFitter(shifted, options).Fit();
  return {spline, ResidualsOf(spline, shifted)};
}

}  // namespace silt::sim
