// `shoal run --view` and `shoal view`: the launcher's part; what the viewer shows is tested in
// tests/viewer and tests/web.
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/missions/shoal_process.h"

namespace shoal::launched_viewer_test {

TEST(View, RunsBesideTheMissionAndPrintsItsAddress) {
  const TestFolder folder;
  const std::string mission = MissionFile("berta.toml");
  RunningProcess process(folder, {Program("shoal"), "run", mission, "--view", "--view-http", "0"});
  ASSERT_TRUE(process.WaitFor("viewer: http://127.0.0.1:")) << process.Output();
  const std::map<std::string, pid_t> participants = process.Participants();
  ASSERT_TRUE(participants.contains("shoal-viewer"));
  process.Signal(SIGINT);
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_EQ(finished.output.find("shoal-viewer"), std::string::npos) << finished.output;
  EXPECT_TRUE(AllGone(participants));
}

TEST(View, StaysAfterTheMissionUntilItIsInterrupted) {
  const TestFolder folder;
  RunningProcess process(folder, {Program("shoal"), "run", MissionFile("alpha.toml"), "--view",
                                  "--view-http", "0", "--warp", "500"});
  ASSERT_TRUE(process.WaitFor("the viewer shows it until Ctrl-C")) << process.Output();
  EXPECT_NE(process.Output().find("PASS"), std::string::npos) << process.Output();
  EXPECT_NE(RunShoal(folder, {"status"}).exit_code, 0) << "no mission is running";
  process.Signal(SIGINT);
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 0) << "that of the mission: " << finished.output;
}

TEST(View, MayDieWithoutHarmToTheMission) {
  const TestFolder folder;
  RunningProcess process(folder, {Program("shoal"), "run", MissionFile("alpha.toml"), "--view",
                                  "--view-http", "0", "--allow-commands"});
  ASSERT_TRUE(process.WaitFor("?token=")) << process.Output();
  kill(process.Participants().at("shoal-viewer"), SIGKILL);
  ASSERT_TRUE(process.WaitFor("shoal-viewer was killed by signal 9 (Killed); the mission goes on"))
      << process.Output();
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "warp", "max"}).exit_code, 0);
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
}

TEST(View, RefusesInvalidOptions) {
  const TestFolder folder;
  const std::string mission = MissionFile("berta.toml");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", mission, "--allow-commands"},
        {"run", mission, "--view-http", "8000"},
        {"run", mission, "--view-listen", "0.0.0.0"}}) {
    const Finished finished = RunShoal(folder, arguments);
    EXPECT_EQ(finished.exit_code, 2) << finished.output;
    EXPECT_NE(finished.output.find("requires --view"), std::string::npos) << finished.output;
  }
  EXPECT_EQ(RunShoal(folder, {"view", "a.lcm", "--allow-commands"}).exit_code, 2);
  EXPECT_EQ(RunShoal(folder, {"view", "--mission", "b.toml"}).exit_code, 2);
  EXPECT_EQ(RunShoal(folder, {"view", "/nowhere/a.lcm"}).exit_code, 2);
}

}  // namespace shoal::launched_viewer_test
