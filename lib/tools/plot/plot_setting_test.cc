#include "lib/tools/plot/plot_setting.h"

#include <gtest/gtest.h>

namespace shoal::plot_setting_test {

Mission MissionWith(Task task) {
  Mission mission;
  mission.name = "m";
  mission.seed = 7;
  mission.vehicles.emplace_back();
  mission.vehicles[0].name = "alpha";
  mission.vehicles[0].tasks = {std::move(task)};
  return mission;
}

TEST(PlotSetting, TakesNameAndSeed) {
  const PlotSetting setting = SettingOf(MissionWith({}));
  EXPECT_EQ(setting.title, "m");
  EXPECT_EQ(setting.seed, 7u);
  EXPECT_EQ(setting.vehicles.at(0).name, "alpha");
}

TEST(PlotSetting, ClosesThePathOfATaskThatIsDoneAgain) {
  WaypointsTask task{.points_m = {{0, 0}, {10, 0}, {10, 10}}};
  const auto legs = [&] {
    return SettingOf(MissionWith({.name = "w", .what = task})).vehicles.at(0).paths.at(0).legs;
  };
  EXPECT_EQ(legs(), (Stroke{{0, 0}, {10, 0}, {10, 10}}));
  task.laps = 0;
  EXPECT_EQ(legs(), (Stroke{{0, 0}, {10, 0}, {10, 10}, {0, 0}}));
}

TEST(PlotSetting, DrawsALoiterAsItsCircle) {
  LoiterTask task;
  task.center_m = {100, 50};
  task.radius_m = 20;
  const PlotSetting setting = SettingOf(MissionWith({.name = "l", .what = task}));
  const PlannedPath& path = setting.vehicles.at(0).paths.at(0);
  EXPECT_FALSE(path.has_points);
  for (const CurvePoint& point : path.legs) {
    EXPECT_NEAR((Eigen::Vector2d(point.x, point.y) - task.center_m).norm(), 20, 1e-9);
  }
}

TEST(PlotSetting, HasTheAreasThatAreSurveyedOnceAndWhatTheirVehiclesCover) {
  SurveyTask task;
  task.area = {.polygon_m = {{0, 0}, {100, 0}, {100, 40}}, .lane_spacing_m = 10};
  task.route.turn_radius_m = 5;
  Mission mission = MissionWith({.name = "s", .what = task});
  mission.vehicles.push_back(mission.vehicles[0]);
  mission.vehicles[1].name = "bravo";
  mission.expectations = {{.where = "", .what = CoverageExpectation{.sensor_width_m = 12}}};
  const PlotSetting setting = SettingOf(mission);
  EXPECT_EQ(setting.areas, (std::vector<Stroke>{{{0, 0}, {100, 0}, {100, 40}, {0, 0}}}));
  EXPECT_FALSE(setting.vehicles.at(0).paths.at(0).has_points) << "most only shape a turn";
  ASSERT_EQ(setting.coverage.size(), 2u);
  EXPECT_EQ(setting.coverage[1].vehicle, "bravo");
  EXPECT_EQ(setting.coverage[1].width_m, 12);
}

TEST(PlotSetting, HasNoPlaceForAVehicleThatKeepsStationWhereverItIs) {
  StationKeepTask task;
  EXPECT_TRUE(SettingOf(MissionWith({.name = "k", .what = task})).vehicles.at(0).paths.empty());
  task.here = false;
  EXPECT_EQ(SettingOf(MissionWith({.name = "k", .what = task})).vehicles.at(0).paths.size(), 1u);
}

TEST(PlotSetting, HasThePlanOfBehaviors) {
  Mission mission = MissionWith({.name = "t", .what = ReturnTask{}});
  mission.vehicles[0].tasks.clear();
  mission.vehicles[0].behaviors = {
      {.name = "out", .what = WaypointOptions{.points = {{0, 0}, {50, 0}}}},
      {.name = "fence", .what = OpRegionOptions{.core_poly = {{0, 0}, {90, 0}, {90, 90}}}}};
  const PlotSetting setting = SettingOf(mission);
  ASSERT_EQ(setting.vehicles.at(0).paths.size(), 1u);
  EXPECT_EQ(setting.vehicles[0].paths[0].legs.size(), 2u);
  EXPECT_EQ(setting.areas.size(), 1u);
}

TEST(PlotSetting, NamesTheDistancesOfTargetTrackingOnce) {
  TargetTrackTask task;
  task.target = "leader";
  Mission mission = MissionWith({.name = "t", .what = task});
  mission.vehicles.push_back(mission.vehicles[0]);
  mission.vehicles[1].name = "bravo";
  const PlotSetting setting = SettingOf(mission);
  EXPECT_EQ(setting.vehicles.at(1).target, "leader");
  const std::vector<DistanceMark> expected = {{"r_safe", 10}, {"r_inner", 80}, {"r_outer", 120}};
  EXPECT_EQ(setting.distances, expected);
}

}  // namespace shoal::plot_setting_test
