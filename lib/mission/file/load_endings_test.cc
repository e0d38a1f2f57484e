// What a mission file makes of endings: their words, and the radii that follow from the model.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/mission/file/load_testing.h"

namespace shoal::load_endings_test {

constexpr std::string_view kAuv =
    "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"alpha\"\n"
    "model = \"remus100\"\n";

Vehicle Loaded(const std::string& text) {
  const LoadedMission loaded = LoadMissionText(text, "m");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  return loaded.errors.empty() ? loaded.mission.vehicles.at(0) : Vehicle();
}

std::string Auv(const std::string& more) { return std::string(kAuv) + more; }

TEST(Endings, AreTheHelmsOwnWhereTheFileHasNone) {
  EXPECT_FALSE(Loaded(Auv("")).helm_options.end_of_tasks.has_value());
}

TEST(Endings, HaveAWordEach) {
  const auto ending = [](const std::string& word) {
    return Loaded(Auv("helm_options = {end_of_tasks = \"" + word + "\"}\n"))
        .helm_options.end_of_tasks;
  };
  EXPECT_EQ(ending("hold"), Ending::kHold);
  EXPECT_EQ(ending("surface"), Ending::kSurface);
  EXPECT_EQ(ending("go_on"), Ending::kGoOn);
  EXPECT_EQ(ending("loiter"), Ending::kLoiter);
  EXPECT_EQ(ending("end_mission"), Ending::kEndMission);
}

TEST(Endings, AreRefusedWhereTheModelOrTheFileDoesNotHaveThem) {
  EXPECT_EQ(ErrorsOf(Auv("helm_options = {end_of_tasks = \"dive\"}\n")),
            "6:32: unknown end_of_tasks 'dive'; one of: hold, surface, go_on, loiter, "
            "end_mission\n");
  EXPECT_EQ(ErrorsAfter("helm_options = {end_of_tasks = \"surface\"}\n"),
            "5:32: only a vehicle of model = \"remus100\" comes up: write end_of_tasks = "
            "\"hold\"\n");
  EXPECT_EQ(ErrorsAfter("helm_options = {end_of_tasks = \"end_mission\"}\n[[vehicle.task]]\n"
                        "kind = \"station_keep\"\nname = \"end_of_tasks\"\n"),
            "8:8: end_of_tasks = \"end_mission\" needs this name: give the task another\n");
}

TEST(RadiiOfStations, FollowFromTheCircleInWhichAnAuvTurns) {
  const Vehicle vehicle = Loaded(Auv(R"([[vehicle.task]]
kind = "station_keep"
[[vehicle.task]]
kind = "return"
[[vehicle]]
name = "bravo"
)"));
  EXPECT_EQ(vehicle.helm_options.hold_radius_m, 45);
  EXPECT_EQ(vehicle.return_task.outer_radius_m, 45);
  const auto& keep = std::get<StationKeepTask>(vehicle.tasks.at(0).what);
  EXPECT_EQ(keep.outer_radius_m, 45);
  EXPECT_EQ(keep.inner_radius_m, 18);
  EXPECT_EQ(keep.speed_mps, 1.5);
  EXPECT_TRUE(keep.stops_first);
  EXPECT_EQ(std::get<ReturnTask>(vehicle.tasks.at(1).what).outer_radius_m, 45);
}

TEST(RadiiOfStations, AreThoseOfTheFileWhereItHasThem) {
  const Vehicle vehicle = Loaded(Auv(R"(helm_options = {hold_radius_m = 60}
[[vehicle.task]]
kind = "station_keep"
inner_radius_m = 5
[[vehicle.task]]
kind = "target_track"
target = "bravo"
[[vehicle]]
name = "bravo"
)"));
  EXPECT_EQ(vehicle.return_task.outer_radius_m, 60);
  EXPECT_EQ(std::get<StationKeepTask>(vehicle.tasks.at(0).what).inner_radius_m, 5);
  EXPECT_EQ(std::get<StationKeepTask>(vehicle.tasks.at(0).what).outer_radius_m, 10);
  EXPECT_EQ(std::get<TargetTrackTask>(vehicle.tasks.at(1).what).hold_radius_m, 60);
}

TEST(RadiiOfStations, AreThoseOfBeforeForSurfaceCraft) {
  const Vehicle vehicle =
      Loaded(std::string(kShortest) + "[[vehicle.task]]\nkind = \"station_keep\"\n");
  EXPECT_EQ(vehicle.helm_options.hold_radius_m, 10);
  EXPECT_EQ(std::get<StationKeepTask>(vehicle.tasks.at(0).what), StationKeepTask());
  EXPECT_EQ(vehicle.return_task.outer_radius_m, 10);
}

TEST(RadiiOfStations, AreWarnedOfWhereTheVehicleCannotHoldThem) {
  const LoadedMission loaded = LoadMissionText(Auv("helm_options = {hold_radius_m = 10}\n"), "m");
  const std::vector<std::string> warnings = WarningsBesideConduct(loaded);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings.at(0),
            "m:6:33: warning: hold_radius_m = 10 is less than the 45 m in which the vehicle turns: "
            "it will circle");
}

}  // namespace shoal::load_endings_test
