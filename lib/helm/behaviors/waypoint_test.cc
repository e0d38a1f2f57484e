#include "lib/helm/behaviors/waypoint.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::waypoint_test {

using Points = std::vector<Eigen::Vector2d>;
using Flags = std::vector<std::string>;

const Points kTwo = {{0, 100}, {100, 100}};

TEST(Waypoint, SteersForItsPointAtItsSpeed) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = {{100, 100}}, .speed = 1.5});
  const BehaviorAnswer answer = vessel.Run(waypoint);
  EXPECT_NEAR(vessel.Best(answer).course_deg, 45, 1);
  EXPECT_DOUBLE_EQ(vessel.Best(answer).speed_mps, 1.5);
  EXPECT_DOUBLE_EQ(answer.relevance, 1);
  EXPECT_EQ(PostOf(answer, "WPT_INDEX"), VariableValue(0.0));
}

TEST(Waypoint, LimitsItsSpeedToThatOfTheDomain) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = {{100, 100}}, .speed = 9});
  EXPECT_DOUBLE_EQ(vessel.Best(vessel.Run(waypoint)).speed_mps, 4);
}

TEST(Waypoint, UsesTheOtherSpeedWithUseAltSpeed) {
  TestVessel vessel;
  WaypointBehavior waypoint(
      {.points = {{100, 100}}, .speed = 3, .speed_alt = 1.2, .use_alt_speed = true});
  EXPECT_NEAR(vessel.Best(vessel.Run(waypoint)).speed_mps, 1.2, 1e-12);
}

TEST(Waypoint, GoesOnToTheNextPointInsideTheCaptureRadius) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1});
  EXPECT_EQ(vessel.RunAt(waypoint, {0, 96}).flags, Flags());
  const BehaviorAnswer answer = vessel.RunAt(waypoint, {0, 98});
  EXPECT_EQ(answer.flags, Flags({"wptflag"}));
  EXPECT_EQ(PostOf(answer, "WPT_INDEX"), VariableValue(1.0));
  EXPECT_NEAR(vessel.Best(answer).course_deg, 89, 1);
}

TEST(Waypoint, GoesOnWhereTheDistanceGrowsAgainInsideTheSlipRadius) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .slip_radius = 15});
  (void)vessel.RunAt(waypoint, {10, 60});
  (void)vessel.RunAt(waypoint, {10, 99});
  EXPECT_EQ(vessel.RunAt(waypoint, {10, 103}).flags, Flags({"wptflag"}));
}

TEST(Waypoint, GoesOnPastTheCaptureLineHoweverFarFromThePoint) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .capture_line = true});
  (void)vessel.RunAt(waypoint, {0, 0});
  EXPECT_EQ(vessel.RunAt(waypoint, {50, 99}).flags, Flags());
  EXPECT_EQ(vessel.RunAt(waypoint, {50, 101}).flags, Flags({"wptflag"}));
}

TEST(Waypoint, CountsNoRadiusWhereTheLineAloneCounts) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .capture_line_only = true});
  (void)vessel.RunAt(waypoint, {0, 0});
  EXPECT_EQ(vessel.RunAt(waypoint, {0, 99.9}).flags, Flags());
  EXPECT_EQ(vessel.RunAt(waypoint, {0, 100.1}).flags, Flags({"wptflag"}));
}

TEST(Waypoint, CompletesOnceAtTheEndOfTheListAndThenHasNoPreference) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = {{0, 100}}, .speed = 1});
  const BehaviorAnswer last = vessel.RunAt(waypoint, {0, 99});
  EXPECT_TRUE(last.completes);
  EXPECT_EQ(last.flags, Flags({"wptflag", "cycleflag"}));
  EXPECT_FALSE(last.objective.has_value());
  EXPECT_EQ(PostOf(last, "CYCLE_INDEX"), VariableValue(1.0));
  const BehaviorAnswer after = vessel.Run(waypoint);
  EXPECT_FALSE(after.completes);
  EXPECT_FALSE(after.objective.has_value());
}

