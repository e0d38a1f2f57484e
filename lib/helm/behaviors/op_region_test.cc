#include "lib/helm/behaviors/op_region.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/convex_polygon.h"
#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::op_region_test {

using Flags = std::vector<std::string>;

const std::vector<Eigen::Vector2d> kSquare = {{-50, -50}, {-50, 50}, {50, 50}, {50, -50}};

/// Runs the behavior at places for a time each, every 0.25 s.
class Cruise {
 public:
  explicit Cruise(const OpRegionOptions& options) : region(options) {}

  BehaviorAnswer Stay(const Eigen::Vector2d& position_m, double for_s) {
    vessel.own.motion.position_m = position_m;
    BehaviorAnswer answer;
    for (double left_s = for_s; left_s > 0; left_s -= 0.25) {
      answer = vessel.Run(region);
      num_flags += answer.flags.size();
      vessel.time_s += 0.25;
    }
    return answer;
  }

  TestVessel vessel = {};
  OpRegionBehavior region;
  size_t num_flags = 0;
};

TEST(OpRegion, IsBreachedAfterTheExitTimeOutsideItsCore) {
  Cruise cruise({.core_poly = kSquare, .trigger_exit_time = 0.5});
  EXPECT_EQ(cruise.Stay({0, 0}, 2).error, "");
  EXPECT_EQ(cruise.Stay({51, 0}, 0.5).error, "");
  const BehaviorAnswer breach = cruise.Stay({51, 0}, 0.25);
  EXPECT_EQ(breach.error, "outside the op region");
  EXPECT_EQ(breach.flags, Flags({"breached_poly_flag"}));
  EXPECT_EQ(cruise.Stay({51, 0}, 0.25).flags, Flags());
}

TEST(OpRegion, IsNotBreachedByAStartOutsideOrTooShortAnEntry) {
  Cruise cruise({.core_poly = kSquare, .trigger_entry_time = 1});
  EXPECT_EQ(cruise.Stay({60, 0}, 5).error, "");
  EXPECT_EQ(cruise.Stay({40, 0}, 0.75).error, "");
  EXPECT_EQ(cruise.Stay({60, 0}, 5).error, "");
}

TEST(OpRegion, IsBreachedByAStartOutsideWhereEntryDoesNotCount) {
  Cruise cruise({.core_poly = kSquare, .trigger_on_poly_entry = false});
  EXPECT_EQ(cruise.Stay({60, 0}, 1).error, "outside the op region");
}

TEST(OpRegion, StaysBreachedUntilTheOperatorClearsIt) {
  Cruise cruise({.core_poly = kSquare});
  (void)cruise.Stay({0, 0}, 2);
  (void)cruise.Stay({60, 0}, 1);
  EXPECT_EQ(cruise.Stay({0, 0}, 5).error, "outside the op region");
  (void)cruise.region.Idle(cruise.vessel.Inputs());
  EXPECT_EQ(cruise.Stay({0, 0}, 5).error, "outside the op region");
  cruise.region.Clear();
  EXPECT_EQ(cruise.Stay({0, 0}, 5).error, "");
}

TEST(OpRegion, StaysBreachedUntilItsVariableIsSet) {
  Cruise cruise({.core_poly = kSquare, .reset_var = "RESET"});
  (void)cruise.Stay({0, 0}, 2);
  (void)cruise.Stay({60, 0}, 1);
  EXPECT_EQ(cruise.Stay({0, 0}, 1).error, "outside the op region");
  ASSERT_TRUE(cruise.vessel.variables.Set("RESET", "true", 9));
  EXPECT_EQ(cruise.Stay({0, 0}, 0.25).error, "");
}

TEST(OpRegion, EndsABreachByItselfWithoutLatch) {
  Cruise cruise({.core_poly = kSquare, .latch = false});
  (void)cruise.Stay({0, 0}, 2);
  EXPECT_EQ(cruise.Stay({60, 0}, 1).error, "outside the op region");
  EXPECT_EQ(cruise.Stay({0, 0}, 0.25).error, "");
}

TEST(OpRegion, ParksTheHelmOnceInASoftBreach) {
  Cruise cruise({.core_poly = kSquare, .soft_poly_breach = true});
  (void)cruise.Stay({0, 0}, 2);
  (void)cruise.Stay({60, 0}, 0.5);
  const BehaviorAnswer breach = cruise.Stay({60, 0}, 0.25);
  EXPECT_TRUE(breach.parks);
  EXPECT_EQ(breach.error, "");
  EXPECT_NE(breach.warning, "");
  EXPECT_FALSE(cruise.Stay({60, 0}, 0.25).parks);
}

