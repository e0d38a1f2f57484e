// [swarm], [vehicle.recovery] and tasks with swarm = "acoustic": what a file makes of them, and
// every error with its exact text.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "lib/mission/file/load_testing.h"
#include "lib/mission/model/swarm_plan.h"

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

/// Of [swarm] with alpha as its leader; `keys` begin in line 20.
std::vector<std::string> WarningsWith(std::string_view keys,
                                      const std::vector<std::string>& overrides) {
  const LoadedMission loaded =
      LoadMissionText(std::string(kThree) + "[swarm]\nleader = \"alpha\"\n" + std::string(keys),
                      "m.toml", overrides);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  return WarningsBesideConduct(loaded);
}

TEST(LoadSwarm, TakesTheFollowersFromTheTasksThatFollowTheLeader) {
  const Mission mission = LoadWith("[swarm]\nleader = \"Alpha\"\n");
  EXPECT_EQ(mission.swarms[0].leader, "alpha");
  EXPECT_EQ(mission.swarms[0].followers, std::vector<std::string>{"bravo"});
  EXPECT_NE(mission.SwarmOf(mission.vehicles[0]), nullptr);
  EXPECT_EQ(mission.SwarmOf(mission.vehicles[2]), nullptr);
}

TEST(LoadSwarm, KeepsTheOrderOfTheFollowersThatTheFileNames) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\nfollowers = [\"charlie\", \"bravo\"]\n");
  EXPECT_EQ(mission.swarms[0].followers, (std::vector<std::string>{"charlie", "bravo"}));
}

TEST(LoadSwarm, MakesTheLeaderOneInTheAccessModeThatHasLeaders) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\n", {"acoustics.access_mode=tdma_lf"});
  EXPECT_TRUE(mission.vehicles[0].acoustic_leader);
  EXPECT_FALSE(mission.vehicles[1].acoustic_leader);
  EXPECT_EQ(SwarmSchemeOf(mission, mission.swarms[0]), SwarmScheme::kTdmaLf);
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
            "20:13: alpha leads; it is not a follower\n"
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
    return WarningsWith(keys, {"comms.comms_range=nolimit"});
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

TEST(LoadSwarm, WarnsOfMembersThatMayBeFartherApartThanPacketsAreLetThrough) {
  const auto warnings = [](const std::string& range) {
    return WarningsWith("max_distance_m = 800\n", {"comms.comms_range=" + range});
  };
  EXPECT_TRUE(warnings("nolimit").empty());
  EXPECT_TRUE(warnings("800").empty());
  EXPECT_EQ(warnings("799"),
            std::vector<std::string>{
                "m.toml:20:18: warning: members may be 800 m apart, and comms_range lets packets "
                "through up to 799 m: write comms_range = \"nolimit\" in [comms], which leaves the "
                "range to the acoustic network, or max_distance_m = 799"});
}

TEST(LoadSwarm, WarnsOfMembersWithNeitherReportsNorASimulator) {
  const auto warnings = [](std::vector<std::string> overrides) {
    overrides.emplace_back("comms.comms_range=nolimit");
    return WarningsWith("", overrides);
  };
  const std::string warning =
      "m.toml:19:10: warning: node_reporter and vehicle_sim of alpha are \"none\": unless a "
      "program of yours sends its reports or NAV, the broker does not know where it is, and none "
      "of its messages is sent or received";
  EXPECT_TRUE(warnings({"vehicle.alpha.node_reporter=none"}).empty());
  const std::vector<std::string> of_both =
      warnings({"vehicle.alpha.node_reporter=none", "vehicle.alpha.vehicle_sim=none"});
  EXPECT_NE(std::ranges::find(of_both, warning), of_both.end());
}

TEST(LoadSwarm, PlansSlotsByTheAcousticMediumThatItGoesOver) {
  const std::string text =
      "[mission]\nduration_s = 60\n[comms]\ncomms_range = \"nolimit\"\n"
      "[[medium]]\nname = \"deep\"\nkind = \"acoustic\"\naccess_mode = \"shared\"\n"
      "data_rate_bps = 250\njitter = \"off\"\n"
      "[swarm]\nleader = \"alpha\"\nfollowers = [\"bravo\"]\nover = \"deep\"\n"
      "[[vehicle]]\nname = \"alpha\"\nmodel = \"remus100\"\nmedia = [\"deep\"]\n"
      "[[vehicle]]\nname = \"bravo\"\nmodel = \"remus100\"\nmedia = [\"deep\"]\n";
  const LoadedMission loaded = LoadMissionText(text, "m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(&PacketAcousticsOf(loaded.mission), &loaded.mission.media.at(0).acoustics);
  EXPECT_EQ(SwarmAirOf(loaded.mission, loaded.mission.swarms[0]).data_rate_bps, 250);
  EXPECT_EQ(SwarmSchemeOf(loaded.mission, loaded.mission.swarms[0]), SwarmScheme::kTdma);
}

TEST(LoadSwarm, WarnsOfKeysWithoutEffect) {
  const auto warnings = [](std::string_view keys, const std::string& mode) {
    return WarningsWith(keys, {"comms.comms_range=nolimit", "acoustics.access_mode=" + mode});
  };
  EXPECT_TRUE(warnings("offset_s = 0.5\n", "fdma").empty());
  EXPECT_TRUE(warnings("broadcast_s = 4\nresponse_s = 3\n", "tdma_lf").empty());
  EXPECT_TRUE(warnings("broadcast_s = \"auto\"\n", "fdma").empty()) << "as --explain writes it";
  EXPECT_EQ(warnings("broadcast_s = 4\nresponse_s = 3\n", "fdma"),
            (std::vector<std::string>{
                "m.toml:20:15: warning: broadcast_s has no effect here: only with scheduler = "
                "\"tdma_lf\" a leader asks and followers answer; leave it out",
                "m.toml:21:14: warning: response_s has no effect here: only with scheduler = "
                "\"tdma_lf\" a leader asks and followers answer; leave it out"}));
  EXPECT_EQ(warnings("offset_s = 0.5\n", "tdma_lf"),
            std::vector<std::string>{
                "m.toml:20:12: warning: offset_s has no effect here: with tdma_lf the leader's "
                "request gives each follower its slot; leave it out"});
}

TEST(LoadSwarm, WarnsOfALeaderThatIsMadeNone) {
  EXPECT_TRUE(WarningsWith("", {"comms.comms_range=nolimit", "vehicle.alpha.acoustic_leader=true"})
                  .empty());
  EXPECT_EQ(
      WarningsWith("", {"comms.comms_range=nolimit", "vehicle.alpha.acoustic_leader=false"}).size(),
      1U);
}

TEST(LoadSwarm, ReportsExpectationsThatCanNeverHold) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\n[[expect]]\nkind = \"swarm\"\nfrom = "
                       "\"charlie\"\nat_least_pct = 5\n"),
            "22:8: charlie is not in the swarm: this can never hold\n");
}

