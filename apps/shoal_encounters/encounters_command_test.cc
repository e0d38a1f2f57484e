#include "apps/shoal_encounters/encounters_command.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string>

#include "lib/bus/record/log_testing.h"

namespace shoal::encounters_command_test {

const std::string kFolder = std::string(SHOAL_SOURCE_DIR) + "/missions/encounters/";

std::string MissionOf(const EncounterChoice& choice) {
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(WriteEncounter(choice, out, err), kExitOk) << err.str();
  return out.str();
}

std::string ErrorOf(const EncounterChoice& choice) {
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(WriteEncounter(choice, out, err), kExitUsage);
  EXPECT_EQ(out.str(), "");
  return err.str();
}

// Written by `scripts/encounter_missions`.
TEST(MissionsOfEncounters, AreWhatTheCommandWrites) {
  std::set<std::string> names;
  for (int number = 1; number <= kNumImazuCases; ++number) {
    const EncounterChoice choice = {.set = "imazu", .number = number};
    const std::string name = ImazuCase(number, {}).name + ".toml";
    names.insert(name);
    EXPECT_EQ(TextOfFile(kFolder + name), MissionOf(choice)) << name;
  }
  for (const std::string_view single : SingleTargetNames()) {
    const EncounterChoice choice = {.set = "single", .name = std::string(single)};
    const std::string name = std::string(single) + ".toml";
    names.insert(name);
    EXPECT_EQ(TextOfFile(kFolder + name), MissionOf(choice)) << name;
  }
  std::set<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    found.insert(entry.path().filename().string());
  }
  EXPECT_EQ(found, names);
}

TEST(EncounterCommand, StatesWhatThereIsInPlaceOfWhatThereIsNot) {
  EXPECT_NE(ErrorOf({.set = "imazu", .number = 23}).find("they are 1 to 22"), std::string::npos);
  EXPECT_NE(ErrorOf({.set = "single", .name = "head_onn"}).find("did you mean 'head_on'"),
            std::string::npos)
      << ErrorOf({.set = "single", .name = "head_onn"});
  EXPECT_NE(ErrorOf({.set = "random", .num_vessels = 9}).find("2 to 8 vessels, not 9"),
            std::string::npos);
}

TEST(EncounterCommand, WritesTheWordsThatMakeTheSameFileAgain) {
  EncounterChoice choice = {.set = "random", .num_vessels = 3, .seed = 42};
  choice.mission.others_hold = true;
  choice.mission.scale.speed_mps = 2;
  EXPECT_NE(MissionOf(choice).find(
                "# Made by `shoal encounters random --vessels 3 --seed 42 --speed 2 --hold`;"),
            std::string::npos)
      << MissionOf(choice);
}

TEST(EncounterCommand, LetsVesselsFollowTheirLines) {
  EncounterChoice choice = {.set = "overtaking", .number = 3};
  EXPECT_EQ(MissionOf(choice).find("lead ="), std::string::npos);
  choice.mission.lead_m = 8;
  const std::string mission = MissionOf(choice);
  EXPECT_NE(mission.find("`shoal encounters overtaking 3 --lead 8`"), std::string::npos) << mission;
  EXPECT_NE(mission.find("lead = 8\nlead_damper = 1\n"), std::string::npos) << mission;
  EXPECT_NE(ErrorOf({.set = "overtaking", .number = 23}).find("the cases are 1 to 22"),
            std::string::npos);
}

TEST(EncounterCommand, ListsEveryEncounterOnce) {
  std::ostringstream out;
  EXPECT_EQ(ListEncounters(out), kExitOk);
  EXPECT_NE(out.str().find("imazu 22 "), std::string::npos);
  EXPECT_NE(out.str().find("overtaking 22 "), std::string::npos);
  for (const std::string_view name : SingleTargetNames()) {
    EXPECT_NE(out.str().find("single " + std::string(name) + " "), std::string::npos) << name;
  }
}

TEST(EncounterTrials, RefuseAnOverrideThatIsNone) {
  EncounterTrialsOptions options;
  options.num_seeds = 1;
  options.overrides = {"comms.drop_percentag=50"};
  std::ostringstream out;
  std::ostringstream err;
  EXPECT_EQ(RunEncounterTrials(options, out, err), kExitUsage);
  EXPECT_NE(err.str().find("drop_percentage"), std::string::npos) << err.str();
}

}  // namespace shoal::encounters_command_test
