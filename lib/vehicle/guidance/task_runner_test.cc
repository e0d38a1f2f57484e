#include "lib/vehicle/guidance/task_runner.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <variant>

#include "lib/vehicle/guidance/ideal_vessel.h"

namespace shoal::task_runner_test {

WaypointsTask Square() {
  return {.points_m = {{0, 100}, {100, 100}, {100, 0}, {0, 0}}, .speed_mps = 1.5};
}

TEST(Task, IsNamedAsInTheMissionFile) {
  EXPECT_EQ(KindOf({.name = "", .what = WaypointsTask{}}), "waypoints");
  EXPECT_EQ(KindOf({.name = "", .what = LoiterTask{}}), "loiter");
  EXPECT_EQ(KindOf({.name = "", .what = StationKeepTask{}}), "station_keep");
  EXPECT_EQ(KindOf({.name = "", .what = ReturnTask{}}), "return");
}

TEST(Task, OfEachKindHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const Task& task : OneTaskOfEachKind()) {
    EXPECT_FALSE(KindOf(task).empty());
    EXPECT_TRUE(names.insert(KindOf(task)).second) << KindOf(task);
  }
  EXPECT_EQ(names.size(), std::variant_size_v<decltype(Task::what)>);
}

TEST(TaskFacts, CountLapsOnlyWhereTheTaskHasPointsToPass) {
  const auto most_laps = [](const decltype(Task::what)& what) {
    return FactsOf({.name = "", .what = what}).most_laps;
  };
  EXPECT_EQ(most_laps(WaypointsTask{.points_m = {{0, 0}}, .laps = 3}), 3);
  EXPECT_EQ(most_laps(WaypointsTask{.points_m = {{0, 0}}, .laps = 0}), std::nullopt);
  EXPECT_EQ(most_laps(LoiterTask{}), std::nullopt);
  EXPECT_EQ(most_laps(StationKeepTask{}), 0);
  EXPECT_EQ(most_laps(PathFollowTask{.points_m = {}, .end = PathTaskEnd::kHold}), 1);
  EXPECT_EQ(most_laps(PathFollowTask{.points_m = {}, .end = PathTaskEnd::kReturnToFirst}),
            std::nullopt);
}

TEST(TaskFacts, OutlineALoiterByItsCornersAndItsCircle) {
  const LoiterTask task{.center_m = {5, 7}, .radius_m = 20, .num_points = 4};
  const TaskOutline outline = FactsOf({.name = "", .what = task}).outline;
  ASSERT_EQ(outline.points_m.size(), 4U);
  EXPECT_LT((outline.points_m[1] - Eigen::Vector2d(25, 7)).norm(), 1e-9);
  EXPECT_TRUE(outline.closed);
  ASSERT_TRUE(outline.circle.has_value());
  EXPECT_EQ(outline.circle->radius_m, 20);
}

TEST(Waypoints, ArePassedInOrderAndThenDone) {
  IdealVessel vessel;
  TaskRunner runner(Square(), vessel.fix);
  int last_index = 0;
  const Guidance end = Sail(runner, vessel, 400, [&](const Guidance& guidance) {
    EXPECT_TRUE(guidance.waypoint_index == last_index || guidance.waypoint_index == last_index + 1);
    last_index = guidance.waypoint_index;
  });
  EXPECT_TRUE(end.done);
  EXPECT_EQ(end.laps_done, 1);
  EXPECT_LT(vessel.fix.position_m.norm(), 5);
  EXPECT_NEAR(vessel.fix.time_s, 400 / 1.5, 20);
}

TEST(Waypoints, ArePassedAsOftenAsAskedFor) {
  IdealVessel vessel;
  WaypointsTask task = Square();
  task.laps = 3;
  TaskRunner runner(task, vessel.fix);
  EXPECT_EQ(Sail(runner, vessel, 2000).laps_done, 3);
  EXPECT_LT(vessel.fix.time_s, 900);
}

TEST(Waypoints, WithoutANumberOfLapsGoOnForEver) {
  IdealVessel vessel;
  WaypointsTask task = Square();
  task.laps = 0;
  TaskRunner runner(task, vessel.fix);
  const Guidance end = Sail(runner, vessel, 1400);
  EXPECT_FALSE(end.done);
  EXPECT_EQ(end.laps_done, 5);
}

TEST(Waypoints, KeepTheVesselOnItsLegsInACurrent) {
  IdealVessel vessel{.current_mps = {0.3, 0.2}};
  WaypointsTask task = Square();
  task.laps = 2;
  TaskRunner runner(task, vessel.fix);
  double worst_m = 0;
  Sail(runner, vessel, 2000, [&](const Guidance& guidance) {
    if (guidance.laps_done == 1 && guidance.distance_m < 50) {
      worst_m = std::max(worst_m, std::abs(guidance.cross_track_error_m));
    }
  });
  EXPECT_LT(worst_m, 1.5);
}

