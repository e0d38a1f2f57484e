// [swarm], [vehicle.recovery] and tasks with swarm = "acoustic": what a file makes of them, and
// every error with its exact text.
#include <gtest/gtest.h>

#include <string>

#include "lib/mission/load_testing.h"
#include "lib/mission/swarm_plan.h"

namespace shoal::load_swarm_test {

/// A leader and two followers; what a test appends begins in line 18.
constexpr std::string_view kThree = R"([mission]
duration_s = 60
[[vehicle]]
name = "alpha"
model = "remus100"
[[vehicle]]
name = "bravo"
model = "remus100"
[[vehicle.task]]
kind = "target_track"
target = "ALPHA"
swarm = "acoustic"
[[vehicle]]
name = "charlie"
model = "remus100"
[acoustics]
access_mode = "fdma"
)";

std::string ErrorsWith(std::string_view more, const std::vector<std::string>& overrides = {}) {
  return ErrorsOf(std::string(kThree) + std::string(more), overrides);
}

Mission LoadWith(std::string_view more, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded =
      LoadMissionText(std::string(kThree) + std::string(more), "m.toml", overrides);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  return loaded.mission;
}

TEST(LoadSwarm, TakesTheFollowersFromTheTasksThatFollowTheLeader) {
  const Mission mission = LoadWith("[swarm]\nleader = \"Alpha\"\n");
  EXPECT_EQ(mission.swarm.leader, "alpha");
  EXPECT_EQ(mission.swarm.followers, std::vector<std::string>{"bravo"});
  EXPECT_TRUE(mission.IsInSwarm(mission.vehicles[0]));
  EXPECT_FALSE(mission.IsInSwarm(mission.vehicles[2]));
}

TEST(LoadSwarm, KeepsTheOrderOfTheFollowersThatTheFileNames) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\nfollowers = [\"charlie\", \"bravo\"]\n");
  EXPECT_EQ(mission.swarm.followers, (std::vector<std::string>{"charlie", "bravo"}));
}

TEST(LoadSwarm, MakesTheLeaderOneInTheAccessModeThatHasLeaders) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\n", {"acoustics.access_mode=tdma_lf"});
  EXPECT_TRUE(mission.vehicles[0].acoustic_leader);
  EXPECT_FALSE(mission.vehicles[1].acoustic_leader);
  EXPECT_EQ(SwarmSchemeOf(mission), SwarmScheme::kTdmaLf);
}

TEST(LoadSwarm, ReportsASwarmWithoutALeaderOnce) {
  EXPECT_EQ(ErrorsWith("[swarm]\n"),
            "18:1: swarm lacks 'leader'; for example: leader = \"alpha\"\n");
}

TEST(LoadSwarm, ReportsAnUnknownLeaderWithoutWhatFollowsFromIt) {
  EXPECT_EQ(ErrorsOf("[mission]\nduration_s = 60\n[acoustics]\n[[vehicle]]\nname = \"alpha\"\n"
                     "[swarm]\nleader = \"alpa\"\n"),
            "7:10: unknown vehicle 'alpa' (did you mean 'alpha'?)\n");
}

TEST(LoadSwarm, ReportsTasksWithoutOne) {
  EXPECT_EQ(ErrorsWith(""),
            "12:9: swarm = \"acoustic\" needs an acoustic swarm: write [swarm] and leader = "
            "\"alpha\", or swarm = \"direct\"\n");
}

TEST(LoadSwarm, ReportsInvalidFollowers) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\nfollowers = [\"bravo\", \"alpha\", \"bravo\", "
                       "\"delta\"]\n"),
            "20:13: alpha leads; it is no follower\n"
            "20:13: bravo is named twice\n"
            "20:13: unknown vehicle 'delta'; the mission has alpha, bravo, charlie\n");
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"charlie\"\nfollowers = [\"alpha\"]\n"),
            "11:10: only the leader of [swarm], charlie, reports its position to followers over "
            "the acoustic network\n");
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\nfollowers = [\"charlie\"]\n"),
            "12:9: bravo is not among the followers of [swarm]: add it, or leave followers out\n");
}

TEST(LoadSwarm, ReportsASchedulerThatTheChannelsDoNotAllow) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\nscheduler = \"fdma_lf\"\n",
                       {"acoustics.access_mode=tdma"}),
            "20:13: fdma_lf needs a channel for each vehicle: write access_mode = \"fdma\" in "
            "[acoustics], or scheduler = \"tdma\"\n");
}

TEST(LoadSwarm, ReportsEpisodesThatAreTooShort) {
  const std::string text = ErrorsWith("[swarm]\nleader = \"alpha\"\nepisode_s = 0.5\n");
  EXPECT_TRUE(text.starts_with("20:13: episode_s = 0.5 ")) << text;
  EXPECT_NE(text.find("use at least"), std::string::npos) << text;
}

TEST(LoadSwarm, ReportsAnInvalidGroupId) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\ngroup_id = \"-\"\n"),
            "20:12: group_id must be a letter or a digit\n");
}

TEST(LoadSwarm, ReportsAddressesTooFarApart) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\n", {"vehicle.bravo.acoustic_address=1002"}),
            "19:10: the acoustic_address of alpha is 1 and that of bravo 1002: members farther "
            "than 1000 apart take each other's messages for damaged\n");
}

