// Swarms with acoustic messages, as a user runs them: killed processes, silent leaders.
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/missions/shoal_process.h"

namespace shoal::talking_swarm_test {

TEST(Swarm, KeepsFormationWithAFollowerWhoseAcommsWasKilledAndStartedAgain) {
  const TestFolder folder;
  RunningProcess mission(folder, {Program("shoal"), "run", MissionFile("swarm_fdma.toml"), "--warp",
                                  "20", "--set", "mission.on_loss=restart"});
  ASSERT_TRUE(mission.WaitFor("x real time")) << mission.Output();
  // In the schedule, and it has received something of each vehicle.
  const auto takes_part = [](const std::string& page) {
    return page.find("Sent: ") != std::string::npos &&
           page.find("Sent: 0 messages") == std::string::npos &&
           page.find("nothing received yet") == std::string::npos;
  };
  const std::string before = AwaitPage(folder, "acomms_bravo", takes_part);
  ASSERT_TRUE(takes_part(before)) << before;
  kill(mission.Participants().at("acomms_bravo"), SIGKILL);
  ASSERT_TRUE(mission.WaitFor("acomms_bravo starts again")) << mission.Output();
  const std::string after = AwaitPage(folder, "acomms_bravo", takes_part);
  EXPECT_TRUE(takes_part(after)) << after;
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "warp", "max"}).exit_code, 0);
  const Finished finished = mission.Wait();
  EXPECT_NE(finished.output.find("\nPASS"), std::string::npos) << finished.output;
}

TEST(Swarm, DoesNotRunIntoEachOtherWhereTheLeaderFallsSilent) {
  const TestFolder folder;
  // From 300 s on no vehicle is near enough to receive from alpha.
  std::string text = ReadFile(MissionFile("swarm_fdma.toml"));
  const std::string unlimited = "comms_range = \"nolimit\"";
  ASSERT_NE(text.find(unlimited), std::string::npos);
  text.replace(text.find(unlimited), unlimited.size(), "comms_range = 5000");
  text += "\n[[event]]\nat_s = 300\nrule = \"stealth\"\nvehicle = \"alpha\"\nvalue = 0.0\n";
  WriteFile(folder / "silent.toml", text);
  for (const std::string rule : {"predict", "station_keep", "surface"}) {
    std::vector<std::string> arguments = {"sim", (folder / "silent.toml").string()};
    for (const std::string follower : {"bravo", "charlie", "delta", "echo"}) {
      arguments.insert(arguments.end(),
                       {"--set", "vehicle." + follower + ".task.follow.on_silence=" + rule});
    }
    const std::string output = RunShoal(folder, arguments).output;
    EXPECT_NE(output.find("pass no two vehicles closer than 5 m"), std::string::npos)
        << rule << output;
  }
}

TEST(Swarm, ExecutesAnOrderThatOneVehicleSendsToOthers) {
  const TestFolder folder;
  RunningProcess mission(folder,
                         {Program("shoal"), "run", MissionFile("swarm_fdma.toml"), "--warp", "10"});
  ASSERT_TRUE(mission.WaitFor("x real time")) << mission.Output();
  // A vehicle that has not reported yet cannot be reached.
  AwaitStatus(folder, "shore_broker", {"Known Vehicles: 5"});
  const Finished sent = RunShoal(folder, {"message", "--from", "alpha", "--to", "bravo:charlie",
                                          "HELM_COMMAND", "station_keep"});
  EXPECT_EQ(sent.exit_code, 0) << sent.output;
  const auto keeps_station = [&](const std::string& vehicle) {
    const Finished page = RunShoal(folder, {"status", "helm_" + vehicle});
    return page.output.find("Task: station_keep") != std::string::npos;
  };
  const auto both_keep_station = [&] { return keeps_station("bravo") && keeps_station("charlie"); };
  EXPECT_TRUE(AwaitThat(both_keep_station)) << RunShoal(folder, {"status", "shore_broker"}).output;
  EXPECT_FALSE(keeps_station("delta")) << "it was not addressed";
  mission.Signal(SIGINT);
  mission.Wait();
}

TEST(Acomms, IsRefusedWhereItsVehicleIsInNoSwarm) {
  const TestFolder folder;
  RunningProcess acomms(
      folder, {Program("acomms"), "--mission", MissionFile("alpha.toml"), "--vehicle", "alpha"});
  const Finished finished = acomms.Wait();
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.output.find("alpha is neither the leader nor a follower of [swarm]"),
            std::string::npos)
      << finished.output;
}

}  // namespace shoal::talking_swarm_test