TEST(Waypoints, AreReachedAfterThePointWasMissed) {
  IdealVessel vessel{.fix = {.heading_rad = 0}};
  WaypointsTask task{.points_m = {{0, 50}}, .capture = {.capture_radius_m = 2, .slip_radius_m = 0}};
  TaskRunner runner(task, vessel.fix);
  vessel.fix.position_m = {10, 70};  // Carried past the point by something else.
  EXPECT_TRUE(Sail(runner, vessel, 300).done);
}

TEST(Waypoints, AreGoneOnWithWhereTheyWereLeft) {
  IdealVessel vessel;
  TaskRunner runner(Square(), vessel.fix);
  Sail(runner, vessel, 100);
  vessel.fix.position_m = {60, 60};
  vessel.fix.time_s += 3600;
  runner.Rejoin(vessel.fix);
  EXPECT_EQ(runner.Update(vessel.fix).waypoint_index, 1);
  EXPECT_TRUE(Sail(runner, vessel, 400).done);
}

TEST(Waypoints, MayLieInOnePlace) {
  IdealVessel vessel{.fix = {.position_m = {-20, 5}}};
  WaypointsTask task{.points_m = {{10, 10}, {10, 10}, {10, 10}}, .laps = 2};
  TaskRunner runner(task, vessel.fix);
  EXPECT_TRUE(Sail(runner, vessel, 60).done);
}

TEST(Survey, PassesItsOwnLanesOnceAndNothingElse) {
  SurveyTask task;
  task.area = {.polygon_m = {{0, 0}, {200, 0}, {200, 80}, {0, 80}}, .lane_spacing_m = 20};
  task.route.turn_radius_m = 10;
  task.share = {.place = 1, .members = 2};  // Of the lanes at y = 70, 50, 30 and 10 the last two.
  IdealVessel vessel{.fix = {.position_m = {-20, 60}}};
  TaskRunner runner(task, vessel.fix);
  double most_y_m = 0;
  double least_y_m = 100;
  double worst_m = 0;
  const Guidance end = Sail(runner, vessel, 600, [&](const Guidance& guidance) {
    const Eigen::Vector2d& position_m = vessel.fix.position_m;
    if (position_m.x() < 20 || position_m.x() > 180) return;
    most_y_m = std::max(most_y_m, position_m.y());
    least_y_m = std::min(least_y_m, position_m.y());
    if (position_m.x() > 60 && position_m.x() < 140) {
      worst_m = std::max(worst_m, std::abs(guidance.cross_track_error_m));
    }
  });
  EXPECT_TRUE(end.done);
  EXPECT_EQ(end.laps_done, 1);
  EXPECT_NEAR(most_y_m, 30, 5);
  EXPECT_NEAR(least_y_m, 10, 5);
  EXPECT_LT(worst_m, 1);
}

TEST(Survey, IsDrawnWithItsAreaAndWithoutMarksOnItsTurns) {
  SurveyTask task;
  task.area = {.polygon_m = {{0, 0}, {200, 0}, {200, 80}, {0, 80}}, .lane_spacing_m = 20};
  TaskFacts facts = FactsOf({.name = "", .what = task});
  EXPECT_EQ(facts.outline.points_m.size(), 8U);
  EXPECT_EQ(facts.outline.area_m, task.area.polygon_m);
  EXPECT_TRUE(facts.outline.marks_points);
  EXPECT_TRUE(facts.ends);
  EXPECT_EQ(facts.most_laps, 1);
  task.route.turn_radius_m = 5;
  EXPECT_FALSE(FactsOf({.name = "", .what = task}).outline.marks_points);
}

TEST(Loiter, IsEnteredWhereTheWayInIsATangent) {
  const LoiterTask clockwise{.radius_m = 50, .num_points = 8, .clockwise = true};
  // From the South, clockwise is entered on the West side (corner 6), the other way on the East.
  const Fix south{.position_m = {0, -400}};
  EXPECT_EQ(TaskRunner(clockwise, south).Update(south).waypoint_index, 6);
  LoiterTask other = clockwise;
  other.clockwise = false;
  const Guidance guidance = TaskRunner(other, south).Update(south);
  EXPECT_NEAR(guidance.waypoint_m.x(), 50, 1e-9);
}

