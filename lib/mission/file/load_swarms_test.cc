// [[swarm]]: several swarms in one mission, and every error with its exact text.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lib/mission/file/load_media.h"
#include "lib/mission/file/load_testing.h"
#include "lib/mission/model/swarm_plan.h"

namespace shoal::load_swarms_test {

/// Two leaders with a follower each; what a test appends begins in line 23.
std::string Four(const std::string& access_mode = "fdma") {
  std::string text = "[mission]\nduration_s = 60\n[comms]\ncomms_range = \"nolimit\"\n";
  for (const std::string name : {"alpha", "bravo", "charlie", "delta"}) {
    text += "[[vehicle]]\nname = \"" + name + "\"\nmodel = \"remus100\"\n";
    text += std::string("group = \"") + (name < "c" ? "upper" : "lower") + "\"\n";
  }
  return text + "[acoustics]\naccess_mode = \"" + access_mode + "\"\n";
}

const std::string kNorth =
    "[[swarm]]\nname = \"north\"\nleader = \"alpha\"\nmembers = [\"alpha\", \"BRAVO\"]\n";
const std::string kSouth = "[[swarm]]\nname = \"south\"\nleader = \"charlie\"\ngroup = \"lower\"\n";

LoadedMission Load(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return LoadMissionText(text, "m.toml", overrides);
}

Mission LoadSound(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded = Load(text, overrides);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  return loaded.mission;
}

std::string ErrorsWith(const std::string& swarms) { return ErrorsOf(Four() + swarms); }

TEST(LoadSwarms, TakesMembersByNameOrGroupWithoutTheLeader) {
  const Mission mission = LoadSound(Four() + kNorth + kSouth);
  ASSERT_EQ(mission.swarms.size(), 2U);
  EXPECT_EQ(mission.swarms[0].followers, std::vector<std::string>{"bravo"});
  EXPECT_EQ(mission.swarms[1].followers, std::vector<std::string>{"delta"});
  EXPECT_EQ(mission.SwarmOf(mission.vehicles[1]), &mission.swarms[0]);
  EXPECT_EQ(mission.SwarmOf(mission.vehicles[2]), &mission.swarms[1]);
}

TEST(LoadSwarms, GivesEachAGroupIdThatNoOtherHas) {
  const Mission mission = LoadSound(Four() + kNorth + kSouth);
  EXPECT_EQ(mission.swarms[0].group_id, "A");
  EXPECT_EQ(mission.swarms[1].group_id, "B");
  const Mission chosen = LoadSound(Four() + kNorth + kSouth + "group_id = \"A\"\n");
  EXPECT_EQ(chosen.swarms[0].group_id, "B");
  EXPECT_EQ(chosen.swarms[1].group_id, "A");
}

TEST(LoadSwarms, MakesEveryLeaderOneOfTheNetwork) {
  const Mission mission = LoadSound(Four() + kNorth + kSouth);
  std::vector<bool> lead;
  for (const Vehicle& vehicle : mission.vehicles) lead.push_back(vehicle.acoustic_leader);
  EXPECT_EQ(lead, (std::vector<bool>{true, false, true, false}));
}

TEST(LoadSwarms, TakesOverridesByName) {
  const Mission mission = LoadSound(Four() + kNorth + kSouth, {"swarm.south.episode_s=7"});
  EXPECT_EQ(PlanSwarm(mission, mission.swarms[0]).plan.episode_us, 5'000'000);
  EXPECT_EQ(PlanSwarm(mission, mission.swarms[1]).plan.episode_us, 7'000'000);
}

TEST(LoadSwarms, IsTheSameMissionWhenItIsExplained) {
  Mission mission = LoadSound(Four() + kNorth + kSouth);
  const std::string text = Explain(mission);
  EXPECT_NE(text.find("[[swarm]]\nname = \"north\""), std::string::npos) << text;
  EXPECT_EQ(LoadSound(text), mission);
}

TEST(LoadSwarms, SendThePacketsOfEachOverItsOwnMedium) {
  const std::string deep =
      "[[medium]]\nname = \"deep\"\nkind = \"acoustic\"\ndata_rate_bps = 250\n";
  const Mission mission = LoadSound(Four() + deep + kNorth + kSouth + "over = \"deep\"\n");
  const MediaSetup setup = MediaOf(mission);
  EXPECT_EQ(setup.PacketsOver("alpha"), Over("acoustic"));
  EXPECT_EQ(setup.PacketsOver("DELTA"), Over("deep"));
  EXPECT_EQ(SwarmAirOf(mission, mission.swarms[1]).data_rate_bps, 250);
  const LoadedMedia again = LoadMediaText(ExplainMedia(setup), "text");
  EXPECT_EQ(again.errors, std::vector<std::string>());
  EXPECT_EQ(again.setup.packets_of, setup.packets_of);
}

TEST(LoadSwarms, RefusesAVehicleInTwo) {
  EXPECT_EQ(ErrorsWith(kNorth + "[[swarm]]\nname = \"south\"\nleader = \"charlie\"\n"
                                "members = [\"bravo\", \"delta\"]\n"),
            "27:1: bravo is in the swarm 'north' already: a vehicle can be in one only\n");
}

TEST(LoadSwarms, RefusesANameThatTwoHave) {
  EXPECT_EQ(ErrorsWith(kNorth + "[[swarm]]\nname = \"north\"\nleader = \"charlie\"\n"
                                "group = \"lower\"\n"),
            "28:8: a swarm 'north' exists already: give this one another name\n");
}

TEST(LoadSwarms, RefusesOneWithoutALeaderOrName) {
  EXPECT_EQ(ErrorsWith(kNorth + "[[swarm]]\ngroup = \"lower\"\n"),
            "27:1: swarm lacks 'leader'; for example: leader = \"alpha\"\n"
            "27:1: swarm lacks 'name'; for example: name = \"north\"\n");
}

TEST(LoadSwarms, RefusesMembersThatAreNamedInTwoWays) {
  EXPECT_EQ(ErrorsWith(kNorth + "group = \"upper\"\n"),
            "24:8: members, group and followers all name the members: write one of them\n");
}

TEST(LoadSwarms, RefusesAGroupThatNoVehicleHas) {
  const std::string errors = ErrorsWith(kNorth +
                                        "[[swarm]]\nname = \"south\"\n"
                                        "leader = \"charlie\"\ngroup = \"lowest\"\n");
  EXPECT_EQ(errors.find("30:9: no vehicle is of group 'lowest'"), 0U) << errors;
}

TEST(LoadSwarms, RefusesTheSameGroupIdOnOneNetwork) {
  EXPECT_EQ(ErrorsWith(kNorth + "group_id = \"x\"\n" + kSouth + "group_id = \"x\"\n"),
            "32:12: the swarm 'north' has group_id = 'x' too, on the same network: leave both out, "
            "or give this one another\n");
}

TEST(LoadSwarms, RefusesFramesOfOneOnlyOnOneNetwork) {
  EXPECT_EQ(ErrorsWith(kNorth + kSouth + "frames = true\n"),
            "31:10: the swarm 'north' on the same network has frames = false: each would take the "
            "other's messages for damaged ones\n");
}

std::vector<std::string> OverlapsOf(const std::string& text) {
  std::vector<std::string> overlaps = Load(text).warnings;
  std::erase_if(overlaps, [](const std::string& warning) {
    return warning.find("overlap on one channel") == std::string::npos;
  });
  return overlaps;
}

TEST(LoadSwarms, WarnsOfSlotsThatOverlapOnOneChannelOnly) {
  const std::string both = kNorth + kSouth;
  EXPECT_TRUE(OverlapsOf(Four("fdma") + both).empty());
  EXPECT_EQ(OverlapsOf(Four("tdma") + both),
            std::vector<std::string>{
                "m.toml:29:10: warning: slots of alpha of the swarm 'north' and of charlie of "
                "'south' overlap on one channel, which damages both messages: write access_mode = "
                "\"fdma\" in the network's table, or let over name another [[medium]]"});
  EXPECT_TRUE(OverlapsOf(Four("tdma") + "collisions = \"off\"\n" + both).empty());
}

TEST(LoadSwarms, RefusesNamesAndGroupsInTheTableOfOneSwarm) {
  EXPECT_NE(ErrorsWith("[swarm]\nleader = \"alpha\"\nname = \"north\"\n"
                       "followers = [\"bravo\"]\n")
                .find("25:1: unknown key 'name'"),
            std::string::npos);
}

}  // namespace shoal::load_swarms_test
