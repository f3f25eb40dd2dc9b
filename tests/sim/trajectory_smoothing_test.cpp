// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/trajectory_smoothing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "key_poses.h"
#include "silt/sim/camera_path.h"
#include "temp_folder.h"

namespace silt::sim {
namespace {

using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// Samples of a motion, uneven like those of a motion-capture system.
template <typename Motion>
Trajectory Samples(const Motion& pose_at, double duration_s, double step_s, double start_s = 0) {
  const CounterRandom random(4);
  Trajectory samples;
  const int n = int(std::lround(duration_s / step_s));
  for (int i = 0; i <= n; ++i) {
    const double jitter = i > 0 && i < n ? 0.3 * (random.Uniform(std::uint64_t(i)) - 0.5) : 0;
    const double time_s = (i + jitter) * step_s;
    samples.push_back({start_s + time_s, pose_at(time_s)});
  }
  return samples;
}

TEST(TrajectorySmoothing, ReturnsASplineOfItsOwnKind) {
  Trajectory controls = RandomKeys(21, 0.3);
  for (std::size_t i = 0; i < controls.size(); ++i) controls[i].time_s = 0.5 * double(i);
  const PoseSpline truth = PoseSpline::WithControls(controls);
  const Trajectory samples = Samples([&](double t) { return truth.At(t); }, 10, 0.02, 1.3e9);
  const SmoothedTrajectory fit =
      SmoothTrajectory(samples, {.knot_spacing_s = 0.5, .smoothing_s = 0.001});
  EXPECT_EQ(fit.residuals.poses, 501);
  EXPECT_LT(fit.residuals.max_m, 2e-6);
  EXPECT_LT(fit.residuals.max_deg, 2e-4);
  for (double t = 0; t <= 10; t += 0.07) {
    EXPECT_LT(PoseDistance(fit.spline.At(t), truth.At(t)), 3e-6) << t;
  }
}

SE3d Swing(double time_s, double period_s, double amplitude) {
  const double phase = 2 * kPi * time_s / period_s;
  return {Quaterniond::Exp({0, amplitude * std::sin(phase), 0}),
          {amplitude * std::cos(phase), 0.2 * time_s, 1}};
}

// Largest x and largest turn about y in the middle of the fit.
std::pair<double, double> Amplitudes(const PoseSpline& spline, double period_s) {
  std::pair<double, double> largest{0, 0};
  for (double t = 10; t < 10 + 2 * period_s; t += period_s / 200) {
    const SE3d pose = spline.At(t);
    largest.first = std::max(largest.first, std::abs(pose.translation.x));
    largest.second = std::max(largest.second, std::abs(pose.rotation.Log().y));
  }
  return largest;
}

// 1/(1 + (2πfτ)⁴) at periods of 2πτ, twice and half of that.
TEST(TrajectorySmoothing, DampsSwingsAsItsFormulaSays) {
  const double tau_s = 0.1, amplitude = 0.02;
  for (const double times : {0.5, 1.0, 2.0}) {
    const double period_s = times * 2 * kPi * tau_s;
    const Trajectory samples =
        Samples([&](double t) { return Swing(t, period_s, amplitude); }, 20, 0.005);
    const SmoothedTrajectory fit =
        SmoothTrajectory(samples, {.knot_spacing_s = 0.02, .smoothing_s = tau_s});
    const double kept = 1 / (1 + std::pow(1 / times, 4));
    const auto [metres, radians] = Amplitudes(fit.spline, period_s);
    EXPECT_NEAR(metres, kept * amplitude, 0.02 * amplitude) << times;
    EXPECT_NEAR(radians, kept * amplitude, 0.02 * amplitude) << times;
    EXPECT_NEAR(fit.residuals.rms_m, (1 - kept) * amplitude / std::sqrt(2), 0.02 * amplitude);
    EXPECT_NEAR(fit.residuals.rms_deg * kPi / 180, (1 - kept) * amplitude / std::sqrt(2),
                0.02 * amplitude);
  }
}

TEST(TrajectorySmoothing, TakesNoiseAwayAndMeasuresIt) {
  const PoseSpline truth = PoseSpline::Through(RandomKeys(12, 0.4));
  const CounterRandom random(8);
  std::uint64_t draw = 0;
  const auto noise = [&](double sigma) {
    const double x = random.Normal(draw++), y = random.Normal(draw++), z = random.Normal(draw++);
    return sigma * Vec3d{x, y, z};
  };
  const double sigma_m = 2e-3, sigma_rad = 3e-3;
  const Trajectory samples = Samples(
      [&](double t) {
        const SE3d pose = truth.At(t);
        const Quaterniond turn = Quaterniond::Exp(noise(sigma_rad));
        return SE3d{(turn * pose.rotation).Normalized(), pose.translation + noise(sigma_m)};
      },
      truth.end_s(), 0.005);
  const SmoothedTrajectory fit = SmoothTrajectory(samples, {});
  EXPECT_NEAR(fit.residuals.rms_m, std::sqrt(3) * sigma_m, 0.1 * std::sqrt(3) * sigma_m);
  EXPECT_NEAR(fit.residuals.rms_deg * kPi / 180, std::sqrt(3) * sigma_rad,
              0.1 * std::sqrt(3) * sigma_rad);
  double square = 0;
  int n = 0;
  for (double t = 0.2; t < truth.end_s() - 0.2; t += 0.01, ++n) {
    const Vec3d d = fit.spline.At(t).translation - truth.At(t).translation;
    square += Dot(d, d);
  }
  EXPECT_LT(std::sqrt(square / n), 0.35 * std::sqrt(3) * sigma_m);
}

TEST(TrajectorySmoothing, BridgesGapsSmoothlyWhereAllowed) {
  Trajectory samples = Samples([](double t) { return SE3d{{}, {0.5 * t, 0, 1}}; }, 4, 0.02, 100);
  std::erase_if(samples, [](const StampedPose& p) { return p.time_s > 101 && p.time_s < 102; });
  const std::string message = ErrorOf([&] { SmoothTrajectory(samples, {.max_gap_s = 0.5}); });
  EXPECT_THAT(message, HasSubstr("no pose for 1.0"));
  EXPECT_THAT(message, HasSubstr("max_gap_s"));
  const SmoothedTrajectory fit = SmoothTrajectory(samples, {.max_gap_s = 2});
  EXPECT_LT(Norm(fit.spline.At(1.5).translation - Vec3d{0.75, 0, 1}), 1e-6);
}

TEST(TrajectorySmoothing, TwoPosesAreAStraightLine) {
  const Trajectory samples{{5, {{}, {0, 0, 0}}},
                           {5.01, {Quaterniond::Exp({0.01, 0, 0}), {1, 0, 0}}}};
  const SmoothedTrajectory fit = SmoothTrajectory(samples, {});
  EXPECT_NEAR(fit.spline.end_s(), 0.01, 1e-9);
  EXPECT_LT(Norm(fit.spline.At(0.005).translation - Vec3d{0.5, 0, 0}), 1e-6);
  EXPECT_LT(fit.residuals.max_m, 1e-6);
}

TEST(TrajectorySmoothing, RefusesWhatItCannotFit) {
  const Trajectory samples{{0, {}}, {0.1, {}}};
  EXPECT_THAT(ErrorOf([&] { SmoothTrajectory({samples[0]}, {}); }), HasSubstr("two poses"));
  const auto refuses = [&](const SmoothingOptions& options, const char* name) {
    EXPECT_THAT(ErrorOf([&] { SmoothTrajectory(samples, options); }), HasSubstr(name));
  };
  refuses({.knot_spacing_s = 0}, "knot_spacing_s");
  refuses({.smoothing_s = NAN}, "smoothing_s");
  refuses({.smoothing_s = 0}, "smoothing_s");
  refuses({.max_gap_s = -1}, "max_gap_s");
  EXPECT_THAT(
      ErrorOf([] {
        SmoothTrajectory({{0, {}}, {1e5, {}}}, {.knot_spacing_s = 0.001, .max_gap_s = 1000});
      }),
      HasSubstr("max_gap_s"));
}

}  // namespace
}  // namespace silt::sim
