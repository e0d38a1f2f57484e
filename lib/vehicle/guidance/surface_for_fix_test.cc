#include <gtest/gtest.h>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal::surface_for_fix_test {

const SurfaceForFixTask kTask = {.fixes = 3, .limit_s = 60, .speed_mps = 1, .radius_m = 20};

Fix At(double time_s, double z_m, int64_t num_gps_fixes) {
  return {.position_m = {7, 8},
          .heading_rad = DegToRad(90),
          .time_s = time_s,
          .z_m = z_m,
          .num_gps_fixes = num_gps_fixes};
}

TEST(SurfaceForFix, ComesUpOnItsHeading) {
  TaskRunner runner(kTask, At(0, 20, 5));
  const Guidance guidance = runner.Update(At(10, 15, 5));
  EXPECT_NEAR(guidance.heading_rad, DegToRad(90), 1e-12);
  EXPECT_EQ(guidance.z_m, 0);
  EXPECT_EQ(guidance.speed_mps, 1);
  EXPECT_FALSE(guidance.done);
}

TEST(SurfaceForFix, GoesRoundAtTheSurface) {
  TaskRunner runner(kTask, At(0, 0.4, 0));
  // 1 m/s on a circle of 20 m: 0.05 rad/s.
  EXPECT_NEAR(runner.Update(At(10, 0.2, 0)).heading_rad, DegToRad(90) + 0.5, 1e-12);
}

TEST(SurfaceForFix, IsDoneWithEnoughFixesSinceItBegan) {
  TaskRunner runner(kTask, At(0, 20, 5));
  EXPECT_FALSE(runner.Update(At(10, 0, 7)).done);
  EXPECT_TRUE(runner.Update(At(11, 0, 8)).done);
  EXPECT_TRUE(runner.Update(At(12, 5, 8)).done);
}

TEST(SurfaceForFix, GoesOnWithoutFixesAtItsTimeLimit) {
  TaskRunner runner(kTask, At(100, 20, 5));
  EXPECT_FALSE(runner.Update(At(159.9, 0, 5)).done);
  EXPECT_TRUE(runner.Update(At(160, 0, 5)).done);
}

TEST(SurfaceForFix, DoesNotCountAPause) {
  TaskRunner runner(kTask, At(0, 20, 5));
  EXPECT_FALSE(runner.Update(At(50, 0, 5)).done);
  runner.Rejoin(At(500, 0, 5));
  EXPECT_FALSE(runner.Update(At(505, 0, 5)).done);
  EXPECT_TRUE(runner.Update(At(510, 0, 5)).done);
}

}  // namespace shoal::surface_for_fix_test