TEST(Loiter, GoesRoundInItsSenseAndStaysNearTheCircle) {
  for (const bool clockwise : {true, false}) {
    IdealVessel vessel{.fix = {.position_m = {-150, 20}}};
    TaskRunner runner(
        LoiterTask{.center_m = {10, 20}, .radius_m = 60, .num_points = 8, .clockwise = clockwise},
        vessel.fix);
    double angle_rad = HeadingOf(vessel.fix.position_m - Eigen::Vector2d(10, 20));
    double turned_rad = 0;
    const Guidance end = Sail(runner, vessel, 900, [&](const Guidance&) {
      const Eigen::Vector2d from_center_m = vessel.fix.position_m - Eigen::Vector2d(10, 20);
      turned_rad += WrapPi(HeadingOf(from_center_m) - angle_rad);
      angle_rad = HeadingOf(from_center_m);
      if (vessel.fix.time_s > 200) {
        EXPECT_NEAR(from_center_m.norm(), 58, 5);
      }
    });
    EXPECT_GE(end.laps_done, 3);
    EXPECT_GT((clockwise ? 1 : -1) * turned_rad, 3 * 2 * kPi);
  }
}

TEST(Loiter, EndsAfterItsDurationNotCountingPauses) {
  IdealVessel vessel;
  TaskRunner runner(LoiterTask{.duration_s = 60}, vessel.fix);
  Sail(runner, vessel, 30);
  vessel.fix.time_s += 1000;
  runner.Rejoin(vessel.fix);
  EXPECT_FALSE(Sail(runner, vessel, 29).done);
  EXPECT_TRUE(Sail(runner, vessel, 2).done);
}

TEST(Loiter, PassesItsCornersOneByOneWhereTheyLieWithinTheCaptureRadius) {
  IdealVessel vessel;
  TaskRunner runner(LoiterTask{.radius_m = 6, .num_points = 12}, vessel.fix);
  EXPECT_LT(Sail(runner, vessel, 60).laps_done, 5);
}

TEST(StationKeep, DriftsInsideTheOuterRadiusAndGoesBackInsideTheInner) {
  IdealVessel vessel{.fix = {.position_m = {100, 50}}, .current_mps = {0.2, 0}};
  TaskRunner runner(StationKeepTask{.inner_radius_m = 4, .outer_radius_m = 10}, vessel.fix);
  bool went_back = false;
  double farthest_m = 0;
  double last_speed_mps = 0;
  Sail(runner, vessel, 600, [&](const Guidance& guidance) {
    farthest_m = std::max(farthest_m, guidance.distance_m);
    if (guidance.speed_mps > 0 && last_speed_mps == 0) {
      EXPECT_GT(guidance.distance_m, 10);
    }
    if (guidance.speed_mps == 0 && last_speed_mps > 0) {
      EXPECT_LT(guidance.distance_m, 4);
      went_back = true;
    }
    last_speed_mps = guidance.speed_mps;
    EXPECT_FALSE(guidance.done);
  });
  EXPECT_TRUE(went_back);
  EXPECT_LT(farthest_m, 13);
}

TEST(StationKeep, GoesToItsPointWhenThatIsElsewhere) {
  IdealVessel vessel;
  TaskRunner runner(StationKeepTask{.point_m = {40, 0}, .here = false}, vessel.fix);
  EXPECT_LT(Sail(runner, vessel, 100).distance_m, 4);
}

TEST(Return, GoesHomeAndStaysThere) {
  IdealVessel vessel{.fix = {.position_m = {200, 100}}, .current_mps = {0, 0.2}};
  TaskRunner runner(ReturnTask{.point_m = {0, -20}}, vessel.fix);
  EXPECT_EQ(runner.Update(vessel.fix).waypoint_index, 0);
  Sail(runner, vessel, 250);
  Sail(runner, vessel, 300, [&](const Guidance& guidance) {
    EXPECT_LT(guidance.distance_m, 13);
    EXPECT_EQ(guidance.laps_done, 1);
  });
}

RC_GTEST_PROP(TaskRunner, GivesFiniteGuidanceWhereverTheVesselIsPut, ()) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-10'000'000, 10'000'001),
                                       [](int value) { return value * 1.0; });
  const auto near = rc::gen::map(rc::gen::inRange(-20, 21), [](int value) { return value * 1.0; });
  const TaskRunner::What what =
      *rc::gen::element<TaskRunner::What>(Square(), LoiterTask{}, StationKeepTask{}, ReturnTask{});
  Fix fix{.position_m = {*near, *near}};
  TaskRunner runner(what, fix);
  for (int i = 0; i < 20; ++i) {
    const bool is_near = *rc::gen::arbitrary<bool>();
    fix.position_m =
        is_near ? Eigen::Vector2d(*near, *near) : Eigen::Vector2d(*coordinate, *coordinate);
    fix.time_s += 0.1;
    const Guidance guidance = runner.Update(fix);
    RC_ASSERT(guidance.heading_rad >= 0);
    RC_ASSERT(guidance.heading_rad < 2 * kPi);
    RC_ASSERT(guidance.speed_mps >= 0);
    RC_ASSERT(std::isfinite(guidance.distance_m));
    RC_ASSERT(std::isfinite(guidance.cross_track_error_m));
  }
}

}  // namespace shoal::task_runner_test