TEST(LoadSwarmFields, TakesLimitsNeutralAndSentinelValues) {
  const Mission mission = LoadWith(
      "[swarm]\nleader = \"alpha\"\n[swarm.fields]\nmax_position_m = 5000\n"
      "future_tolerance_s = 2.5\nlate_start_s = 3\nneutral_position_m = [1, 2, 3]\n"
      "sentinel_position_m = 6000\n");
  EXPECT_EQ(mission.swarms[0].limits.max_position_m, 5000);
  EXPECT_EQ(mission.swarms[0].limits.future_tolerance_us, 2'500'000);
  EXPECT_EQ(mission.swarms[0].limits.max_speed_mps, 100);
  EXPECT_EQ(mission.swarms[0].late_start_s, 3);
  EXPECT_EQ(mission.swarms[0].neutral.position_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(mission.swarms[0].sentinel, (SentinelValues{.position_m = 6000, .speed_mps = -999}));
}

TEST(LoadSwarmFields, ReportsASentinelThatAMemberCouldSendAndANeutralValueThatItCouldNot) {
  EXPECT_EQ(
      ErrorsWith("[swarm]\nleader = \"alpha\"\n[swarm.fields]\nmax_speed_mps = 5\n"
                 "sentinel_speed_mps = -5\nneutral_velocity_mps = [0, 6, 0]\n"),
      "22:22: sentinel_speed_mps must be beyond max_speed_mps = 5: a sentinel is not a value that "
      "a member can send\n"
      "23:24: neutral_velocity_mps must not be beyond max_speed_mps = 5\n");
}

TEST(LoadSwarmFields, ReportsMoreFollowersThanARequestMayName) {
  EXPECT_EQ(ErrorsWith("[swarm]\nleader = \"alpha\"\nfollowers = [\"bravo\", \"charlie\"]\n"
                       "[swarm.fields]\nmax_followers = 1\n"),
            "20:13: 2 followers are more than max_followers = 1 of [swarm.fields]: their requests "
            "would count as damaged\n");
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
  EXPECT_EQ(PlanSwarm(fdma, fdma.swarms[0]).plan.episode_us, 5'000'000);
  EXPECT_EQ(PlanSwarm(fdma, fdma.swarms[0]).plan.offset_us, 500'000);

  const Mission tdma_lf =
      LoadWith("[swarm]\nleader = \"alpha\"\n", {"acoustics.access_mode=tdma_lf"});
  const SlotPlan plan = PlanSwarm(tdma_lf, tdma_lf.swarms[0]).plan;
  // 101 bytes and the broker's CRC, 4, at 1000 bit/s: 0.84 s; 0.67 s of travel, 0.2 s of jitter.
  EXPECT_GE(plan.broadcast_us, 1'710'000);
  EXPECT_LE(plan.broadcast_us, 2'100'000);
  EXPECT_EQ(plan.episode_us, plan.broadcast_us + plan.response_us);
}

TEST(PlanSwarm, TakesTheLengthsOfTheFile) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\nbroadcast_s = 4\nresponse_s = 3\nepisode_s = 20\n",
               {"acoustics.access_mode=tdma_lf"});
  const SlotPlan plan = PlanSwarm(mission, mission.swarms[0]).plan;
  EXPECT_EQ(plan.broadcast_us, 4'000'000);
  EXPECT_EQ(plan.response_us, 3'000'000);
  EXPECT_EQ(plan.episode_us, 20'000'000);
}

TEST(PlanSwarm, LengthensAnAutomaticEpisodeForLongerSlots) {
  const Mission mission =
      LoadWith("[swarm]\nleader = \"alpha\"\nresponse_s = 30\n", {"acoustics.access_mode=tdma_lf"});
  EXPECT_GE(PlanSwarm(mission, mission.swarms[0]).plan.episode_us,
            30'000'000 + PlanSwarm(mission, mission.swarms[0]).plan.broadcast_us);
}

TEST(PlanSwarm, HasRoomForChecksumAndFrame) {
  const Mission bare = LoadWith("[swarm]\nleader = \"alpha\"\n", {"acoustics.crc=false"});
  const Mission framed =
      LoadWith("[swarm]\nleader = \"alpha\"\nframes = true\n", {"acoustics.crc=true"});
  EXPECT_EQ(SwarmAirOf(bare, bare.swarms[0]).extra_bytes, 0);
  EXPECT_EQ(SwarmAirOf(framed, framed.swarms[0]).extra_bytes, 10);
}

}  // namespace shoal::load_swarm_test