TEST(Waypoint, BeginsAnewAfterItHasBeenIdleSinceTheEnd) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = {{0, 100}}, .speed = 1});
  (void)vessel.RunAt(waypoint, {0, 99});
  (void)waypoint.Idle(vessel.Inputs());
  EXPECT_TRUE(vessel.RunAt(waypoint, {0, 0}).objective.has_value());
}

TEST(Waypoint, RunsFurtherRoundsAndTogglesTheirOrder) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .order = "toggle", .repeat = 1});
  (void)vessel.RunAt(waypoint, kTwo[0]);
  EXPECT_FALSE(vessel.RunAt(waypoint, kTwo[1]).completes);
  // The second round begins with the last point, where it is.
  const BehaviorAnswer back = vessel.Run(waypoint);
  EXPECT_EQ(back.view.steers_for_m, kTwo[0]);
  EXPECT_TRUE(vessel.RunAt(waypoint, kTwo[0]).completes);
}

TEST(Waypoint, RunsForEverWithRepeatMinusOne) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .repeat = -1});
  for (int round = 0; round < 20; ++round) {
    EXPECT_FALSE(vessel.RunAt(waypoint, kTwo[0]).completes);
    EXPECT_FALSE(vessel.RunAt(waypoint, kTwo[1]).completes);
  }
  EXPECT_EQ(PostOf(vessel.RunAt(waypoint, kTwo[0]), "WPT_INDEX"), VariableValue(1.0));
}

TEST(Waypoint, ReversesItsList) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .order = "reverse"});
  EXPECT_EQ(vessel.Run(waypoint).view.points_m, Points({{100, 100}, {0, 100}}));
}

TEST(Waypoint, SortsItsListToTheNearestNextAsAGreedyTour) {
  TestVessel vessel;
  WaypointBehavior waypoint(
      {.points = {{0, 30}, {0, 10}, {0, -15}, {0, 20}}, .speed = 1, .greedy_tour = true});
  EXPECT_EQ(vessel.Run(waypoint).view.points_m, Points({{0, 10}, {0, 20}, {0, 30}, {0, -15}}));
}

TEST(Waypoint, GoesOnWithItsPointAfterAPauseOrBeginsAnewWithResetOnIdle) {
  for (const bool resets : {false, true}) {
    TestVessel vessel;
    WaypointBehavior waypoint({.points = kTwo, .speed = 1, .reset_on_idle = resets});
    (void)vessel.RunAt(waypoint, kTwo[0]);
    (void)waypoint.Idle(vessel.Inputs());
    const BehaviorAnswer answer = vessel.RunAt(waypoint, {50, 50});
    EXPECT_EQ(answer.view.steers_for_m, resets ? kTwo[0] : kTwo[1]);
  }
}

TEST(Waypoint, KeepsItsPlaceWhereOnlyTheSpeedChanges) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1});
  (void)vessel.RunAt(waypoint, kTwo[0]);
  waypoint.Reconfigure({.points = kTwo, .speed = 2});
  BehaviorAnswer answer = vessel.Run(waypoint);
  EXPECT_EQ(answer.view.steers_for_m, kTwo[1]);
  EXPECT_DOUBLE_EQ(vessel.Best(answer).speed_mps, 2);
  waypoint.Reconfigure({.points = {{-50, 0}, {0, 0}}, .speed = 2});
  EXPECT_EQ(vessel.Run(waypoint).view.steers_for_m, Eigen::Vector2d(-50, 0));
}

TEST(Waypoint, BeginsWithTheIndexThatIsGiven) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .currix = 1});
  EXPECT_EQ(vessel.Run(waypoint).view.steers_for_m, kTwo[1]);
}

TEST(Waypoint, LeadsAlongTheLegFromTheSecondPointOn) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .lead = 8});
  EXPECT_EQ(vessel.Run(waypoint).view.steers_for_m, kTwo[0]);
  (void)vessel.RunAt(waypoint, kTwo[0]);
  EXPECT_TRUE(
      vessel.RunAt(waypoint, {40, 95}).view.steers_for_m->isApprox(Eigen::Vector2d(48, 100)));
}

