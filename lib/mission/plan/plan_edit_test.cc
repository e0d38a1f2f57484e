#include "lib/mission/plan/plan_edit.h"

#include <gtest/gtest.h>

#include <limits>

#include "lib/mission/file/load.h"

namespace shoal::plan_edit_test {

constexpr std::string_view kText = R"([mission]
duration_s = 60

[[vehicle]]
name = "alpha"
start = {y_m = 5, x_m = 1}  # y before x

[[vehicle.task]]
name = "survey"
kind = "waypoints"
points = [[10, 20], [30, 40], [50, 60]]  # three

# bravo follows.
[[vehicle]]
name = "bravo"
[[vehicle.task]]
kind = "loiter"
center = [0, -100]
)";

// Handles in the order of the file: start of alpha, points, start of bravo (absent), center.
constexpr size_t kStart = 0;
constexpr size_t kWay = 1;
constexpr size_t kBravo = 2;
constexpr size_t kCenter = 3;

std::string Edited(const PlanEdit& edit) {
  const Result<std::string> text = EditPlan(kText, edit);
  EXPECT_TRUE(text.ok()) << text.error();
  return text.ok() ? *text : std::string();
}

std::string Refusal(const PlanEdit& edit) { return EditPlan(kText, edit).error(); }

/// Every edit leaves a mission.
std::string With(std::string_view old_part, std::string_view new_part, const std::string& text) {
  std::string wanted(kText);
  wanted.replace(wanted.find(old_part), old_part.size(), new_part);
  EXPECT_EQ(text, wanted);
  const LoadedMission loaded = LoadMissionText(text, "m.toml");
  return loaded.errors.empty() ? "" : loaded.errors.front();
}

TEST(EditPlan, MovesAPointAndLeavesAllElseAsItIs) {
  EXPECT_EQ(With("[30, 40]", "[31.5, -2]", Edited(MovePoint{kWay, 1, {31.46, -2.04}})), "");
  EXPECT_EQ(With("y_m = 5, x_m = 1", "y_m = 8, x_m = 7", Edited(MovePoint{kStart, 0, {7, 8}})), "");
  EXPECT_EQ(With("[0, -100]", "[0, 0]", Edited(MovePoint{kCenter, 0, {-0.04, 0}})), "");
}

TEST(EditPlan, AddsAStartToAVehicleThatHasNone) {
  EXPECT_EQ(With("name = \"bravo\"\n", "name = \"bravo\"\nstart = {x_m = 3, y_m = 4.5}\n",
                 Edited(MovePoint{kBravo, 0, {3, 4.5}})),
            "");
}

TEST(EditPlan, AddsAndRemovesPoints) {
  EXPECT_EQ(With("[10, 20]", "[1, 2], [10, 20]", Edited(InsertPoint{kWay, 0, {1, 2}})), "");
  EXPECT_EQ(With("[50, 60]", "[50, 60], [1, 2]", Edited(InsertPoint{kWay, 3, {1, 2}})), "");
  EXPECT_EQ(With("[10, 20], ", "", Edited(RemovePoint{kWay, 0})), "");
  EXPECT_EQ(With(", [50, 60]", "", Edited(RemovePoint{kWay, 2})), "");
}

TEST(EditPlan, AddsATaskBehindThoseOfItsVehicle) {
  EXPECT_EQ(With("# three\n",
                 "# three\n\n[[vehicle.task]]\nname = \"planned_loiter\"\nkind = \"loiter\"\n"
                 "center = [1, 2]\nradius_m = 5\n",
                 Edited(AddTask{"alpha", "loiter", {{1, 2}, {4, 6}}})),
            "");
  const std::string survey =
      Edited(AddTask{"bravo", "survey", {{0, 0}, {100, 0}, {100, 80}, {0, 80}}});
  EXPECT_NE(survey.find("polygon = [[0, 0], [100, 0], [100, 80], [0, 80]]\nlane_spacing_m = 10\n"),
            std::string::npos);
  const LoadedMission loaded = LoadMissionText(survey, "m.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  EXPECT_EQ(loaded.mission.vehicles[1].tasks.size(), 2u);
  const Result<std::string> again =
      EditPlan(survey, AddTask{"bravo", "survey", {{0, 0}, {9, 0}, {9, 9}}});
  ASSERT_TRUE(again.ok());
  EXPECT_NE(again->find("planned_survey_2"), std::string::npos);
}

TEST(EditPlan, AddsObstaclesAndTheAreaOfOperations) {
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {10, 0}, {10, 10}};
  const std::string rock = Edited(AddObstacle{corners});
  EXPECT_TRUE(rock.ends_with(
      "\n[[obstacle]]\nid = \"planned_1\"\npolygon = [[0, 0], [10, 0], [10, 10]]\n"));
  EXPECT_NE(EditPlan(rock, AddObstacle{corners})->find("planned_2"), std::string::npos);
  EXPECT_EQ(LoadMissionText(rock, "m.toml").mission.obstacles.size(), 1u);
  const std::string area = Edited(AddArea{corners});
  EXPECT_TRUE(area.starts_with("[mission]\nop_area = [[0, 0], [10, 0], [10, 10]]\nduration_s"));
  EXPECT_EQ(EditPlan(area, AddArea{corners}).error(),
            "the mission has an op_area: move its corners");
}

TEST(EditPlan, KeepsTheDepthOfTheNeighbour) {
  const std::string_view text =
      "[[vehicle]]\nname = \"a\"\n[[vehicle.task]]\nkind = \"path_follow\"\n"
      "points = [[0, 0, 10], [50, 0, 20]]\n";
  EXPECT_NE(EditPlan(text, InsertPoint{1, 2, {9, 9}})->find("[50, 0, 20], [9, 9, 20]]"),
            std::string::npos);
  EXPECT_NE(EditPlan(text, MovePoint{1, 0, {1, 2}})->find("[[1, 2, 10], [50"), std::string::npos);
}

TEST(EditPlan, StatesWhyAChangeCannotBeMade) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Refusal(MovePoint{kWay, 3, {0, 0}}).find("no such place"), std::string::npos);
  EXPECT_NE(Refusal(MovePoint{99, 0, {0, 0}}).find("no such place"), std::string::npos);
  EXPECT_NE(Refusal(MovePoint{kWay, 0, {kNan, 0}}).find("within 1000 km"), std::string::npos);
  EXPECT_NE(Refusal(MovePoint{kWay, 0, {0, 1e7}}).find("within 1000 km"), std::string::npos);
  EXPECT_EQ(Refusal(RemovePoint{kCenter, 0}), "its last point must stay");
  EXPECT_EQ(Refusal(InsertPoint{kCenter, 0, {0, 0}}), "this is one place alone");
  EXPECT_NE(Refusal(AddTask{"zulu", "loiter", {{0, 0}}}).find("no [[vehicle]] 'zulu'"),
            std::string::npos);
  EXPECT_NE(Refusal(AddTask{"alpha", "path_follow", {{0, 0}}}).find("cannot be drawn"),
            std::string::npos);
  EXPECT_NE(Refusal(AddTask{"alpha", "survey", {{0, 0}}}).find("three corners"), std::string::npos);
  EXPECT_NE(Refusal(AddObstacle{{{0, 0}}}).find("three corners"), std::string::npos);
  EXPECT_NE(EditPlan("[mission", AddArea{}).error().find("not TOML"), std::string::npos);
}

}  // namespace shoal::plan_edit_test
