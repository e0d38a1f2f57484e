#include "lib/tools/view/setup_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/comms/routing/cause.h"
#include "lib/comms/routing/control.h"
#include "lib/mission/file/ocean_of.h"
#include "lib/tools/view/view_testing.h"

namespace shoal::setup_json_test {

using nlohmann::json;

Mission SurveyMission() {
  Mission mission = MissionOf({"alpha", "bravo"});
  mission.file = "missions/survey.toml";
  mission.seed = 18'446'744'073'709'551'615U;
  mission.op_area_m = {{0, 0}, {400, 0}, {400, -300}};
  mission.obstacles = {{"rock", {{40, -10}, {60, -10}, {60, 10}}}};
  mission.swarms.resize(1);
  mission.swarms[0].leader = "bravo";
  Vehicle& alpha = mission.vehicles[0];
  alpha.start = {.x_m = 10, .y_m = -20};
  alpha.return_task.point_m = {5, 6};
  WaypointsTask survey{.points_m = {{60, -40}, {60, -160.126}}};
  LoiterTask loiter;
  loiter.center_m = {100, 0};
  loiter.num_points = 4;
  StationKeepTask keep{.point_m = {1, 2}, .here = false};
  PathFollowTask path{.points_m = {{1, 2, 30}, {3, 4, 30}}, .end = PathTaskEnd::kReturnToFirst};
  alpha.tasks = {{"survey", survey},           {"wait", loiter}, {"keep", keep},
                 {"here", StationKeepTask{}},  {"dive", path},   {"home", ReturnTask{}},
                 {"follow", TargetTrackTask{}}};
  return mission;
}

json SetupOf(const Mission& mission, const SetupFacts& facts = {}) {
  std::vector<std::string> notes = facts.notes;
  const std::string floor = FloorJson(mission, &notes);
  SetupFacts with_notes = facts;
  with_notes.notes = notes;
  return json::parse(SetupJson(mission, with_notes, floor));
}

TEST(SetupJson, GivesVehiclesOfOneColourDifferentOnes) {
  Mission mission = MissionOf({"alpha", "bravo", "charlie"});
  mission.vehicles[0].color = "yellow";
  mission.vehicles[1].color = "yellow";
  mission.vehicles[2].color = "dodgerblue";
  const json vehicles = SetupOf(mission)["vehicles"];
  EXPECT_EQ(vehicles[0]["shown_color"], "#ffff00");
  EXPECT_EQ(vehicles[1]["color"], "yellow") << "what the file has";
  EXPECT_NE(vehicles[1]["shown_color"], "#ffff00");
  EXPECT_EQ(vehicles[2]["shown_color"], "#1e90ff");
}

TEST(SetupJson, HasWhatBehaviorsAreAbout) {
  Mission mission = MissionOf({"alpha"});
  mission.vehicles[0].behaviors = {
      {.name = "there", .what = WaypointOptions{.points = {{5000, 0}, {5000, 60}}}},
      {.name = "fence",
       .what = OpRegionOptions{.core_poly = {{0, 0}, {9, 0}, {9, 9}},
                               .halt_poly = {{-1, -1}, {12, -1}, {12, 12}}}},
      {.name = "slow", .what = ConstantSpeedOptions{}}};
  const json behaviors = SetupOf(mission)["vehicles"][0]["behaviors"];
  ASSERT_EQ(behaviors.size(), 3u);
  EXPECT_EQ(behaviors[0]["name"], "there");
  EXPECT_EQ(behaviors[0]["kind"], "waypoint");
  EXPECT_EQ(behaviors[0]["points"], (json{{5000, 0}, {5000, 60}}));
  EXPECT_EQ(behaviors[1]["area"], (json{{0, 0}, {9, 0}, {9, 9}}));
  EXPECT_EQ(behaviors[2]["name"], "fence") << "each of its zones";
}

TEST(FloorJson, LeavesOutAShoreStationFarAway) {
  Mission mission = MissionOf({"alpha", "shore"});
  mission.environment.floor.style = "linear";
  mission.environment.floor.depth_m = 80;
  mission.vehicles[0].tasks = {{"go", WaypointsTask{.points_m = {{0, 0}, {600, 600}}}}};
  mission.vehicles[1].start = {.x_m = 400, .y_m = -9000};
  std::vector<std::string> notes;
  const json floor = json::parse(FloorJson(mission, &notes));
  EXPECT_LE(floor["step_m"], 10) << "not the 100 m that 9 km would need";
  mission.vehicles[1].start = {.x_m = 400, .y_m = -300};
  const json near = json::parse(FloorJson(mission, &notes));
  EXPECT_LE(near["y0"], -300);
}

TEST(SetupJson, HasTheTablesOfCausesAndOfRulesThatCanChange) {
  const json setup = SetupOf(SurveyMission());
  ASSERT_EQ(setup["causes"].size(), static_cast<size_t>(kNumCauses));
  EXPECT_EQ(setup["causes"][static_cast<size_t>(Cause::kOutOfRange)],
            (json{{"key", "out_of_range"},
                  {"text", "out of range"},
                  {"color", "#d55e00"},
                  {"outcome", "stopped"}}));
  EXPECT_EQ(setup["causes"][static_cast<size_t>(Cause::kDamaged)]["outcome"], "damaged");
  ASSERT_EQ(setup["rules"].size(), ControlTable().size());
  EXPECT_EQ(setup["rules"][0], (json{{"rule", "comms_range"},
                                     {"label", "Comms Range"},
                                     {"unit", "m"},
                                     {"of_vehicle", false},
                                     {"takes_value", true},
                                     {"values", "metres, or nolimit"},
                                     {"example", "250"},
                                     {"about", "what is sent is received nearer than this"}}));
}

TEST(SetupJson, ShowsTheMission) {
  const json setup = SetupOf(SurveyMission(), {.mode = "recorded",
                                               .boot = "5f0c",
                                               .commands = true,
                                               .begin_s = 1,
                                               .end_s = 599.5,
                                               .notes = {"a note"}});
  EXPECT_EQ(setup["mode"], "recorded");
  EXPECT_EQ(setup["boot"], "5f0c");
  EXPECT_EQ(setup["mission"], "test");
  EXPECT_EQ(setup["file"], "missions/survey.toml");
  EXPECT_FALSE(setup["version"].get<std::string>().empty());
  EXPECT_EQ(setup["seed"], 18'446'744'073'709'551'615U);
  EXPECT_EQ(setup["duration_s"], 600);
  EXPECT_EQ(setup["tick_s"], 0.1);
  EXPECT_EQ(setup["commands"], true);
  EXPECT_EQ(setup["begin_s"], 1);
  EXPECT_EQ(setup["end_s"], 599.5);
  EXPECT_EQ(setup["origin"], (json{{"lat_deg", 43.8253}, {"lon_deg", -70.3304}}));
  EXPECT_EQ(setup["op_area"], json::parse("[[0,0],[400,0],[400,-300]]"));
  EXPECT_EQ(setup["obstacles"],
            json::parse(R"([{"id":"rock","polygon":[[40,-10],[60,-10],[60,10]]}])"));
  EXPECT_TRUE(setup["floor"].is_null());
  EXPECT_EQ(setup["notes"], json{"a note"});
}

TEST(SetupJson, ShowsVehiclesAndTheirTasks) {
  const json setup = SetupOf(SurveyMission());
  ASSERT_EQ(setup["vehicles"].size(), 2U);
  const json& alpha = setup["vehicles"][0];
  EXPECT_EQ(alpha["name"], "alpha");
  EXPECT_EQ(alpha["type"], "kayak");
  EXPECT_EQ(alpha["color"], "yellow");
  EXPECT_EQ(alpha["model"], "surface_craft");
  EXPECT_EQ(alpha["length_m"], 3);
  EXPECT_EQ(alpha["in_swarm"], false);
  EXPECT_EQ(setup["vehicles"][1]["in_swarm"], true);
  EXPECT_EQ(alpha["start"], json::parse("[10,-20]"));
  EXPECT_EQ(alpha["return"], json::parse("[5,6]"));
  const json& tasks = alpha["tasks"];
  ASSERT_EQ(tasks.size(), 7U);
  EXPECT_EQ(tasks[0], json::parse(R"({"name": "survey", "kind": "waypoints", "closed": false,
                                      "points": [[60, -40], [60, -160.13]], "radius_m": 0,
                                      "marked": true, "area": []})"));
  EXPECT_EQ(tasks[1], json::parse(R"({"name": "wait", "kind": "loiter", "closed": true,
                                      "points": [[100, 50], [150, 0], [100, -50], [50, 0]],
                                      "radius_m": 0, "marked": true, "area": []})"));
  EXPECT_EQ(tasks[2]["points"], json::parse("[[1,2]]"));
  EXPECT_EQ(tasks[2]["radius_m"], 10);
  EXPECT_EQ(tasks[3]["points"], json::array()) << "that position is not known yet";
  EXPECT_EQ(tasks[4]["points"], json::parse("[[1,2],[3,4]]"));
  EXPECT_EQ(tasks[4]["closed"], true);
  EXPECT_EQ(tasks[5]["points"], json::parse("[[0,0]]"));
  EXPECT_EQ(tasks[6]["kind"], "target_track");
}

TEST(SetupJson, ClosesWaypointsThatArePassedAgain) {
  Mission mission = SurveyMission();
  std::get<WaypointsTask>(mission.vehicles[0].tasks[0].what).laps = 0;
  EXPECT_EQ(SetupOf(mission)["vehicles"][0]["tasks"][0]["closed"], true);
}

TEST(SetupJson, ShowsSurveysAndWhatIsToBeCovered) {
  Mission mission = SurveyMission();
  SurveyTask lanes;
  lanes.area = {.polygon_m = {{0, 0}, {100, 0}, {100, 40}, {0, 40}}, .lane_spacing_m = 20};
  lanes.route.turn_radius_m = 10;
  mission.vehicles[1].tasks = {{"lanes", lanes}};
  mission.expectations = {{.where = "", .what = CoverageExpectation{.sensor_width_m = 20}}};
  const json setup = SetupOf(mission);
  const json& task = setup["vehicles"][1]["tasks"][0];
  EXPECT_EQ(task["area"], json::parse("[[0,0],[100,0],[100,40],[0,40]]"));
  EXPECT_EQ(task["marked"], false) << "most points only shape a turn";
  EXPECT_GT(task["points"].size(), 8U);
  EXPECT_EQ(setup["coverage"], json::parse(R"([{"width_m": 20,
      "areas": [[[0,0],[100,0],[100,40],[0,40]]], "vehicles": ["alpha", "bravo"]}])"));
  EXPECT_EQ(SetupOf(SurveyMission())["coverage"], json::array());
}