TEST(Waypoint, LeadsOnTheFirstLegTooWithLeadToStart) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .lead = 8, .lead_to_start = true});
  (void)vessel.RunAt(waypoint, {0, 0});
  EXPECT_TRUE(vessel.RunAt(waypoint, {5, 40}).view.steers_for_m->isApprox(Eigen::Vector2d(0, 48)));
}

TEST(Waypoint, LeadsOnlyWhileItsConditionHolds) {
  TestVessel vessel;
  WaypointBehavior waypoint(
      {.points = kTwo, .speed = 1, .lead = 8, .lead_to_start = true, .lead_condition = "L = on"});
  (void)vessel.RunAt(waypoint, {0, 0});
  EXPECT_EQ(vessel.RunAt(waypoint, {5, 40}).view.steers_for_m, kTwo[0]);
  ASSERT_TRUE(vessel.variables.Set("L", "on", 0));
  EXPECT_TRUE(vessel.Run(waypoint).view.steers_for_m->isApprox(Eigen::Vector2d(0, 48)));
}

TEST(Waypoint, SlowsDownTowardItsLastPointOnly) {
  TestVessel vessel;
  WaypointBehavior waypoint(
      {.points = kTwo, .speed = 2, .end_speed = 0.4, .end_slow_dist = 50, .end_stop_dist = 10});
  const auto speed_at = [&](const Eigen::Vector2d& position_m) {
    return vessel.Best(vessel.RunAt(waypoint, position_m)).speed_mps;
  };
  EXPECT_DOUBLE_EQ(speed_at({0, 90}), 2);
  EXPECT_DOUBLE_EQ(speed_at({0, 100}), 2);
  EXPECT_NEAR(speed_at({70, 100}), 1.2, 1e-9);
  EXPECT_NEAR(speed_at({95, 100}), 0.4, 1e-9);
}

TEST(Waypoint, SetsOffItsFlagAtTheBeginningWithWptflagOnStart) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .wptflag_on_start = true});
  EXPECT_EQ(vessel.Run(waypoint).flags, Flags({"wptflag"}));
  EXPECT_EQ(vessel.Run(waypoint).flags, Flags());
}

TEST(Waypoint, PostsUnderNamesWithItsSuffix) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = kTwo, .speed = 1, .post_suffix = "SURVEY"});
  const BehaviorAnswer answer = vessel.Run(waypoint);
  EXPECT_EQ(PostOf(answer, "WPT_INDEX_SURVEY"), VariableValue(0.0));
  EXPECT_EQ(PostOf(answer, "WPT_INDEX"), VariableValue());
  EXPECT_EQ(PostOf(answer, "WPT_STAT_SURVEY"),
            VariableValue("index=0,hits=0,cycles=0,dist=100,eta=-1"));
}

TEST(Waypoint, PostsUnderTheNamesThatItIsGiven) {
  TestVessel vessel;
  WaypointBehavior waypoint(
      {.points = kTwo, .speed = 1, .index_var = "LEG", .cycle_var = "ROUND", .status_var = ""});
  (void)vessel.RunAt(waypoint, kTwo[0]);
  EXPECT_EQ(PostOf(vessel.RunAt(waypoint, {50, 100}), "LEG"), VariableValue(1.0));
  const BehaviorAnswer answer = vessel.RunAt(waypoint, kTwo[1]);
  EXPECT_EQ(PostOf(answer, "ROUND"), VariableValue(1.0));
  EXPECT_EQ(PostOf(answer, "WPT_STAT"), VariableValue());
}

