// A kind of task or a vehicle model that is only half there is found here: every alternative of
// Task::what and AnyModel is drawn by the loader's tests and stands on the pages for users.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "lib/mission/file/load_testing.h"
#include "lib/mission/file/mission_testing.h"
#include "lib/vehicle/guidance/turning_room.h"

namespace shoal::rows_test {

std::string PageOf(const std::string& name) {
  std::ifstream file(std::string(SHOAL_SOURCE_DIR) + "/docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the row of the key in a page's table: "| `kind` | ... |".
std::string RowOf(const std::string& page, const std::string& key, const std::string& after) {
  const size_t begin = page.find("| `" + key + "` |", page.find(after));
  return begin == std::string::npos ? "" : page.substr(begin, page.find('\n', begin) - begin);
}

TEST(KindsOfTask, AreDrawnByTheTestsOfTheLoader) {
  std::set<std::string_view> drawn;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    for (const Vehicle& vehicle : MissionDraw(seed).Draw().vehicles) {
      for (const Task& task : vehicle.tasks) drawn.insert(KindOf(task));
    }
  }
  for (const Task& task : OneTaskOfEachKind()) {
    EXPECT_TRUE(drawn.contains(KindOf(task))) << "mission_testing.h draws no " << KindOf(task);
  }
}

TEST(KindsOfTask, StandInTheDocumentationOfMissionFiles) {
  const std::string row = RowOf(PageOf("missions/tasks.md"), "kind", "## [[vehicle.task]]");
  for (const Task& task : OneTaskOfEachKind()) {
    EXPECT_NE(row.find("`" + std::string(KindOf(task)) + "`"), std::string::npos) << KindOf(task);
  }
}

TEST(KindsOfTask, OfUnderwaterVehiclesAreRefusedForSurfaceCraft) {
  for (const Task& task : OneTaskOfEachKind()) {
    const std::string kind(KindOf(task));
    const std::string errors = ErrorsAfter("[[vehicle.task]]\nkind = \"" + kind + "\"\n");
    const bool is_refused = errors.find("is a task of underwater vehicles") != std::string::npos;
    EXPECT_EQ(is_refused, FactsOf(task).is_underwater) << errors;
  }
}

TEST(KindsOfBehavior, AreDrawnByTheTestsOfTheLoader) {
  std::set<std::string_view> drawn;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    for (const Vehicle& vehicle : MissionDraw(seed).Draw().vehicles) {
      for (const BehaviorOptions& behavior : vehicle.behaviors) {
        drawn.insert(KindOf(behavior.what));
      }
    }
  }
  for (const AnyBehavior& what : OneBehaviorOfEachKind()) {
    EXPECT_TRUE(drawn.contains(KindOf(what))) << "mission_testing.h draws no " << KindOf(what);
  }
}

TEST(KindsOfBehavior, StandInTheDocumentationOfMissionFiles) {
  const std::string row = RowOf(PageOf("missions/helms.md"), "kind", "## [[vehicle.behavior]]");
  for (const AnyBehavior& what : OneBehaviorOfEachKind()) {
    EXPECT_NE(row.find("`" + std::string(KindOf(what)) + "`"), std::string::npos) << KindOf(what);
  }
}

TEST(VehicleModels, AreDrawnByTheTestsOfTheLoader) {
  std::set<std::string_view> drawn;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    for (const Vehicle& vehicle : MissionDraw(seed).Draw().vehicles) {
      drawn.insert(FactsOfModel(vehicle.model).name);
    }
  }
  for (const AnyModel& model : EachModel()) {
    const std::string_view name = FactsOfModel(model).name;
    EXPECT_TRUE(drawn.contains(name)) << "mission_testing.h draws no " << name;
  }
}

/// Returns a model with what its table cannot be without, and the keys of that table.
AnyModel Completed(const AnyModel& model, std::string* keys) {
  keys->clear();
  if (!std::holds_alternative<TrackOptions>(model)) return model;
  const std::string file = std::string(SHOAL_SOURCE_DIR) + "/missions/tracks/launch.csv";
  *keys = "file = \"" + file + "\"\n";
  return TrackOptions{.file = file};
}

TEST(VehicleModels, HaveNamesOfTheirOwnWhichMissionFilesTake) {
  std::set<std::string_view> names;
  for (const AnyModel& model : EachModel()) {
    const std::string name(FactsOfModel(model).name);
    EXPECT_TRUE(names.insert(FactsOfModel(model).name).second) << name;
    std::string keys;
    const AnyModel completed = Completed(model, &keys);
    const std::string text =
        std::string(kShortest) + "model = \"" + name + "\"\n[vehicle." + name + "]\n" + keys;
    const LoadedMission loaded = LoadMissionText(text, "m.toml");
    EXPECT_TRUE(loaded.errors.empty()) << name << ": " << loaded.errors.front();
    EXPECT_EQ(loaded.mission.vehicles.at(0).model, completed) << name;
  }
}

TEST(VehicleModels, CanStartUnderWaterWhereTheyDive) {
  for (const AnyModel& model : EachModel()) {
    const ModelFacts facts = FactsOfModel(model);
    if (facts.passive == "replayed") continue;  // Its file states where it starts.
    const std::string errors =
        ErrorsAfter("start = {depth_m = 5}\nmodel = \"" + std::string(facts.name) + "\"\n");
    EXPECT_EQ(errors.empty(), facts.is_underwater) << facts.name << ": " << errors;
  }
}

TEST(VehicleModels, TurnNoWiderThanFollowersKeepRoomForBeforeObstacles) {
  for (const AnyModel& model : EachModel()) {
    const ModelFacts facts = FactsOfModel(model);
    if (!facts.is_underwater) continue;
    EXPECT_GT(facts.turning_diameter_m, 0) << facts.name;
    EXPECT_LE(facts.turning_diameter_m, kWidestTurn_m)
        << facts.name << ": turning_room.cc has the circle of a Remus 100";
  }
}

TEST(VehicleModels, StandInTheDocumentationOfMissionFiles) {
  const std::string page = PageOf("missions/vehicle.md");
  const std::string row = RowOf(page, "model", "## [[vehicle]]");
  for (const AnyModel& model : EachModel()) {
    const std::string name(FactsOfModel(model).name);
    EXPECT_NE(row.find("`" + name + "`"), std::string::npos) << name;
    EXPECT_NE(page.find("### [vehicle." + name + "]"), std::string::npos) << name;
  }
}

}  // namespace shoal::rows_test
