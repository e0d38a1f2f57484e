#include "lib/mission/file/load.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <variant>

#include "lib/mission/file/load_testing.h"

namespace shoal::load_test {

Mission Load(std::string_view text, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded = LoadMissionText(text, "missions/m.toml", overrides);
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  return loaded.mission;
}

Mission LoadAfter(std::string_view more, const std::vector<std::string>& overrides = {}) {
  return Load(std::string(kShortest) + std::string(more), overrides);
}

TEST(Load, FillsInEveryDefaultOfTheShortestMission) {
  Mission expected;
  expected.file = "missions/m.toml";
  expected.name = "m";
  expected.duration_s = 60;
  expected.vehicles.resize(1);
  expected.vehicles[0].name = "alpha";
  expected.vehicles[0].acoustic_address = 1;
  EXPECT_EQ(Load(kShortest), expected);
}

TEST(Load, CountsWholeTicksOfTheDuration) {
  EXPECT_EQ(Load(kShortest).LastStep(), 600);
  EXPECT_EQ(Load(kShortest, {"mission.tick_s=0.25"}).LastStep(), 240);
  EXPECT_EQ(Load(kShortest, {"mission.tick_s=0.001", "mission.duration_s=0.007"}).LastStep(), 7);
}

TEST(Load, FindsVehiclesWithoutRegardToCase) {
  const Mission mission = Load(kShortest);
  ASSERT_NE(mission.FindVehicle("ALPHA"), nullptr);
  EXPECT_EQ(mission.FindVehicle("ALPHA")->name, "alpha");
  EXPECT_EQ(mission.FindVehicle("alph"), nullptr);
  EXPECT_EQ(mission.FindVehicle(""), nullptr);
}

TEST(Load, TakesAPresetForTheWholeCurrentWithWhatStandsBesideIt) {
  const auto current = [](const std::string& words) {
    return LoadAfter("[environment]\ncurrent = {" + words + "}").environment.current;
  };
  EXPECT_EQ(current("preset = \"calm\""),
            (CurrentWords{"typical", "northeast", "steady", "steady", "calm", "calm"}));
  EXPECT_EQ(current("preset = \"dead\"").speed_mps, "dead");
  EXPECT_EQ(current("preset = \"stormy\", speed_mps = 0.25"),
            (CurrentWords{"0.25", "any", "unsteady", "unsteady", "choppy", "choppy"}));
}

TEST(Load, TakesNolimitAndNegativeRangesForTheSame) {
  EXPECT_EQ(LoadAfter("[comms]\ncomms_range = \"nolimit\"").comms.comms_range_m, -1);
  EXPECT_EQ(LoadAfter("[comms]\ncomms_range = -7").comms.comms_range_m, -1);
  EXPECT_EQ(LoadAfter("[comms]\ncomms_range = 0").comms.comms_range_m, 0);
}

TEST(Load, ForgetsAContactAfterTwentyStaleTimesByDefault) {
  EXPECT_EQ(LoadAfter("[comms]\nstale_time = 3").comms.stale_forget_s, 60);
  EXPECT_EQ(LoadAfter("[comms]\nstale_time = -1").comms.stale_forget_s, -1);
  EXPECT_EQ(LoadAfter("[comms]\nstale_time = 3\nstale_forget_s = 7").comms.stale_forget_s, 7);
}

TEST(Load, ReturnsToTheStartByDefault) {
  const auto home = [](std::string_view more) {
    return LoadAfter(more).vehicles.at(0).return_task.point_m;
  };
  EXPECT_EQ(home("start = {x_m = 3, y_m = 4}"), Eigen::Vector2d(3, 4));
  EXPECT_EQ(home("start = {x_m = 3, y_m = 4}\nreturn = {speed_mps = 2}"), Eigen::Vector2d(3, 4));
  EXPECT_EQ(home("start = {x_m = 3, y_m = 4}\nreturn = {point = [7, 8]}"), Eigen::Vector2d(7, 8));
  EXPECT_EQ(home("start = {x_m = 3, y_m = 4}\nreturn = {point = [7, 8], points_frame = 'start'}"),
            Eigen::Vector2d(10, 12));
}

TEST(Load, CountsPointsFromTheStartWhereAsked) {
  const Mission mission = LoadAfter(R"(start = {x_m = 100, y_m = 10}
[[vehicle.task]]
kind = "waypoints"
points = [[1, 2], [3, 4]]
points_frame = "start"
[[vehicle.task]]
kind = "loiter"
center = [1, 2]
)");
  const auto& tasks = mission.vehicles.at(0).tasks;
  EXPECT_EQ(std::get<WaypointsTask>(tasks.at(0).what).points_m,
            (std::vector<Eigen::Vector2d>{{101, 12}, {103, 14}}));
  EXPECT_EQ(std::get<LoiterTask>(tasks.at(1).what).center_m, Eigen::Vector2d(1, 2));
}

TEST(Load, NamesATaskByItsKindWhereItHasNoName) {
  const Mission mission = LoadAfter("[[vehicle.task]]\nkind = \"station_keep\"");
  EXPECT_EQ(mission.vehicles.at(0).tasks.at(0).name, "station_keep");
}

TEST(Load, KeepsStationHereWithoutAPoint) {
  const auto task = [](std::string_view more) {
    const Mission mission =
        LoadAfter("[[vehicle.task]]\nkind = \"station_keep\"\n" + std::string(more));
    return std::get<StationKeepTask>(mission.vehicles.at(0).tasks.at(0).what);
  };
  EXPECT_TRUE(task("").here);
  EXPECT_FALSE(task("point = [5, 6]").here);
  EXPECT_EQ(task("point = [5, 6]").point_m, Eigen::Vector2d(5, 6));
}

TEST(Load, SortsEventsByTimeAndKeepsTheOrderOfEqualTimes) {
  const Mission mission = LoadAfter(R"(
[[event]]
at_s = 9
rule = "comms_range"
value = "nolimit"
[[event]]
at_s = 3
vehicle = "ALPHA"
command = "goto"
values = [1, 2]
[[event]]
at_s = 9
vehicle = "alpha"
sim_command = "pause"
)");
  ASSERT_EQ(mission.events.size(), 3U);
  EXPECT_EQ(mission.events[0].what,
            (decltype(Event::what)(CommandEvent{"alpha", "goto", "", {1, 2}})));
  EXPECT_EQ(mission.events[1].what, (decltype(Event::what)(RuleEvent{"comms_range", "", -1})));
  EXPECT_EQ(mission.events[2].what, (decltype(Event::what)(SimCommandEvent{"alpha", "pause", {}})));
}

TEST(Load, ReportsWhereAnExpectationStands) {
  const Mission mission = LoadAfter("[[expect]]\nkind = \"arrival\"\nvehicle = \"all\"");
  EXPECT_EQ(mission.expectations.at(0).where, "missions/m.toml:5");
  EXPECT_EQ(std::get<ArrivalExpectation>(mission.expectations.at(0).what).by_s, 60);
}

TEST(LoadMission, ReportsWhyAFileCannotBeRead) {
  EXPECT_EQ(LoadMission("/nowhere/m.toml").errors,
            std::vector<std::string>{"/nowhere/m.toml: cannot be read: No such file or directory"});
  EXPECT_EQ(LoadMission("/").errors,
            std::vector<std::string>{"/: is a directory; name the .toml file in it"});
}

TEST(LoadMission, ReadsAFileThatIsAPipe) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const std::string text(kShortest);
  ASSERT_EQ(write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  close(ends[1]);
  const LoadedMission loaded = LoadMission("/dev/fd/" + std::to_string(ends[0]));
  close(ends[0]);
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  EXPECT_EQ(loaded.mission.duration_s, Load(kShortest).duration_s);
}

TEST(LoadMission, LoadsTheMissionsThatComeWithShoal) {
  for (const std::string name : {"acoustic", "acoustic_ping", "acoustic_shared", "alpha", "berta",
                                 "c_planner", "dvl_drift", "fleet", "hide_and_seek", "lbl",
                                 "packet_ranges", "python_planner", "remus_path", "swarm_direct"}) {
    const std::string path = std::string(SHOAL_SOURCE_DIR) + "/missions/" + name + ".toml";
    const LoadedMission loaded = LoadMission(path);
    EXPECT_EQ(loaded.errors, std::vector<std::string>{});
    EXPECT_EQ(loaded.warnings, std::vector<std::string>{});
    EXPECT_EQ(loaded.mission.name, name);
    EXPECT_FALSE(loaded.mission.expectations.empty()) << path << " succeeds whatever happens";
  }
}

}  // namespace shoal::load_test
