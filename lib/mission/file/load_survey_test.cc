// Surveys, groups that events and surveys address, and expectations of coverage, as seen through
// the loader.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "lib/mission/file/load_testing.h"
#include "lib/mission/model/coverage_area.h"

namespace shoal::load_survey_test {

const std::string kSurvey =
    "[[vehicle.task]]\nkind = \"survey\"\npolygon = [[0, 0], [100, 0], [100, 60], [0, 60]]\n";

/// Three vehicles; two are sweepers and share a polygon.
const std::string kShared = R"([mission]
duration_s = 60
[template.sweeper]
group = "Sweepers"
[[template.sweeper.task]]
kind = "survey"
polygon = [[0, 0], [100, 0], [100, 60], [0, 60]]
lane_spacing_m = 10
divide_among = ["group:sweepers"]
[[vehicle]]
name = "bravo"
template = "sweeper"
[[vehicle]]
name = "Alpha"
template = "sweeper"
start = {x_m = 50}
[[vehicle]]
name = "watch"
start = {x_m = 90}
)";

const SurveyTask& SurveyOf(const Mission& mission, const std::string& name) {
  return std::get<SurveyTask>(mission.FindVehicle(name)->tasks.at(0).what);
}

Mission Load(const std::string& text) {
  LoadedMission loaded = LoadMissionText(text, "m.toml");
  for (const std::string& error : loaded.errors) ADD_FAILURE() << error;
  return loaded.mission;
}

TEST(Survey, IsReadWithAllItsKeys) {
  const Mission mission = Load(std::string(kShortest) + "start = {x_m = 7, y_m = 8}\n" + kSurvey +
                               R"(points_frame = "start"
lane_spacing_m = 12
lane_angle_deg = 30
lane_ends = "inside"
entry = "south_east"
turn_radius_m = 6
overrun_m = 4
speed_mps = 2
capture_radius_m = 3
lookahead_m = 9
crab_gain = 0.01
)");
  SurveyTask expected;
  expected.area = {.polygon_m = {{7, 8}, {107, 8}, {107, 68}, {7, 68}},
                   .lane_spacing_m = 12,
                   .lane_angle_deg = 30,
                   .lane_ends = LaneEnds::kInside};
  expected.route = {
      .entry = SurveyEntry::kSouthEast, .start_m = {7, 8}, .turn_radius_m = 6, .overrun_m = 4};
  expected.speed_mps = 2;
  expected.capture.capture_radius_m = 3;
  expected.lookahead_m = 9;
  expected.crab_gain = 0.01;
  EXPECT_EQ(SurveyOf(mission, "alpha"), expected);
}

TEST(Survey, RefusesWhatCannotBeSurveyed) {
  EXPECT_EQ(ErrorsAfter("[[vehicle.task]]\nkind = \"survey\"\n"),
            "5:1: task lacks 'polygon'; for example: polygon = [[0, 0], [200, 0], [200, "
            "100], [0, 100]]\n");
  EXPECT_EQ(
      ErrorsAfter("[[vehicle.task]]\nkind = \"survey\"\n"
                  "polygon = [[0, 0], [9, 9], [9, 0], [0, 9]]\n"),
      "7:11: the edges after corners 1 and 3 cross or touch: list the corners in the order in "
      "which they follow one another\n");
  EXPECT_EQ(ErrorsAfter(kSurvey + "lane_spacing_m = 0.02\n"),
            "8:18: lane_spacing_m = 0.02 gives 3000 lanes; allowed: at most 2000\n");
}

TEST(SurveyShares, GoByTheOrderOfNamesWhateverTheOrderOfTheFile) {
  const Mission mission = Load(kShared);
  EXPECT_EQ(SurveyOf(mission, "alpha").share, (SurveyShare{.place = 0, .members = 2}));
  EXPECT_EQ(SurveyOf(mission, "bravo").share, (SurveyShare{.place = 1, .members = 2}));
  // Lanes run East and West; the first share is the northern one.
  for (const Eigen::Vector2d& point_m : PointsOf(SurveyOf(mission, "alpha"))) {
    EXPECT_GT(point_m.y(), 30);
  }
  for (const Eigen::Vector2d& point_m : PointsOf(SurveyOf(mission, "bravo"))) {
    EXPECT_LT(point_m.y(), 30);
  }
}

TEST(SurveyShares, AreRefusedWhereAMemberWouldLeaveItsOwnOut) {
  EXPECT_EQ(
      ErrorsOf(kShared + "group = \"sweepers\"\n"),
      "9:16: watch has no survey like this one, so that its share would be left out: give it a "
      "task with the same polygon, lane_spacing_m, lane_angle_deg, lane_ends and "
      "divide_among\n");
  EXPECT_EQ(ErrorsAfter(kSurvey + "divide_among = [\"bravo\"]\n[[vehicle]]\nname = \"bravo\"\n"),
            "8:16: alpha itself is not among them\n");
}

