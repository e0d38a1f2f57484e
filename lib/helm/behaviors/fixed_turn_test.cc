#include "lib/helm/behaviors/fixed_turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::fixed_turn_test {

/// Turns 5 degrees a second and goes 1 m, until the behavior completes. Returns the angle turned.
double TurnUntilDone(FixedTurnBehavior& behavior, TestVessel& vessel, double step_deg) {
  for (int turned = 0; turned < 200; ++turned) {
    vessel.time_s += 1;
    if (vessel.Run(behavior).completes) return turned * std::abs(step_deg);
    VesselMotion& own = vessel.own.motion;
    own.heading_deg = Wrap360(own.heading_deg + step_deg);
    own.position_m += UnitVector(DegToRad(own.heading_deg));
  }
  return -1;
}

TEST(FixedTurn, SetsItsCourseAheadOfTheHeading) {
  TestVessel vessel;
  vessel.own.motion.heading_deg = 10;
  FixedTurnBehavior port({.fix_turn = 90, .speed = 1.5});
  EXPECT_EQ(vessel.Best(vessel.Run(port)).course_deg, 350);
  EXPECT_DOUBLE_EQ(vessel.Best(vessel.Run(port)).speed_mps, 1.5);
  FixedTurnBehavior starboard({.fix_turn = 90, .mod_hdg = 30, .turn_dir = "starboard"});
  EXPECT_EQ(vessel.Best(vessel.Run(starboard)).course_deg, 40);
}

TEST(FixedTurn, EndsAfterItsAngleAlsoAcrossNorth) {
  for (const double side : {-1, 1}) {
    TestVessel vessel;
    vessel.own.motion.heading_deg = Wrap360(-40 * side);
    FixedTurnBehavior behavior({.fix_turn = 270, .turn_dir = side < 0 ? "port" : "starboard"});
    EXPECT_EQ(TurnUntilDone(behavior, vessel, 5 * side), 270);
  }
}

TEST(FixedTurn, CountsATurnToTheOtherSideAgainstIt) {
  TestVessel vessel;
  FixedTurnBehavior behavior({.fix_turn = 90, .turn_dir = "port"});
  EXPECT_EQ(TurnUntilDone(behavior, vessel, 5), -1);
}

TEST(FixedTurn, EndsAtItsTimeout) {
  TestVessel vessel;
  FixedTurnBehavior behavior({.fix_turn = 90, .timeout = 20});
  EXPECT_FALSE(vessel.RunAt(behavior, 0.0).completes);
  EXPECT_FALSE(vessel.RunAt(behavior, 19.0).completes);
  EXPECT_TRUE(vessel.RunAt(behavior, 20.0).completes);
  EXPECT_FALSE(vessel.RunAt(behavior, 21.0).objective.has_value());
}

TEST(FixedTurn, WaitsForItsDelayAndKeepsTheSpeedItHasThen) {
  TestVessel vessel;
  vessel.own.motion.speed_mps = 1;
  FixedTurnBehavior behavior({.fix_turn = 90, .speed = -1, .turn_delay = 10});
  EXPECT_FALSE(vessel.RunAt(behavior, 0.0).objective.has_value());
  vessel.own.motion.speed_mps = 2;
  EXPECT_FALSE(vessel.RunAt(behavior, 9.0).objective.has_value());
  EXPECT_DOUBLE_EQ(vessel.Best(vessel.RunAt(behavior, 10.0)).speed_mps, 2);
}

TEST(FixedTurn, PostsTheRadiusOfItsTurn) {
  TestVessel vessel;
  FixedTurnBehavior behavior({.fix_turn = 360, .turn_dir = "starboard", .radius_rep_var = "R"});
  BehaviorAnswer answer;
  for (int i = 0; i < 20; ++i) {
    answer = vessel.RunAt(behavior, static_cast<double>(i));
    VesselMotion& own = vessel.own.motion;
    own.heading_deg += 5;
    own.position_m += UnitVector(DegToRad(own.heading_deg));
  }
  // 1 m on 5 degrees.
  EXPECT_NEAR(std::get<double>(PostOf(answer, "R")), 1 / DegToRad(5), 1e-6);
}

}  // namespace shoal::fixed_turn_test
