// Swarms that talk through the water, as a user runs them: killed processes, silent leaders.
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/missions/shoal_process.h"

namespace shoal {
namespace {

TEST(Swarm, KeepsFormationWithAFollowerWhoseAcommsWasKilledAndStartedAgain) {
  const TestFolder folder;
  RunningProcess mission(
      folder, {Program("shoal"), "run", MissionFile("swarm_fdma.toml"), "--warp", "60", "--set",
               "mission.on_loss=restart", "--set", "mission.duration_s=300"});
  ASSERT_TRUE(mission.WaitFor("x real time")) << mission.Output();
  SleepSeconds(1);
  kill(mission.Participants().at("acomms_bravo"), SIGKILL);
  ASSERT_TRUE(mission.WaitFor("acomms_bravo starts again", 5)) << mission.Output();
  SleepSeconds(1);
  const Finished page = RunShoal(folder, {"status", "acomms_bravo"});
  EXPECT_EQ(page.output.find("not heard yet"), std::string::npos)
      << "it has learnt anew of everybody: " << page.output;
  EXPECT_EQ(page.output.find("Said: 0 messages"), std::string::npos)
      << "it is back in the schedule: " << page.output;
  const Finished finished = mission.Wait(30);
  EXPECT_NE(finished.output.find("\nPASS"), std::string::npos) << finished.output;
}

TEST(Swarm, DoesNotRunIntoEachOtherWhereTheLeaderFallsSilent) {
  const TestFolder folder;
  for (const std::string rule : {"predict", "station_keep", "surface"}) {
    const std::string set = "vehicle.bravo.task.follow.on_silence=" + rule;
    const Finished finished = RunShoal(
        folder, {"sim", MissionFile("swarm_fdma.toml"), "--set", "vehicle.alpha.acomms=none",
                 "--set", set, "--set", "vehicle.charlie.task.follow.on_silence=" + rule, "--set",
                 "vehicle.delta.task.follow.on_silence=" + rule, "--set",
                 "vehicle.echo.task.follow.on_silence=" + rule});
    EXPECT_NE(finished.output.find("pass no two vehicles closer than 5 m"), std::string::npos)
        << rule << finished.output;
  }
}

TEST(Swarm, ObeysAnOrderThatOneVehicleSendsToOthers) {
  const TestFolder folder;
  RunningProcess mission(folder,
                         {Program("shoal"), "run", MissionFile("swarm_fdma.toml"), "--warp", "20"});
  ASSERT_TRUE(mission.WaitFor("x real time")) << mission.Output();
  SleepSeconds(1);  // Who has not reported yet cannot be reached.
  const Finished sent = RunShoal(folder, {"message", "--from", "alpha", "--to", "bravo:charlie",
                                          "HELM_COMMAND", "station_keep"});
  EXPECT_EQ(sent.exit_code, 0) << sent.output;
  const auto keeps_station = [&](const std::string& vehicle) {
    const Finished page = RunShoal(folder, {"status", "helm_" + vehicle});
    return page.output.find("Task: station_keep") != std::string::npos;
  };
  const auto both_keep_station = [&] { return keeps_station("bravo") && keeps_station("charlie"); };
  bool have_obeyed = false;
  for (int i = 0; i < 20 && !have_obeyed; ++i) {
    SleepSeconds(0.25);
    have_obeyed = both_keep_station();
  }
  EXPECT_TRUE(have_obeyed) << RunShoal(folder, {"status", "shore_broker"}).output;
  EXPECT_FALSE(keeps_station("delta")) << "it was not told";
  mission.Signal(SIGINT);
  mission.Wait(10);
}

TEST(Acomms, IsRefusedWhereItsVehicleIsInNoSwarm) {
  const TestFolder folder;
  RunningProcess acomms(
      folder, {Program("acomms"), "--mission", MissionFile("alpha.toml"), "--vehicle", "alpha"});
  const Finished finished = acomms.Wait(10);
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.output.find("alpha is neither the leader nor a follower of [swarm]"),
            std::string::npos)
      << finished.output;
}

}  // namespace
}  // namespace shoal