TEST(SetupJson, SurvivesAnyText) {
  Mission mission = MissionOf({});
  mission.name = "\xff\"\n";
  EXPECT_EQ(SetupOf(mission)["mission"], "\xEF\xBF\xBD\"\n");
}

TEST(FloorJson, SamplesTheAreaOfTheMission) {
  Mission mission = SurveyMission();
  mission.environment.floor.style = "linear";
  mission.environment.floor.slope_east = 0.1;
  const json floor = SetupOf(mission)["floor"];
  const int nx = floor["nx"];
  const int ny = floor["ny"];
  const double step_m = floor["step_m"];
  EXPECT_LE(nx, 101);
  EXPECT_LE(ny, 101);
  EXPECT_EQ(floor["depth_m"].size(), static_cast<size_t>(nx * ny));
  EXPECT_LE(floor["x0"], -100) << "with a margin";
  EXPECT_LE(floor["y0"], -400);
  EXPECT_GE(floor["x0"].get<double>() + step_m * (nx - 1), 500);
  EXPECT_GE(floor["y0"].get<double>() + step_m * (ny - 1), 150);
  EXPECT_EQ(step_m, 10) << "the finest of 1, 2, 5, 10 that has at most 101 samples";
  const Result<Ocean> ocean = OceanOf(mission);
  ASSERT_TRUE(ocean.ok());
  const Eigen::Vector2d place_m(floor["x0"].get<double>() + 3 * step_m,
                                floor["y0"].get<double>() + 2 * step_m);
  EXPECT_NEAR(floor["depth_m"][static_cast<size_t>(2 * nx + 3)], (*ocean).floor->DepthAt(place_m),
              0.051);
}

TEST(FloorJson, IsBoundedForAnyArea) {
  Mission mission = MissionOf({"alpha"});
  mission.environment.floor.style = "flat";
  mission.op_area_m = {{-1e6, -1e6}, {1e6, 1e6}, {1e6, 0}};
  const json floor = SetupOf(mission)["floor"];
  EXPECT_LE(floor["nx"], 101);
  EXPECT_LE(floor["ny"], 101);
  EXPECT_EQ(floor["depth_m"][0], 125);
}

TEST(FloorJson, NotesWhyAFloorIsNotShown) {
  Mission mission = MissionOf({"alpha"});
  mission.environment.floor.style = "grid";
  mission.environment.floor.grid = "/nowhere/at_all.asc";
  const json setup = SetupOf(mission);
  EXPECT_TRUE(setup["floor"].is_null());
  ASSERT_EQ(setup["notes"].size(), 1U);
  EXPECT_NE(setup["notes"][0].get<std::string>().find("/nowhere/at_all.asc"), std::string::npos);
}

}  // namespace shoal::setup_json_test
