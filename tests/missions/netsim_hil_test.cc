// A vehicle from outside in a mission of shoal's, as a user runs it.
#include <gtest/gtest.h>
#include <signal.h>

#include <Eigen/Core>
#include <cmath>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_reader.h"
#include "tests/missions/shoal_process.h"

namespace shoal::netsim_hil_test {

/// The mission, on TCP ports of its own.
std::vector<std::string> OnPorts(int first) {
  return {"--set", "netsim.port=" + std::to_string(first),
          "--set", "netsim.vehicle.outsider.modem_tcp_port=" + std::to_string(first + 1),
          "--set", "netsim.vehicle.outsider.gps.tcp_port=" + std::to_string(first + 2)};
}

/// Of the packets between bravo and the outsider, either way, the largest difference between the
/// travel time in COMMS_FATES and what bravo's NAV and the outsider's own reports make of
/// it, in seconds; negative: there was no packet.
double WorstTravelTime_s(const std::string& log, const std::string& from, const std::string& to) {
  Result<LogReader> reader = LogReader::Open(log);
  EXPECT_TRUE(reader.ok());
  double worst_s = -1;
  Eigen::Vector3d bravo_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d outsider_m = Eigen::Vector3d::Zero();
  while (const auto event = reader->Next()) {
    comms_fates_t fates{};
    nav_t nav{};
    node_report_t report{};
    if (event->channel == "NAV_BRAVO" && Decode(event->data, &nav)) {
      bravo_m = {nav.x_m, nav.y_m, nav.z_m};
    }
    if (event->channel == "NODE_REPORT" && Decode(event->data, &report)) {
      outsider_m = {report.x_m, report.y_m, report.depth_m};
    }
    if (event->channel != "COMMS_FATES" || !Decode(event->data, &fates)) continue;
    for (const fate_t& fate : fates.fates) {
      const bool is_wanted = fate.kind == "packet" && fate.source == from &&
                             fate.destination == to && fate.cause == "delivered" &&
                             !fate.path.empty();
      if (!is_wanted) continue;
      constexpr double kSoundSpeed_mps = 1489.97;  // Mackenzie's, of the default sea.
      const double expected_s = (bravo_m - outsider_m).norm() / kSoundSpeed_mps;
      worst_s = std::max(worst_s, std::abs(fate.path[0].travel_s - expected_s));
    }
  }
  return worst_s;
}

TEST(NetsimHil, ExchangesPacketsWithAVehicleFromOutside) {
  const TestFolder folder;
  const int first = FreeTcpPorts(3);
  const std::string dir = (folder / "rec").string();
  std::vector<std::string> run = {
      Program("shoal"),       "run", MissionFile("netsim_hil.toml"), "--record", dir, "--set",
      "mission.duration_s=24"};
  for (const std::string& word : OnPorts(first)) run.push_back(word);
  RunningProcess mission(folder, run);
  RunningProcess outsider(folder, {Program("netsim_outsider"), "127.0.0.1", std::to_string(first),
                                   std::to_string(first + 1)});
  ASSERT_TRUE(outsider.WaitFor("received pong 0")) << outsider.Output() << mission.Output();
  const Finished page = RunShoal(folder, {"status", "netsim_manager"});
  EXPECT_NE(page.output.find("outsider: port"), std::string::npos) << page.output;
  const Finished finished = mission.Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("no: clients of netsim_manager come from outside"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(outsider.Wait().output.find("the other side has closed"), std::string::npos);
  for (const auto& [from, to] : {std::pair("outsider", "bravo"), std::pair("bravo", "outsider")}) {
    const double worst_s = WorstTravelTime_s(dir + "/mission.lcm", from, to);
    EXPECT_GE(worst_s, 0) << "a packet went that way";
    // Bravo makes 1.5 m/s: while a packet was under way and until its fate, some metres.
    EXPECT_LT(worst_s, 0.005) << "and took as long as sound does";
  }
}

TEST(NetsimHil, FailsWithoutAnOutsider) {
  const TestFolder folder;
  std::vector<std::string> arguments = {"run", MissionFile("netsim_hil.toml"), "--set",
                                        "mission.duration_s=2"};
  for (const std::string& word : OnPorts(FreeTcpPorts(3))) arguments.push_back(word);
  EXPECT_EQ(RunShoal(folder, arguments).exit_code, 1);
}

TEST(NetsimHil, IsRefusedAtAnyWarpButOneAndByShoalSim) {
  const TestFolder folder;
  const Finished fast = RunShoal(folder, {"run", MissionFile("netsim_hil.toml"), "--warp", "2"});
  EXPECT_EQ(fast.exit_code, 2);
  EXPECT_NE(fast.output.find("runs at --warp 1: modem drivers compare their clock with the wall's"),
            std::string::npos)
      << fast.output;
  const Finished sim = RunShoal(folder, {"sim", MissionFile("netsim_hil.toml")});
  EXPECT_NE(sim.exit_code, 0);
  EXPECT_NE(sim.output.find("needs `shoal run`"), std::string::npos) << sim.output;
}

TEST(NetsimHil, StatesWhichTcpPortIsTaken) {
  const TestFolder folder;
  const int first = FreeTcpPorts(3);
  RunningProcess one(folder, [&] {
    std::vector<std::string> run = {Program("shoal"), "run", MissionFile("netsim_hil.toml")};
    for (const std::string& word : OnPorts(first)) run.push_back(word);
    return run;
  }());
  ASSERT_TRUE(one.WaitFor("x real time")) << one.Output();
  std::vector<std::string> again = {"run", MissionFile("netsim_hil.toml")};
  for (const std::string& word : OnPorts(first)) again.push_back(word);
  const Finished second = RunShoal(folder, again);
  EXPECT_EQ(second.exit_code, 3) << second.output;
  EXPECT_NE(second.output.find(std::to_string(first)), std::string::npos) << second.output;
  one.Signal(SIGINT);
  one.Wait();
}

}  // namespace shoal::netsim_hil_test
