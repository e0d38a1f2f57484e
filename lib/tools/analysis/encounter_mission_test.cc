#include "lib/tools/analysis/encounter_mission.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "lib/mission/file/load.h"

namespace shoal::encounter_mission_test {

LoadedMission LoadedOf(const EncounterScenario& scenario, const EncounterMissionOptions& options) {
  return LoadMissionText(MissionTextOf(scenario, options, "x"), "x.toml");
}

void ExpectSound(const LoadedMission& loaded, const std::string& name) {
  EXPECT_EQ(loaded.errors, std::vector<std::string>{}) << name;
  EXPECT_EQ(loaded.warnings, std::vector<std::string>{}) << name;
}

TEST(EncounterMissions, OfEachSetLoadWithoutAWarning) {
  for (const bool others_hold : {false, true}) {
    const EncounterMissionOptions options = {.others_hold = others_hold};
    for (int number = 1; number <= kNumImazuCases; ++number) {
      const EncounterScenario scenario = ImazuCase(number, options.scale);
      ExpectSound(LoadedOf(scenario, options), scenario.name);
    }
    for (const std::string_view name : SingleTargetNames()) {
      ExpectSound(LoadedOf(*SingleTarget(name, options.scale), options), std::string(name));
    }
    for (int num_vessels = 2; num_vessels <= kMaxRandomVessels; ++num_vessels) {
      const EncounterScenario scenario = RandomEncounter(7, num_vessels, options.scale);
      ExpectSound(LoadedOf(scenario, options), scenario.name);
    }
  }
}

TEST(EncounterMissions, HaveVesselsThatStartAsTheScenarioHasThem) {
  const EncounterScenario scenario = ImazuCase(14, {});
  const Mission mission = LoadedOf(scenario, {}).mission;
  ASSERT_EQ(mission.vehicles.size(), 4U);
  for (size_t i = 0; i < 4; ++i) {
    const StartPose& start = mission.vehicles[i].start;
    const VesselMotion& motion = scenario.vessels[i].start;
    EXPECT_NEAR(start.x_m, motion.position_m.x(), 0.0005);
    EXPECT_NEAR(start.y_m, motion.position_m.y(), 0.0005);
    EXPECT_NEAR(start.heading_deg, motion.heading_deg, 0.0005);
    EXPECT_NEAR(start.speed_mps, motion.speed_mps, 0.0005);
  }
}

TEST(EncounterMissions, LetAllButTheFirstHoldCourseByATaskAlone) {
  const Mission mission = LoadedOf(ImazuCase(14, {}), {.others_hold = true}).mission;
  ASSERT_EQ(mission.vehicles.size(), 4U);
  EXPECT_TRUE(mission.vehicles[0].tasks.empty());
  for (size_t i = 1; i < 4; ++i) EXPECT_EQ(mission.vehicles[i].tasks.size(), 1U);
}

TEST(EncounterMissions, ExpectTheRoleThatASingleTargetIsMadeFor) {
  const Mission mission = LoadedOf(*SingleTarget("slower_port_107", {}), {}).mission;
  bool has_role = false;
  for (const Expectation& expectation : mission.expectations) {
    const auto* score = std::get_if<EncounterScoreExpectation>(&expectation.what);
    if (score != nullptr && score->role == "stand-on") has_role = true;
  }
  EXPECT_TRUE(has_role);
}

TEST(EncounterMissions, StretchEveryLengthForShips) {
  const EncounterMissionOptions ships = {.scale = {.length = 0.324, .speed_mps = 30}};
  const Mission mission = LoadedOf(ImazuCase(1, ships.scale), ships).mission;
  ASSERT_EQ(mission.vehicles.size(), 2U);
  EXPECT_EQ(mission.vehicles[0].length_m, 30);
  bool has_score = false;
  for (const Expectation& expectation : mission.expectations) {
    const auto* score = std::get_if<EncounterScoreExpectation>(&expectation.what);
    if (score == nullptr) continue;
    has_score = true;
    EXPECT_EQ(score->encounter.entry_range_m, 1500);
    EXPECT_EQ(score->encounter.near_miss_m, 50);
  }
  EXPECT_TRUE(has_score);
}

}  // namespace shoal::encounter_mission_test