TEST(SurveyShares, AreRefusedWhereThereAreFewerLanesThanVehicles) {
  std::string text = kShared;
  text.replace(text.find("lane_spacing_m = 10"), 19, "lane_spacing_m = 90");
  EXPECT_EQ(ErrorsOf(text),
            "9:16: 2 vehicles cannot share 1 lane: lower lane_spacing_m, or leave vehicles out\n");
}

TEST(SurveyShares, RefuseUnknownVehiclesAndGroups) {
  EXPECT_EQ(ErrorsAfter(kSurvey + "divide_among = [\"alpah\", \"group:x\"]\n"),
            "8:16: no vehicle is of group 'x'; no vehicle has a group: write group = \"survey\" in "
            "its table\n"
            "8:16: unknown vehicle 'alpah' (did you mean 'alpha'?)\n");
}

TEST(EventsToGroups, AreForTheirMembers) {
  const Mission mission =
      Load(kShared +
           "[[event]]\nat_s = 1\nvehicle = \"group:SWEEPERS\"\ncommand = \"deploy\"\n"
           "[[event]]\nat_s = 2\nvehicle = \"group:sweepers\"\nsim_command = \"pause\"\n");
  const std::string& to = std::get<CommandEvent>(mission.events.at(0).what).vehicle;
  EXPECT_EQ(to, "group:Sweepers");
  std::vector<std::string> names;
  for (const Vehicle* vehicle : mission.VehiclesNamed(to)) names.push_back(vehicle->name);
  EXPECT_EQ(names, (std::vector<std::string>{"bravo", "Alpha"}));
  EXPECT_EQ(std::get<SimCommandEvent>(mission.events.at(1).what).vehicle, "group:Sweepers");
}

TEST(EventsToGroups, AreRefusedWhereThereIsNoSuchGroupOrAMemberLacksTheTask) {
  EXPECT_EQ(
      ErrorsOf(kShared + "[[event]]\nat_s = 1\nvehicle = \"group:swepers\"\n"
                         "command = \"deploy\"\n"),
      "22:11: no vehicle is of group 'swepers' (did you mean 'Sweepers'?); the mission has the "
      "groups Sweepers\n");
  EXPECT_EQ(ErrorsOf(kShared + "[[event]]\nat_s = 1\nvehicle = \"group:sweepers\"\n"
                               "command = \"task\"\nargument = \"home\"\n"),
            "24:12: bravo has no task 'home'\n");
  EXPECT_NE(ErrorsOf(kShared + "[[event]]\nat_s = 1\nvehicle = \"group:sweepers\"\n"
                               "rule = \"stealth\"\nvalue = 0.5\n")
                .find("22:11: unknown vehicle 'group:sweepers'"),
            std::string::npos);
}

TEST(Coverage, IsOfTheSurveysOfItsVehiclesUnlessItHasAPolygon) {
  const std::string coverage =
      "[[expect]]\nkind = \"coverage\"\nsensor_width_m = 20\nat_least_pct = 95\n";
  const auto only = [](const Mission& mission) {
    return std::get<CoverageExpectation>(mission.expectations.at(0).what);
  };
  const Mission all = Load(kShared + coverage);
  EXPECT_EQ(PolygonsOf(all, only(all)).size(), 1U);  // The one that both share.
  EXPECT_EQ(VehiclesOf(all, only(all)), (std::vector<size_t>{0, 1, 2}));
  const Mission some = Load(kShared + coverage +
                            "polygon = [[0, 0], [9, 0], [9, 9]]\nvehicles = [\"group:sweepers\", "
                            "\"ALPHA\"]\n");
  EXPECT_EQ(PolygonsOf(some, only(some)).at(0).size(), 3U);
  EXPECT_EQ(VehiclesOf(some, only(some)), (std::vector<size_t>{0, 1}));
  EXPECT_EQ(ErrorsAfter(coverage),
            "5:1: there is no area to cover: none of the vehicles has a task of kind \"survey\"; "
            "write polygon = [[0, 0], [200, 0], [200, 100]]\n");
  EXPECT_EQ(ErrorsAfter(coverage + "polygon = [[0, 0], [9, 0]]\n"),
            "9:11: a polygon needs three corners or more, like [[0, 0], [200, 0], [200, 100]]\n");
}

}  // namespace shoal::load_survey_test
