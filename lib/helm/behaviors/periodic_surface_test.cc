#include "lib/helm/behaviors/periodic_surface.h"

#include <gtest/gtest.h>

#include <map>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::periodic_surface_test {

/// A vehicle at 40 m with 2 m/s.
struct Submarine {
  explicit Submarine(const PeriodicSurfaceOptions& options = {}) : behavior(options) {
    vessel.own = {.motion = {.speed_mps = 2}, .depth_m = 40};
  }

  BehaviorAnswer At(double time_s, double depth_m) {
    vessel.own.depth_m = depth_m;
    return vessel.RunAt(behavior, time_s);
  }

  TestVessel vessel = {};
  PeriodicSurfaceBehavior behavior;
};

TEST(PeriodicSurface, WaitsAscendsAndStaysAtTheSurfaceUntilItIsMarked) {
  Submarine submarine;
  BehaviorAnswer answer = submarine.At(0, 40);
  EXPECT_FALSE(answer.objective.has_value());
  EXPECT_EQ(PostOf(answer, "PENDING_SURFACE"), VariableValue(300.0));
  EXPECT_EQ(submarine.At(299, 40).state, "waiting");
  answer = submarine.At(300, 40);
  EXPECT_EQ(answer.state, "ascending");
  EXPECT_EQ(submarine.vessel.Best(answer).depth_m, 0);
  EXPECT_DOUBLE_EQ(submarine.vessel.Best(answer).speed_mps, 2);
  answer = submarine.At(320, 20);
  EXPECT_DOUBLE_EQ(submarine.vessel.Best(answer).speed_mps, 1);
  EXPECT_EQ(PostOf(answer, "PERIODIC_ASCEND"), VariableValue("true"));
  answer = submarine.At(340, 0.3);
  EXPECT_EQ(answer.state, "at_surface");
  EXPECT_DOUBLE_EQ(submarine.vessel.Best(answer).speed_mps, 0);
  answer = submarine.At(350, 0.1);
  EXPECT_EQ(PostOf(answer, "TIME_AT_SURFACE"), VariableValue(10.0));
  ASSERT_TRUE(submarine.vessel.variables.Set("GPS_UPDATE_RECEIVED", "yes", 355));
  EXPECT_EQ(submarine.At(355, 0.1).state, "waiting");
}

TEST(PeriodicSurface, LeavesTheSurfaceAfterItsLongestTime) {
  Submarine submarine({.max_time_at_surface = 30});
  (void)submarine.At(0, 40);
  (void)submarine.At(300, 0);
  EXPECT_EQ(submarine.At(329, 0).state, "at_surface");
  EXPECT_EQ(submarine.At(330, 0).state, "waiting");
}

TEST(PeriodicSurface, WaitsAnewFromEachMarkAlsoWhileItIsIdle) {
  Submarine submarine;
  (void)submarine.At(0, 40);
  ASSERT_TRUE(submarine.vessel.variables.Set("GPS_UPDATE_RECEIVED", "yes", 200));
  submarine.vessel.time_s = 200;
  (void)submarine.behavior.Idle(submarine.vessel.Inputs());
  submarine.vessel.variables.ForgetFresh();
  EXPECT_EQ(submarine.At(499, 40).state, "waiting");
  EXPECT_EQ(submarine.At(500, 40).state, "ascending");
}

TEST(PeriodicSurface, SlowsDownByItsGrade) {
  const std::map<std::string, double> speeds_at_half = {
      {"linear", 1}, {"quadratic", 0.5}, {"quasi", 0.7}, {"fullspeed", 2}};
  for (const auto& [grade, speed_mps] : speeds_at_half) {
    Submarine submarine({.ascent_grade = grade});
    (void)submarine.At(0, 40);
    (void)submarine.At(300, 40);
    EXPECT_NEAR(submarine.vessel.Best(submarine.At(310, 20)).speed_mps, speed_mps, 1e-9) << grade;
  }
}

TEST(PeriodicSurface, WarnsWhereTheHelmDoesNotDecideAboutDepth) {
  Submarine submarine;
  submarine.vessel.domain.depth_m = {};
  EXPECT_NE(submarine.At(0, 40).warning, "");
}

}  // namespace shoal::periodic_surface_test
