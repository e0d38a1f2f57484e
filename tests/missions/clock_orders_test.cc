// `shoal send clock`, in a mission that runs.
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/missions/shoal_process.h"

namespace shoal::clock_orders_test {

TEST(Clock, IsPausedResumedAndWarpedWithoutATraceInTheLog) {
  const TestFolder folder;
  const std::string mission = MissionFile("alpha.toml");
  const std::string sim = (folder / "sim.lcm").string();
  ASSERT_EQ(RunShoal(folder, {"sim", mission, "--log", sim}).exit_code, 0);
  const std::string dir = (folder / "rec").string();
  RunningProcess process(folder,
                         {Program("shoal"), "run", mission, "--warp", "3", "--record", dir});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();

  const Finished paused = RunShoal(folder, {"send", "clock", "pause"});
  EXPECT_EQ(paused.exit_code, 0) << paused.output;
  EXPECT_NE(paused.output.find("\nclock: paused at "), std::string::npos) << paused.output;
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "pause"}).output, paused.output);
  const Finished warped = RunShoal(folder, {"send", "clock", "warp", "8"});
  EXPECT_EQ(warped.exit_code, 0) << warped.output;
  EXPECT_EQ(warped.output, paused.output);

  const Finished resumed = RunShoal(folder, {"send", "clock", "resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_NE(resumed.output.find("\nclock: running at warp 8"), std::string::npos) << resumed.output;
  EXPECT_NE(resumed.output.find(" x real time)"), std::string::npos) << resumed.output;

  const Finished bad = RunShoal(folder, {"send", "clock", "warp", "0"});
  EXPECT_EQ(bad.exit_code, 2) << bad.output;
  EXPECT_NE(bad.output.find("a number from 1e-6 to 1e6, or max"), std::string::npos) << bad.output;
  const Finished unknown = RunShoal(folder, {"send", "clock", "puase"});
  EXPECT_EQ(unknown.exit_code, 2) << unknown.output;
  EXPECT_NE(unknown.output.find("did you mean 'pause'?"), std::string::npos) << unknown.output;

  const Finished fastest = RunShoal(folder, {"send", "clock", "warp", "max"});
  EXPECT_EQ(fastest.exit_code, 0) << fastest.output;
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_TRUE(ReadFile(sim) == ReadFile(dir + "/mission.lcm"));
}

TEST(Clock, StandsStillForAnOrderThatIsExecutedWhenItGoesOn) {
  const TestFolder folder;
  RunningProcess process(folder, {Program("shoal"), "run", MissionFile("berta.toml")});
  ASSERT_TRUE(process.WaitFor("x real time")) << process.Output();
  ASSERT_EQ(RunShoal(folder, {"send", "clock", "pause"}).exit_code, 0);
  const Finished sent = RunShoal(folder, {"send", "alpha", "station_keep"});
  EXPECT_EQ(sent.exit_code, 0) << sent.output;
  EXPECT_NE(sent.output.find("1 of 1 helms have published nothing since"), std::string::npos)
      << sent.output;
  ASSERT_EQ(RunShoal(folder, {"send", "clock", "resume"}).exit_code, 0);
  const std::string page = AwaitStatus(folder, "helm_alpha", {"command: station_keep"});
  EXPECT_NE(page.find("command: station_keep"), std::string::npos) << page;
  // Ctrl-C ends a paused mission as any other.
  ASSERT_EQ(RunShoal(folder, {"send", "clock", "pause"}).exit_code, 0);
  process.Signal(SIGINT);
  const Finished finished = process.Wait();
  EXPECT_EQ(finished.exit_code, 1) << finished.output;
  EXPECT_NE(finished.output.find("INCOMPLETE"), std::string::npos) << finished.output;
}

}  // namespace shoal::clock_orders_test
