// However the participants share processes, a mission's log is the same, byte for byte.
#include <gtest/gtest.h>

#include "tests/missions/shoal_process.h"

namespace shoal::grouping_test {

/// Returns the log of `shoal run` at full speed.
std::string RunLog(const TestFolder& folder, const std::string& mission,
                   const std::vector<std::string>& extra) {
  const std::string dir = (folder / "recorded").string();
  std::filesystem::remove_all(dir);
  std::vector<std::string> arguments = {"run", mission, "--warp", "max", "--record", dir};
  arguments.insert(arguments.end(), extra.begin(), extra.end());
  const Finished finished = RunShoal(folder, arguments);
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  return ReadFile(dir + "/mission.lcm");
}

/// Returns the log of `shoal sim`.
std::string SimLog(const TestFolder& folder, const std::string& mission,
                   const std::vector<std::string>& extra) {
  const std::string log = (folder / "sim.lcm").string();
  std::vector<std::string> arguments = {"sim", mission, "--log", log};
  arguments.insert(arguments.end(), extra.begin(), extra.end());
  const Finished finished = RunShoal(folder, arguments);
  EXPECT_NE(finished.exit_code, 2) << finished.output;
  return ReadFile(log);
}

class EachMission : public testing::TestWithParam<std::string> {};

TEST_P(EachMission, HasTheSameLogInAllGroupings) {
  const TestFolder folder;
  const std::string mission = MissionFile(GetParam() + ".toml");
  std::vector<std::string> shorter;
  if (GetParam() == "acoustic_shared") shorter = {"--set", "mission.duration_s=200"};
  if (GetParam() == "swarm20") {
    shorter = {"--set", "mission.duration_s=30", "--set", "expect.2.from_s=0"};
  }
  const std::string reference = SimLog(folder, mission, shorter);
  ASSERT_GT(reference.size(), 100'000U);
  for (const std::string grouping : {"app", "vehicle", "host=1", "host=2"}) {
    std::vector<std::string> extra = shorter;
    extra.insert(extra.end(), {"--grouping", grouping});
    EXPECT_TRUE(reference == RunLog(folder, mission, extra)) << grouping;
  }
}

INSTANTIATE_TEST_SUITE_P(Grouping, EachMission,
                         testing::Values("alpha", "berta", "acoustic_shared", "fleet", "swarm20",
                                         "track_replay"),
                         [](const auto& each) { return each.param; });

TEST(Grouping, HasRoomForAUsersOwnParticipant) {
  const TestFolder folder;
  const std::string mission = MissionFile("hide_and_seek.toml");  // With examples/referee.
  const auto log_of = [&](const std::string& grouping) {
    return RunLog(folder, mission, {"--grouping", grouping});
  };
  const std::string reference = log_of("app");
  EXPECT_NE(reference.find("UNC_STEALTH"), std::string::npos) << "the referee takes part";
  EXPECT_TRUE(reference == log_of("vehicle"));
  EXPECT_TRUE(reference == log_of("host=2"));
}

TEST(Grouping, HasRoomForAHelmThatAUserStarts) {
  const TestFolder folder;
  const std::string mission = MissionFile("berta.toml");
  const std::string reference = SimLog(folder, mission, {});
  const std::string dir = (folder / "by_hand").string();
  RunningProcess run(folder, {Program("shoal"), "run", mission, "--warp", "max", "--record", dir,
                              "--grouping", "vehicle", "--set", "vehicle.bravo.helm=hand"});
  ASSERT_TRUE(run.WaitFor("waiting for helm_bravo")) << run.Output();
  RunningProcess helm(folder, {Program("helm"), "--mission", mission, "--vehicle", "bravo"});
  const Finished finished = run.Wait();
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("9 participants in 6 processes"), std::string::npos)
      << finished.output;
  EXPECT_TRUE(reference == ReadFile(dir + "/mission.lcm"));
  EXPECT_EQ(helm.Wait().exit_code, 0);
}

TEST(Grouping, RepairsWhatTheBusLoses) {
  const TestFolder folder;
  const std::string mission = MissionFile("berta.toml");
  const std::string dir = (folder / "lossy").string();
  const Finished finished = RunShoal(folder, {"run", mission, "--warp", "max", "--record", dir,
                                              "--lose", "0.001", "--grouping", "vehicle"});
  EXPECT_EQ(finished.output.find(" 0 asked for again, 0 ticks again"), std::string::npos)
      << "nothing was lost, so nothing was tested: " << finished.output;
  EXPECT_TRUE(SimLog(folder, mission, {}) == ReadFile(dir + "/mission.lcm")) << finished.output;
}

TEST(Grouping, ShowsThePageOfEachParticipant) {
  const TestFolder folder;
  RunningProcess run(folder, {Program("shoal"), "run", MissionFile("berta.toml"), "--warp", "1",
                              "--grouping", "host=1"});
  const std::string page = AwaitStatus(folder, "helm_bravo", {"helm_bravo", "published"});
  EXPECT_EQ(page.find("helm_alpha"), std::string::npos) << page;
  // `shoal status` asks for all pages twice.
  const std::string all =
      AwaitStatus(folder, "all",
                  {"vehicle_sim_alpha", "helm_alpha", "node_reporter_alpha", "vehicle_sim_bravo",
                   "helm_bravo", "node_reporter_bravo", "shore_broker"});
  EXPECT_NE(all.find("node_reporter_bravo"), std::string::npos) << all;
  run.Signal(SIGINT);
  run.Wait();
}

TEST(Grouping, IsRefusedWhereItIsNone) {
  const TestFolder folder;
  const std::string mission = MissionFile("berta.toml");
  const Finished run = RunShoal(folder, {"run", mission, "--grouping", "boats"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.output.find("'boats' is not a grouping: app (a process per participant), vehicle"),
            std::string::npos)
      << run.output;
  const Finished group = RunShoal(
      folder, {"group", "--mission", mission, "--grouping", "vehicle", "--name", "group-zulu"});
  EXPECT_EQ(group.exit_code, 2);
  EXPECT_NE(group.output.find("no group 'group-zulu' in "), std::string::npos) << group.output;
  EXPECT_NE(group.output.find("it has: group-alpha, group-bravo"), std::string::npos)
      << group.output;
}

}  // namespace shoal::grouping_test
