
#include "silt/sim/centre_rays.h"

#include <gtest/gtest.h>

#include <cmath>

namespace silt::sim {
namespace {

constexpr PinholeCamera kCamera{100, 110, 4.5, 2.5, 10, 6};

SE3d Moving(double time_s) { return SE3d::Exp({{0, time_s, 0}, {time_s, 0, 0}}); }

TEST(CentreRays, OfOnePoseAreThoseOfTheCamera) {
  const CentreRays rays(kCamera, {}, Moving, 0.3);
  const CameraRays expected(kCamera, Moving(0.3));
  for (const int y : {0, 5}) {
    EXPECT_EQ(Norm(rays.OfRow(y).Direction(3, y) - expected.Direction(3, y)), 0);
    EXPECT_NEAR(rays.RotationOfRow(y).row[0].z, -std::sin(0.3), 1e-12);
  }
}

TEST(CentreRays, OfARollingShutterAreThoseOfEachRowsMiddle) {
  const CentreRays rays(kCamera, {0.5, 16, 0.1}, Moving, 0.3);
  for (int y = 0; y < kCamera.height; ++y) {
    const double time_s = 0.3 + (y - 2.5) * 0.1;
    EXPECT_NEAR(Norm(rays.OfRow(y).origin() - Moving(time_s).translation), 0, 1e-12);
    EXPECT_NEAR(rays.RotationOfRow(y).row[0].z, -std::sin(time_s), 1e-12);
  }
}

TEST(CentreRays, PacketsGoThroughTheCentresAndEndWithTheImage) {
  for (const double row_time_s : {0.0, 0.1}) {
    const CentreRays rays(kCamera, {0, 16, row_time_s}, Moving, 0.3);
    RayPacket packet;
    rays.Fill(8, 4, packet);
    for (int i = 0; i < kPacketSize; ++i) {
      const int x = 8 + i % 4, y = 4 + i / 4;
      ASSERT_EQ(packet.valid[i] != 0, x < 10 && y < 6);
      if (packet.valid[i] == 0) continue;
      const Vec3d direction = rays.OfRow(y).Direction(x, y);
      EXPECT_NEAR(packet.direction_x[i], direction.x, 2e-7);
      EXPECT_NEAR(packet.direction_z[i], direction.z, 2e-7);
      EXPECT_NEAR(packet.origin_x[i], rays.OfRow(y).origin().x, 1e-7);
    }
  }
}

}  // namespace
}  // namespace silt::sim
