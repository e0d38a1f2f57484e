// Explain and LoadMissionText are each other's inverse.
#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "lib/mission/file/load.h"
#include "lib/mission/file/load_media.h"
#include "lib/mission/file/mission_testing.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal::explain_test {

TEST(Explain, LoadsBackAsTheSameMission) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Mission mission = MissionDraw(seed).Draw();
    LoadedMission loaded = LoadMissionText(Explain(mission), "");
    EXPECT_EQ(loaded.errors, std::vector<std::string>{}) << Explain(mission);
    for (Expectation& expectation : loaded.mission.expectations) expectation.where = "";
    EXPECT_TRUE(loaded.mission == mission) << Explain(mission);
  }
}

TEST(ExplainMedia, LoadsBackAsTheSameAcoustics) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Acoustics acoustics = MissionDraw(seed).DrawAcoustics();
    acoustics.is_used = seed % 2 == 0;
    const LoadedMedia loaded = LoadMediaText(ExplainMedia({.acoustics = acoustics}), "log");
    EXPECT_EQ(loaded.errors, std::vector<std::string>{}) << ExplainMedia({.acoustics = acoustics});
    EXPECT_TRUE(loaded.setup.acoustics == acoustics) << ExplainMedia({.acoustics = acoustics});
  }
  EXPECT_EQ(LoadMediaText(ExplainMedia({}), "log").setup, MediaSetup());
}

TEST(Explain, WritesTheSameTextForTheSameMission) {
  const Mission mission = MissionDraw(1).Draw();
  EXPECT_EQ(Explain(mission), Explain(MissionDraw(1).Draw()));
  EXPECT_EQ(Explain(LoadMissionText(Explain(mission), "").mission), Explain(mission));
}

/// Adds the keys of all values below `value` that are not tables themselves.
void AddKeys(const Value& value, std::set<std::string>& keys) {
  if (const auto* array = std::get_if<Array>(&value.data)) {
    for (const Value& element : *array) AddKeys(element, keys);
  } else if (const auto* table = std::get_if<Table>(&value.data)) {
    for (const Entry& entry : *table) {
      const auto* elements = std::get_if<Array>(&entry.value.data);
      const bool tables = elements != nullptr && !elements->empty() &&
                          std::holds_alternative<Table>(elements->front().data);
      if (!tables && !std::holds_alternative<Table>(entry.value.data)) keys.insert(entry.key);
      AddKeys(entry.value, keys);
    }
  }
}

TEST(Explain, WritesNoKeyThatTheDocumentationDoesNotHave) {
  // A modem's keys are documented with the modems, those of each kind of behavior with these.
  std::string page;
  for (const std::string name :
       {"missions/mission_file.md", "missions/environment.md", "missions/networks.md",
        "missions/vehicle.md", "missions/instruments.md", "missions/tasks.md", "missions/helms.md",
        "missions/fleets.md", "missions/events.md", "missions/expectations.md",
        "communication/acoustics_models.md", "reference/behaviors.md", "vehicles/contacts.md",
        "vehicles/colregs.md", "vehicles/modes.md"}) {
    std::ifstream file(std::string(SHOAL_SOURCE_DIR) + "/docs/" + name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    ASSERT_FALSE(text.empty()) << name;
    page += text;
  }
  std::set<std::string> keys;
  for (uint64_t seed = 0; seed < 20; ++seed) {
    Mission mission = MissionDraw(seed).Draw();
    for (Vehicle& vehicle : mission.vehicles) {
      vehicle.reporter_options.extra.clear();
      vehicle.variables.clear();
    }
    Problems problems("", {});
    const std::optional<Value> root = ParseToml(Explain(mission), problems);
    ASSERT_TRUE(root.has_value());
    AddKeys(*root, keys);
  }
  EXPECT_GE(keys.size(), 70U);
  for (const std::string& key : keys) {
    EXPECT_NE(page.find("`" + key + "`"), std::string::npos)
        << "no page of docs/missions explains " << key;
  }
}

}  // namespace shoal::explain_test
