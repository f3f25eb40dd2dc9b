// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/sim/lens_map.h"

#include <ceres/jet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "silt/core/error.h"

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{160, 158, 101.25, 73.5, 200, 150};
constexpr LensDistortion kWide{-0.28, 0.07, 0.002, -0.003, -0.008};

using Jet = ceres::Jet<double, 2>;

TEST(LensMap, DerivativesAreThoseOfTheJets) {
  for (const Vec2d& p : {Vec2d{0, 0}, Vec2d{0.3, -0.2}, Vec2d{-0.55, 0.4}}) {
    const Vec2<Jet> d = kWide.Distort(Vec2<Jet>{{p.x, 0}, {p.y, 1}});
    const auto derivative = kWide.DistortDerivative(p);
    EXPECT_NEAR(derivative.xx, d.x.v[0], 1e-15);
    EXPECT_NEAR(derivative.xy, d.x.v[1], 1e-15);
    EXPECT_NEAR(derivative.xy, d.y.v[0], 1e-15);
    EXPECT_NEAR(derivative.yy, d.y.v[1], 1e-15);
  }
}

// The Jet of the inverse is the inverse of the derivative.
TEST(LensMap, UndistortCarriesDerivatives) {
  const Vec2d p{0.45, -0.3}, d = kWide.Distort(p);
  const Vec2<Jet> back = kWide.Undistort(Vec2<Jet>{{d.x, 0}, {d.y, 1}});
  const auto derivative = kWide.DistortDerivative(p);
  const double determinant = derivative.Determinant();
  EXPECT_NEAR(back.x.a, p.x, 1e-15);
  EXPECT_NEAR(back.x.v[0], derivative.yy / determinant, 1e-13);
  EXPECT_NEAR(back.x.v[1], -derivative.xy / determinant, 1e-13);
  EXPECT_NEAR(back.y.v[1], derivative.xx / determinant, 1e-13);
}

TEST(LensMap, APinholePixelDistortsToThePixelAskedFor) {
  const LensMap map(kCamera, kWide);
  for (const Vec2d& pixel : {Vec2d{0, 0}, Vec2d{199.49, -0.5}, Vec2d{-0.49, 149.5},
                             Vec2d{57.125, 91.75}, Vec2d{101.25, 73.5}}) {
    const Vec2d pinhole = map.PinholePixel(pixel.x, pixel.y);
    const Vec3d point = kCamera.Unproject(pinhole.x, pinhole.y, 3.0);
    const Vec2d seen = ProjectThroughLens(kCamera, kWide, point);
    EXPECT_NEAR(seen.x, pixel.x, 1e-11);
    EXPECT_NEAR(seen.y, pixel.y, 1e-11);
  }
}

TEST(LensMap, TakesACentreOutsideThePicture) {
  const PinholeCamera off{160, 158, -40, 190, 200, 150};
  const LensDistortion lens{-0.02, 0, 0, 0, 0};
  const LensMap map(off, lens);
  const Vec2d pinhole = map.PinholePixel(150, 20);
  const Vec2d seen = ProjectThroughLens(off, lens, off.Unproject(pinhole.x, pinhole.y, 1.0));
  EXPECT_NEAR(seen.x, 150, 1e-11);
  EXPECT_NEAR(seen.y, 20, 1e-11);
}

std::string Complaint(const LensDistortion& lens, const PinholeCamera& camera = kCamera) {
  try {
    const LensMap map(camera, lens);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(LensMap, RefusesCoefficientsThatFoldThePicture) {
  // Beyond r = 1/√(3·|k1|) the picture would turn back: 0.47 for the first, within the corners.
  // The second folds between radii 0.43 and 0.66 only and opens again; the third is tangential.
  for (const LensDistortion& lens :
       {LensDistortion{-1.5, 0, 0, 0, 0}, LensDistortion{-3, 3.2, 0, 0, 0},
        LensDistortion{0, 0, 0.6, 0.6, 0}, LensDistortion{-1e9, 0, 0, 0, 0},
        LensDistortion{0, 0, 0, 0, -1e300}, LensDistortion{0.0 / 0.0, 0, 0, 0, 0}}) {
    const std::string said = Complaint(lens);
    EXPECT_THAT(said, testing::HasSubstr("fold the picture at pixel (")) << lens.k1;
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0);
  }
  // Between two pixels of a coarse picture.
  EXPECT_NE(Complaint({-3, 3.2, 0, 0, 0}, {3, 3, 7.5, 5.5, 16, 12}), "");
  EXPECT_EQ(Complaint({-0.3, 0.1, 0, 0, 0}), "");
  EXPECT_EQ(Complaint({5, 2, 0, 0, 1}), "");
}

}  // namespace
}  // namespace silt::sim
