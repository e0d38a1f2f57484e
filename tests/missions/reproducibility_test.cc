// Same mission, seed and build: the same log, byte for byte, however the mission runs.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/missions/shoal_process.h"

namespace shoal::reproducibility_test {

/// Returns the log of `shoal sim`.
std::string SimLog(const TestFolder& folder, const std::string& mission,
                   std::vector<std::string> extra = {}) {
  const std::string log = (folder / "sim.lcm").string();
  std::vector<std::string> arguments = {"sim", mission, "--log", log};
  arguments.insert(arguments.end(), extra.begin(), extra.end());
  const Finished finished = RunShoal(folder, arguments);
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  return ReadFile(log);
}

/// Returns the log of `shoal run` at full speed.
std::string RunLog(const TestFolder& folder, const std::string& mission,
                   std::vector<std::string> extra = {}) {
  const std::string dir = (folder / "recorded").string();
  std::filesystem::remove_all(dir);
  std::vector<std::string> arguments = {"run", mission, "--warp", "max", "--record", dir};
  arguments.insert(arguments.end(), extra.begin(), extra.end());
  const Finished finished = RunShoal(folder, arguments);
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("PASS"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  return ReadFile(dir + "/mission.lcm");
}

TEST(Reproducibility, HoldsInOneProcessAndOverLcmInBothLayoutsAndAtAnySpeed) {
  const TestFolder folder;
  const std::string mission = MissionFile("berta.toml");
  const std::string reference = SimLog(folder, mission);
  ASSERT_GT(reference.size(), 1'000'000U);
  EXPECT_TRUE(reference == SimLog(folder, mission)) << "two runs of shoal sim differ";
  EXPECT_TRUE(reference == RunLog(folder, mission, {"--layout", "shared"}));
  EXPECT_TRUE(reference == RunLog(folder, mission, {"--layout", "communities"}));
  EXPECT_TRUE(reference == RunLog(folder, mission, {"--warp", "60"}));
}

// glibc takes other functions where the processor has fewer instructions.
TEST(Reproducibility, HoldsOnProcessorsWithFewerInstructions) {
  for (const std::string name :
       {"alpha", "berta", "remus_path", "swarm_fdma", "acoustic", "dvl_drift"}) {
    const TestFolder folder;
    const std::string mission = MissionFile(name + ".toml");
    const std::string reference = SimLog(folder, mission);
    setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable", 1);
    EXPECT_TRUE(reference == SimLog(folder, mission)) << name;
    unsetenv("GLIBC_TUNABLES");
  }
}

TEST(Reproducibility, HoldsForOneVessel) {
  const TestFolder folder;
  const std::string mission = MissionFile("alpha.toml");
  EXPECT_TRUE(SimLog(folder, mission) == RunLog(folder, mission));
}

TEST(Reproducibility, HoldsForAcousticPackets) {
  const TestFolder folder;
  const std::string mission = MissionFile("acoustic.toml");
  EXPECT_TRUE(SimLog(folder, mission) == RunLog(folder, mission, {"--layout", "communities"}));
  const std::string shared = MissionFile("acoustic_shared.toml");
  EXPECT_TRUE(SimLog(folder, shared) == SimLog(folder, shared));
}

TEST(Reproducibility, HoldsWhereSoundBends) {
  const TestFolder folder;
  const std::string mission = MissionFile("summer_shadow.toml");
  EXPECT_TRUE(SimLog(folder, mission) == RunLog(folder, mission));
}

TEST(Reproducibility, HoldsForSonarsNoiseAndPlumes) {
  const TestFolder folder;
  const std::string mission = MissionFile("sonar.toml");
  EXPECT_TRUE(SimLog(folder, mission) == RunLog(folder, mission, {"--layout", "shared"}));
}

TEST(Reproducibility, HoldsForRecordedTracks) {
  const TestFolder folder;
  const std::string mission = MissionFile("track_replay.toml");
  EXPECT_TRUE(SimLog(folder, mission) == RunLog(folder, mission));
}

TEST(Reproducibility, HoldsForACurrentFromNetcdfAndForItsRecording) {
#ifndef SHOAL_HAS_NETCDF
  GTEST_SKIP() << "no libnetcdf: scripts/setup installs it";
#else
  const TestFolder folder;
  const std::string mission = MissionFile("tidal_channel.toml");
  const std::string reference = SimLog(folder, mission);
  EXPECT_TRUE(reference == RunLog(folder, mission));
  // The recording holds the grid too, and is a mission of its own.
  const std::string recorded = (folder / "recorded").string();
  EXPECT_TRUE(reference == SimLog(folder, recorded + "/mission.toml"));
  EXPECT_EQ(ReadFile(recorded + "/data/tidal_channel.nc"),
            ReadFile(MissionFile("data/tidal_channel.nc")));
#endif
}

TEST(Reproducibility, HoldsForTwoSwarmsOnOneNetwork) {
  const TestFolder folder;
  const std::string mission = MissionFile("two_swarms.toml");
  EXPECT_TRUE(SimLog(folder, mission) == RunLog(folder, mission));
}

TEST(Reproducibility, HoldsForASwarmThatCommunicates) {
  const TestFolder folder;
  const std::string mission = MissionFile("swarm_lossy.toml");
  const std::string shorter = "mission.duration_s=300";
  EXPECT_TRUE(SimLog(folder, mission, {"--set", shorter}) ==
              RunLog(folder, mission, {"--set", shorter}));
}

TEST(Reproducibility, HoldsForHelmsThatWeighBehaviors) {
  const TestFolder folder;
  const std::string mission = MissionFile("encounters/imazu_16.toml");
  const std::string lossy = "comms.drop_percentage=30";
  const std::string reference = SimLog(folder, mission, {"--set", lossy});
  EXPECT_NE(reference.find("HELM_DECISION_OWN"), std::string::npos);
  EXPECT_TRUE(reference == RunLog(folder, mission, {"--set", lossy, "--layout", "communities"}));
}

TEST(Reproducibility, HoldsWhenTheBusLosesDatagrams) {
  const TestFolder folder;
  const std::string mission = MissionFile("alpha.toml");
  const std::string dir = (folder / "lossy").string();
  const Finished finished =
      RunShoal(folder, {"run", mission, "--warp", "max", "--record", dir, "--lose", "0.002"});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_EQ(finished.output.find(" 0 asked for again, 0 ticks again"), std::string::npos)
      << "nothing was lost, so nothing was tested: " << finished.output;
  EXPECT_TRUE(SimLog(folder, mission) == ReadFile(dir + "/mission.lcm"));
}

TEST(Reproducibility, ChangesWithTheSeedOnlyWhereRandomnessIsUsed) {
  const TestFolder folder;
  const std::string mission = MissionFile("alpha.toml");
  // The broker publishes the seed in COMMS_RULES.
  const auto without_broker = [&](const std::string& seed) {
    return SimLog(folder, mission, {"--set", "mission.shore_broker=none", "--set", seed});
  };
  EXPECT_TRUE(without_broker("mission.seed=1") == without_broker("mission.seed=2"))
      << "alpha uses no randomness";
  const std::vector<std::string> random = {"--set", "vehicle.alpha.reporter.blackout_interval_s=2",
                                           "--set", "vehicle.alpha.reporter.blackout_variance_s=1"};
  const auto with_seed = [&](const std::string& seed) {
    std::vector<std::string> extra = random;
    extra.insert(extra.end(), {"--set", "mission.seed=" + seed});
    return SimLog(folder, mission, extra);
  };
  EXPECT_TRUE(with_seed("1") == with_seed("1"));
  EXPECT_FALSE(with_seed("1") == with_seed("2")) << "blackouts are random";
}

}  // namespace shoal::reproducibility_test
