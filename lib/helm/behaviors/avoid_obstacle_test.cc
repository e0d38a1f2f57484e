#include "lib/helm/behaviors/avoid_obstacle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/helm/behaviors/contact_testing.h"
#include "lib/helm/behaviors/obstacle_path.h"
#include "lib/helm/decision/decide.h"

namespace shoal::avoid_obstacle_test {

using Points = std::vector<Eigen::Vector2d>;

const VesselMotion kNorthbound = {.heading_deg = 0, .speed_mps = 2};

/// A square of 10 m, its centre there.
Points SquareAt(double x_m, double y_m) {
  return {{x_m - 5, y_m - 5}, {x_m - 5, y_m + 5}, {x_m + 5, y_m + 5}, {x_m + 5, y_m - 5}};
}

AvoidObstacleOptions Options(const Points& polygon) {
  return {.id = "rock", .polygon = polygon, .min_util_cpa_dist = 4, .max_util_cpa_dist = 8};
}

TEST(ClearanceOfCourses, IsTheDistanceOfAStraightPath) {
  const std::vector<double> clearance_m =
      ClearanceOfCourses(kNorthbound, {.reach_m = 100}, SquareAt(0, 30));
  EXPECT_EQ(clearance_m.at(0), 0);
  EXPECT_NEAR(clearance_m.at(90), 25, 1e-9);
  EXPECT_NEAR(clearance_m.at(180), 25, 1e-9);
  // The corner (5, 25) from a ray along 45 degrees.
  EXPECT_NEAR(clearance_m.at(45), std::abs(5 - 25) / std::sqrt(2), 1e-9);
  EXPECT_NEAR(clearance_m.at(315), clearance_m.at(45), 1e-9);
}

TEST(ClearanceOfCourses, EndsWithItsReach) {
  const std::vector<double> clearance_m =
      ClearanceOfCourses(kNorthbound, {.reach_m = 10}, SquareAt(0, 30));
  EXPECT_NEAR(clearance_m.at(0), 15, 1e-9);
}

TEST(ClearanceOfCourses, CountsTheTurn) {
  // A wall 12 m to starboard: back toward it over starboard takes twice the radius.
  const Points wall = {{12, -50}, {12, 50}, {14, 50}, {14, -50}};
  const std::vector<double> tight =
      ClearanceOfCourses(kNorthbound, {.turn_radius_m = 4, .reach_m = 10}, wall);
  const std::vector<double> wide =
      ClearanceOfCourses(kNorthbound, {.turn_radius_m = 8, .reach_m = 10}, wall);
  EXPECT_NEAR(tight.at(179), 4, 0.2);
  EXPECT_EQ(wide.at(179), 0);
  EXPECT_NEAR(wide.at(0), 12, 1e-9);
}

TEST(AvoidObstacle, TurnsAwayFromWhatIsAhead) {
  TestMeeting meeting(kNorthbound, {});
  AvoidObstacleBehavior behavior(Options(SquareAt(1, 20)));
  const BehaviorAnswer answer = meeting.Run(behavior);
  EXPECT_NEAR(ValueOf(*answer.objective, 0, 20, 0), 0, 1e-9);
  EXPECT_NEAR(ValueOf(*answer.objective, 180, 20, 0), 100, 1e-9);
  EXPECT_GT(answer.relevance, 0.5);
  EXPECT_TRUE(behavior.is_constraint());
}

TEST(AvoidObstacle, HasNoPreferenceOnceItIsAbaft) {
  TestMeeting meeting(kNorthbound, {});
  AvoidObstacleBehavior behavior(Options(SquareAt(0, -20)));
  EXPECT_FALSE(meeting.Run(behavior).objective.has_value());
  AvoidObstacleBehavior far(Options(SquareAt(0, 60)));
  EXPECT_FALSE(meeting.Run(far).objective.has_value());
}

TEST(AvoidObstacle, KeepsTheSideThatItHasBegunWith) {
  TestMeeting meeting({.heading_deg = 350, .speed_mps = 2}, {});
  AvoidObstacleBehavior behavior(Options(SquareAt(0, 17)));
  // Near enough that the side is locked: the obstacle is to starboard.
  const BehaviorAnswer answer = meeting.Run(behavior);
  EXPECT_GT(answer.relevance, 0.6);
  EXPECT_EQ(ValueOf(*answer.objective, 60, 20, 0), 0);
  EXPECT_GT(ValueOf(*answer.objective, 300, 20, 0), 90);
  meeting.vessel.own.motion.heading_deg = 10;
  EXPECT_EQ(ValueOf(*meeting.Run(behavior).objective, 60, 20, 0), 0);
}

TEST(AvoidObstacle, DoesNotTurnAcrossTheObstacleThatItKeepsOnOneSide) {
  TestMeeting meeting({.heading_deg = 350, .speed_mps = 2}, {});
  AvoidObstacleBehavior behavior(Options(SquareAt(0, 17)));
  const BehaviorAnswer answer = meeting.Run(behavior);
  // Over starboard, 160 and 175 degrees, across the square; over port, 150 degrees, away from it.
  EXPECT_EQ(ValueOf(*answer.objective, 150, 20, 0), 0);
  EXPECT_EQ(ValueOf(*answer.objective, 165, 20, 0), 0);
  EXPECT_GT(ValueOf(*answer.objective, 200, 20, 0), 90);
}

TEST(AvoidObstacle, StopsTheHelmInsideOrWarns) {
  TestMeeting meeting(kNorthbound, {});
  AvoidObstacleBehavior strict(Options(SquareAt(0, 0)));
  EXPECT_NE(meeting.Run(strict).error, "");
  AvoidObstacleOptions lenient = Options(SquareAt(0, 0));
  lenient.allstop_on_breach = false;
  AvoidObstacleBehavior warns(lenient);
  EXPECT_EQ(meeting.Run(warns).error, "");
  EXPECT_NE(meeting.Run(warns).warning, "");
}

TEST(AvoidObstacle, FindsAWayOutFromCloseBy) {
  TestMeeting meeting(kNorthbound, {});
  AvoidObstacleBehavior behavior(Options(SquareAt(0, 6)));
  const BehaviorAnswer answer = meeting.Run(behavior);
  EXPECT_EQ(answer.error, "");
  EXPECT_GT(ValueOf(*answer.objective, 180, 20, 0), 99);
}

TEST(AvoidObstacle, StopsTheHelmWhereNoTurnKeepsClear) {
  TestMeeting meeting(kNorthbound, {});
  AvoidObstacleOptions options = Options({{-500, 6}, {-500, 20}, {500, 20}, {500, 6}});
  options.turn_radius = 30;
  AvoidObstacleBehavior behavior(options);
  EXPECT_NE(meeting.Run(behavior).error, "");
  options.holonomic_ok = true;
  AvoidObstacleBehavior holonomic(options);
  EXPECT_EQ(meeting.Run(holonomic).error, "");
}

TEST(AvoidObstacle, TakesTheObstacleWithItsId) {
  TestMeeting meeting(kNorthbound, {});
  AvoidObstacleBehavior behavior({.id = "rock"});
  EXPECT_NE(meeting.Run(behavior).warning, "");
  meeting.obstacles = {{.id = "rock", .polygon_m = SquareAt(0, 20)}};
  EXPECT_TRUE(meeting.Run(behavior).objective.has_value());
}

TEST(AvoidObstacle, FiresItsFlagsOnceEach) {
  TestMeeting meeting(kNorthbound, {});
  AvoidObstacleBehavior behavior(Options(SquareAt(12, 40)));
  std::vector<std::string> flags;
  for (int i = 0; i < 160; ++i) {
    const BehaviorAnswer answer = meeting.Run(behavior);
    flags.insert(flags.end(), answer.flags.begin(), answer.flags.end());
    meeting.vessel.own.motion.position_m.y() += 0.5;
  }
  EXPECT_EQ(flags, (std::vector<std::string>{"rng_flag", "cpa_flag"}));
}

}  // namespace shoal::avoid_obstacle_test