TEST(Waypoint, PostsTheDistancesToItsPointAndToTheOneBefore) {
  TestVessel vessel;
  WaypointBehavior waypoint(
      {.points = kTwo, .speed = 1, .dist_to_next_var = "NEXT", .dist_to_prev_var = "PREV"});
  const BehaviorAnswer first = vessel.RunAt(waypoint, {0, 60});
  EXPECT_EQ(PostOf(first, "NEXT"), VariableValue(40.0));
  EXPECT_EQ(PostOf(first, "PREV"), VariableValue(-1.0));
  (void)vessel.RunAt(waypoint, kTwo[0]);
  const BehaviorAnswer second = vessel.RunAt(waypoint, {30, 100});
  EXPECT_EQ(PostOf(second, "NEXT"), VariableValue(70.0));
  EXPECT_EQ(PostOf(second, "PREV"), VariableValue(30.0));
  const BehaviorAnswer idle = waypoint.Idle(vessel.Inputs());
  EXPECT_EQ(PostOf(idle, "NEXT"), VariableValue(-1.0));
  EXPECT_EQ(PostOf(idle, "PREV"), VariableValue(-1.0));
  EXPECT_EQ(waypoint.Idle(vessel.Inputs()).posts.size(), 0u);
}

TEST(Waypoint, WaitsWithoutPoints) {
  TestVessel vessel;
  WaypointBehavior waypoint({.points = {}, .speed = 1});
  const BehaviorAnswer answer = vessel.Run(waypoint);
  EXPECT_FALSE(answer.objective.has_value());
  EXPECT_FALSE(answer.completes);
}

RC_GTEST_PROP(Waypoint, TurnsItsDecisionWithTheWorld, ()) {
  const auto draw = [] { return *rc::gen::inRange(-1000, 1001) / 10.0; };
  const Eigen::Vector2d point_m(draw(), draw());
  RC_PRE(point_m.norm() > 20);
  const int turn_deg = *rc::gen::inRange(0, 360);
  const int heading_deg = *rc::gen::inRange(0, 360);
  const double turn_rad = DegToRad(turn_deg);
  const Eigen::Vector2d turned_m(
      point_m.x() * std::cos(turn_rad) + point_m.y() * std::sin(turn_rad),
      point_m.y() * std::cos(turn_rad) - point_m.x() * std::sin(turn_rad));
  const auto course_of = [&](const Eigen::Vector2d& to_m, double own_heading_deg) {
    TestVessel vessel;
    vessel.own.motion.heading_deg = own_heading_deg;
    WaypointBehavior waypoint({.points = {to_m}, .speed = 1});
    return vessel.Best(vessel.Run(waypoint)).course_deg;
  };
  const double here_deg = course_of(point_m, heading_deg);
  const double there_deg = course_of(turned_m, Wrap360(heading_deg + turn_deg));
  // Two neighbours can be as good as each other to the last digit.
  RC_ASSERT(std::abs(Wrap180(there_deg - here_deg - turn_deg)) < 1.5);
}

RC_GTEST_PROP(Waypoint, BoundsItsApproachFunctionSafely, ()) {
  TestVessel vessel;
  vessel.own.motion.heading_deg = *rc::gen::inRange(0, 360);
  WaypointBehavior waypoint({.points = {{*rc::gen::inRange(-100, 101) + 0.5, 33}},
                             .speed = *rc::gen::inRange(0, 41) / 10.0,
                             .ipf_type = "roc"});
  const BehaviorAnswer answer = vessel.Run(waypoint);
  const CourseSpeedFunction& function = *answer.objective->coupled;
  GridBox box;
  box.first_course = *rc::gen::inRange(0, 360);
  box.last_course = *rc::gen::inRange(box.first_course, 360);
  box.first_speed = *rc::gen::inRange(0, 41);
  box.last_speed = *rc::gen::inRange(box.first_speed, 41);
  const CourseSpeedFunction::Range range = function.Bound(box);
  for (int course = box.first_course; course <= box.last_course; ++course) {
    for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
      const double value = function.At(course, speed);
      RC_ASSERT(value >= range.min - 1e-9 && value <= range.max + 1e-9);
    }
  }
}

}  // namespace shoal::waypoint_test