TEST(OpRegion, IsBreachedByDepthAltitudeAndTime) {
  Cruise deep({.max_depth = 30});
  deep.vessel.own.depth_m = 31;
  EXPECT_EQ(deep.Stay({0, 0}, 0.25).flags, Flags({"breached_depth_flag"}));
  Cruise low({.min_altitude = 5});
  EXPECT_EQ(low.Stay({0, 0}, 0.25).error, "");  // The altitude is not known.
  low.vessel.own.altitude_m = 4;
  EXPECT_EQ(low.Stay({0, 0}, 0.25).flags, Flags({"breached_altitude_flag"}));
  Cruise long_one({.max_time = 10});
  EXPECT_EQ(PostOf(long_one.Stay({0, 0}, 4.25), "OPREG_TIME_REMAINING"), VariableValue(6.0));
  EXPECT_EQ(long_one.Stay({0, 0}, 6).error, "");
  EXPECT_EQ(long_one.Stay({0, 0}, 0.25).flags, Flags({"breached_time_flag"}));
}

const OpRegionOptions kZones = {.core_poly = kSquare, .save_dist = 5, .halt_dist = 20};

TEST(OpRegion, TurnsBackBetweenTheSaveAndTheHaltZone) {
  Cruise cruise(kZones);
  EXPECT_FALSE(cruise.Stay({54, 0}, 2).objective.has_value());
  const BehaviorAnswer back = cruise.Stay({60, 0}, 0.25);
  EXPECT_EQ(back.flags, Flags({"save_flag", "savex_flag"}));
  EXPECT_EQ(cruise.vessel.Best(back).course_deg, 270);
  EXPECT_NEAR(cruise.vessel.Best(back).speed_mps, 0.8, 1e-12);
  EXPECT_EQ(cruise.Stay({60, 0}, 0.25).flags, Flags({"savex_flag"}));
  EXPECT_EQ(cruise.Stay({71, 0}, 1).error, "outside the op region");
}

TEST(OpRegion, KeepsTheSideToWhichItTurnsUntilItsBowMeetsTheZone) {
  Cruise cruise(kZones);
  (void)cruise.Stay({0, 0}, 2);
  VesselMotion& own = cruise.vessel.own.motion;
  own.heading_deg = 80;  // The nearer way round is to port.
  EXPECT_LT(Wrap180(cruise.vessel.Best(cruise.Stay({60, 0}, 0.25)).course_deg - 80), 0);
  own.heading_deg = 100;
  EXPECT_LT(Wrap180(cruise.vessel.Best(cruise.Stay({60, 0}, 0.25)).course_deg - 100), 0);
  own.heading_deg = 280;  // The bow meets it: free to go either way.
  EXPECT_EQ(cruise.vessel.Best(cruise.Stay({60, 0}, 0.25)).course_deg, 270);
}

TEST(OpRegion, NeverTurnsBackWithoutASaveZone) {
  Cruise cruise({.core_poly = kSquare});
  (void)cruise.Stay({0, 0}, 2);
  EXPECT_FALSE(cruise.Stay({51, 0}, 0.25).objective.has_value());
}

TEST(OpRegion, PostsDistancesAndTimesToItsBorder) {
  Cruise cruise({.core_poly = kSquare});
  cruise.vessel.own.motion.heading_deg = 270;
  cruise.vessel.own.motion.speed_mps = 2;
  const BehaviorAnswer answer = cruise.Stay({30, 0}, 0.25);
  EXPECT_EQ(PostOf(answer, "OPREG_ABSOLUTE_PERIM_DIST"), VariableValue(20.0));
  EXPECT_EQ(PostOf(answer, "OPREG_ABSOLUTE_PERIM_ETA"), VariableValue(10.0));
  EXPECT_EQ(PostOf(answer, "OPREG_TRAJECTORY_PERIM_DIST"), VariableValue(80.0));
  EXPECT_EQ(PostOf(answer, "OPREG_TRAJECTORY_PERIM_ETA"), VariableValue(40.0));
}

TEST(OpRegion, ForgetsTheBreachOfAnotherRegion) {
  Cruise cruise({.core_poly = kSquare});
  (void)cruise.Stay({0, 0}, 2);
  (void)cruise.Stay({60, 0}, 1);
  cruise.region.Reconfigure({.core_poly = Grown(kSquare, 50)});
  EXPECT_EQ(cruise.Stay({60, 0}, 2).error, "");
}

RC_GTEST_PROP(OpRegion, PrefersACourseThatMeetsTheSaveZone, ()) {
  const double bearing_rad = DegToRad(*rc::gen::inRange(0, 3600) / 10.0);
  const Eigen::Vector2d position_m = *rc::gen::inRange(80, 300) * UnitVector(bearing_rad);
  Cruise cruise({.core_poly = kSquare, .save_dist = 5});
  (void)cruise.Stay({0, 0}, 2);
  cruise.vessel.own.motion.heading_deg = *rc::gen::inRange(0, 360);
  const BehaviorAnswer back = cruise.Stay(position_m, 0.25);
  const double course_deg = cruise.vessel.Best(back).course_deg;
  RC_ASSERT(RayDistance(Grown(kSquare, 5), position_m, DegToRad(course_deg)).has_value());
}

}  // namespace shoal::op_region_test