TEST(LoadSwarm, ReportsMembersThatCannotBeReceived) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\n", {"vehicle.alpha.start.x_m=150000"}),
            "19:10: alpha starts more than 100 km from the origin, farther than the messages of a "
            "swarm can encode: move [mission] origin\n");
  EXPECT_EQ(
      ErrorsWith("[swarm]\nleader = \"alpha\"\n",
                 {"vehicle.bravo.acoustic_leader=true", "acoustics.access_mode=tdma_lf"}),
      "18:1: bravo has acoustic_leader = true: it would not receive alpha; only the leader of "
      "[swarm] may have it\n");
}

TEST(LoadSwarm, WarnsOfSlotsThatComeTooLate) {
  const auto warnings = [](std::string_view keys) {
    const LoadedMission loaded = LoadMissionText(
        std::string(kThree) + "[swarm]\nleader = \"alpha\"\n" + std::string(keys), "m.toml");
    EXPECT_EQ(loaded.errors, std::vector<std::string>());
    return WarningsBesideConduct(loaded);
  };
  EXPECT_TRUE(warnings("").empty());
  EXPECT_EQ(warnings("offset_s = 100\n"),
            std::vector<std::string>{
                "m.toml:20:12: warning: bravo sends first after 100 s, when the mission is over"});
  EXPECT_EQ(warnings("episode_s = 70\nsilent_after_s = 80\n"),
            std::vector<std::string>{
                "m.toml:20:13: warning: an episode takes 70 s, longer than the mission"});
  EXPECT_EQ(warnings("silent_after_s = 3\n"),
            std::vector<std::string>{
                "m.toml:20:18: warning: every member counts as silent 3 s after a message, "
                "and the next comes after 5 s"});
}

TEST(LoadSwarm, ReportsExpectationsThatCanNeverHold) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\n[[expect]]\nkind = \"swarm\"\nfrom = "
                       "\"charlie\"\nat_least_pct = 5\n"),
            "22:8: charlie is not in the swarm: this can never hold\n");
}

TEST(LoadRecovery, ReplacesTheStrategiesOfTheFieldsThatItNames) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\n", {"vehicle.bravo.recovery.time_stamp=[\"skip\"]"});
  const RecoveryPlan& plan = mission.vehicles[1].recovery;
  EXPECT_EQ(plan.of(SwarmField::kTimeStamp), RecoveryOrder{RecoveryStrategy::kSkip});
  EXPECT_EQ(plan.of(SwarmField::kGroupId), RecoveryPlan().of(SwarmField::kGroupId));
  EXPECT_EQ(mission.vehicles[0].recovery, RecoveryPlan());
}

TEST(LoadRecovery, ReportsUnknownStrategies) {
  EXPECT_EQ(ErrorsOf("[mission]\nduration_s = 60\n[[vehicle]]\nname = \"alpha\"\n"
                     "[vehicle.recovery]\ntime_stamp = [\"previos\"]\npos = []\n"),
            "6:14: unknown strategy 'previos' (did you mean 'previous'?); there are: predict, "
            "previous, neutral, sentinel, skip_field, skip\n"
            "7:1: unknown key 'pos' (did you mean 'leader_pos'?)\n");
}

TEST(PlanSwarm, GivesMunetsSlotsToFdmaAndTheShortestToTheOthers) {
  const Mission fdma = LoadWith("[swarm]\nleader = \"alpha\"\n");
  EXPECT_EQ(PlanSwarm(fdma).plan.episode_us, 5'000'000);
  EXPECT_EQ(PlanSwarm(fdma).plan.offset_us, 500'000);

  const Mission tdma_lf =
      LoadWith("[swarm]\nleader = \"alpha\"\n", {"acoustics.access_mode=tdma_lf"});
  const SlotPlan plan = PlanSwarm(tdma_lf).plan;
  // 101 bytes and the broker's CRC, 4, at 1000 bit/s: 0.84 s; 0.67 s of travel, 0.2 s of jitter.
  EXPECT_GE(plan.broadcast_us, 1'710'000);
  EXPECT_LE(plan.broadcast_us, 2'100'000);
  EXPECT_EQ(plan.episode_us, plan.broadcast_us + plan.response_us);
}

TEST(PlanSwarm, TakesTheLengthsOfTheFile) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\nbroadcast_s = 4\nresponse_s = 3\nepisode_s = 20\n",
               {"acoustics.access_mode=tdma_lf"});
  const SlotPlan plan = PlanSwarm(mission).plan;
  EXPECT_EQ(plan.broadcast_us, 4'000'000);
  EXPECT_EQ(plan.response_us, 3'000'000);
  EXPECT_EQ(plan.episode_us, 20'000'000);
}

TEST(PlanSwarm, LengthensAnAutomaticEpisodeForLongerSlots) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\nresponse_s = 30\n", {"acoustics.access_mode=tdma_lf"});
  EXPECT_GE(PlanSwarm(mission).plan.episode_us, 30'000'000 + PlanSwarm(mission).plan.broadcast_us);
}

TEST(PlanSwarm, HasRoomForChecksumAndFrame) {
  const Mission bare = LoadWith("[swarm]\nleader = \"alpha\"\n", {"acoustics.crc=false"});
  const Mission framed =
      LoadWith("[swarm]\nleader = \"alpha\"\nframes = true\n", {"acoustics.crc=true"});
  EXPECT_EQ(SwarmAirOf(bare).extra_bytes, 0);
  EXPECT_EQ(SwarmAirOf(framed).extra_bytes, 10);
}

}  // namespace shoal::load_swarm_test
