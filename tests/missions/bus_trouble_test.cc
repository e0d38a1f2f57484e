// What unregistered participants and a bad network do to a running mission.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/run_registry.h"
#include "tests/missions/shoal_process.h"

namespace shoal::bus_trouble_test {

/// Finds the ports of the mission that runs in this test's folder.
PortPlan PortsOf(const TestFolder& folder) {
  setenv("SHOAL_RUN_DIR", (folder / "run").c_str(), 1);
  const Result<RunningMission> mission = FindRunningMission(0);
  EXPECT_TRUE(mission.ok());
  return mission.ok() ? mission->Ports() : PortPlan(7665, Layout::kShared, {});
}

/// Returns every channel of a mission with the vehicle alpha.
std::vector<std::string> AllChannels() {
  std::vector<std::string> channels = {"NO_SUCH_CHANNEL"};
  for (const ChannelRow& row : ChannelTable()) {
    channels.push_back(std::string(row.topic) +
                       (row.home == ChannelHome::kVehicle ? "_ALPHA" : ""));
  }
  return channels;
}

std::unique_ptr<RunningProcess> StartAlpha(const TestFolder& folder, const std::string& warp,
                                           std::vector<std::string> extra = {}) {
  std::vector<std::string> argv = {Program("shoal"), "run", MissionFile("alpha.toml"), "--warp",
                                   warp};
  argv.insert(argv.end(), extra.begin(), extra.end());
  auto process = std::make_unique<RunningProcess>(folder, argv);
  EXPECT_TRUE(process->WaitFor("x real time")) << process->Output();
  return process;
}

/// Returns the first LCM port of a mission, as it has printed it.
std::string FirstPortOf(const RunningProcess& mission) {
  const std::string output = mission.Output();
  const std::string before = "LCM ports ";
  const size_t begin = output.find(before);
  if (begin == std::string::npos) return {};
  return output.substr(begin + before.size(),
                       output.find(' ', begin + before.size()) - begin - before.size());
}

TEST(Garbage, OnEveryChannelEndsNoProcessAndIsCounted) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "2");  // It must last until the page is there.
  LcmBus bus(PortsOf(folder));
  std::mt19937 random(1);
  Bytes whole;
  EncodeInto(comms_fates_t{}, &whole);
  for (const std::string& channel : AllChannels()) {
    for (int i = 0; i < 200; ++i) {
      Bytes bytes(random() % 300);
      for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
      bus.PublishBytes(channel, bytes);                                            // random
      bus.PublishBytes(channel, std::span(whole).first(random() % whole.size()));  // truncated
      if (channel != "COMMS_FATES") bus.PublishBytes(channel, whole);              // wrong type
    }
  }
  const std::string text = "undecodable messages on NAV_ALPHA";
  const std::string page = AwaitStatus(folder, "helm_alpha", {text});
  EXPECT_NE(page.find(text), std::string::npos) << page;
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "warp", "max"}).exit_code, 0);
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_EQ(finished.output.find("LOST"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: no: messages came from outside"), std::string::npos)
      << finished.output;
}

TEST(Garbage, InABurstOfAHundredThousandEndsNoProcess) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "60");
  LcmBus bus(PortsOf(folder));
  const Bytes bytes(100, 0x5a);
  for (int i = 0; i < 100'000; ++i)
    bus.PublishBytes(i % 2 == 0 ? "NAV_ALPHA" : "ACTUATORS_ALPHA", bytes);
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_EQ(finished.output.find("LOST"), std::string::npos) << finished.output;
}

TEST(Flood, OfRequestsForPagesDoesNotHoldUpTheSteps) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "60");
  LcmBus bus(PortsOf(folder));
  appcast_req_t request{};
  request.app = "all";
  for (int i = 0; i < 100'000; ++i) Publish(bus, channels::AppcastReq(), request);
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
}

TEST(AnotherMission, OnTheSamePortsIsRejectedAndReported) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "60");
  LcmBus bus(PortsOf(folder));
  nav_t nav{};
  nav.x_m = 1e5;
  Bytes bytes;
  EncodeInto(nav, &bytes);
  AppendSeal({.publisher = "vehicle_sim_alpha", .mission_id = 1, .step = 5, .sequence = 0},
             MissionSecret{}, "NAV_ALPHA", &bytes);
  tick_t tick{};
  tick.mission_id = 1;
  tick.step = 1'000'000;
  Bytes sealed_tick;
  EncodeInto(tick, &sealed_tick);
  AppendSeal({.publisher = "clock", .mission_id = 1, .step = tick.step, .sequence = 0},
             MissionSecret{}, topics::kTick, &sealed_tick);
  for (int i = 0; i < 10; ++i) {
    bus.PublishBytes("NAV_ALPHA", bytes);
    bus.PublishBytes(topics::kTick, sealed_tick);
  }
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("messages of another mission arrive"), std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos)
      << "what was rejected must not count as input: " << finished.output;
}

TEST(Attack, DatagramsThatEndLiblcmEndNoProcess) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "2", {"--record", folder / "record"});
  const PortPlan ports = PortsOf(folder);
  for (int port = ports.base(); port < ports.base() + ports.num_ports(); ++port) {
    for (const std::string channel : {"TICK", "STEP_DONE", "NAV_ALPHA", "X"}) {
      // A channel name without its end; a fragment whose offset and length wrap.
      SendDatagram(port, "LC02" + std::string(4, '\1') + channel);
      SendDatagram(port, "LC03" + std::string("\0\0\0\1\0\0\3\xe8\xff\xff\xff\xce\0\0\0\2", 16) +
                             channel + std::string(101, '\0'));
    }
  }
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "warp", "max"}).exit_code, 0);
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_EQ(finished.output.find("LOST"), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
}

TEST(Attack, CopiedSealsWithOtherNumbersAreRefusedAndNamed) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "2", {"--record", folder / "record"});
  const PortPlan ports = PortsOf(folder);
  LcmTransport attacker;
  int num_forged = 0;
  attacker.set_receiver([&](int port, std::string_view channel, std::span<const uint8_t> datagram) {
    Bytes forged(datagram.begin(), datagram.end());
    if (!Unseal(forged).seal || num_forged >= 50) return;
    forged[forged.size() - 21] ^= 0x40;  // The sequence number: another message of the same step.
    attacker.Send(port, channel, forged);
    ++num_forged;
  });
  attacker.Listen(ports.PortOf("NAV_ALPHA"), "NAV_ALPHA");
  const double end_s = WallSeconds() + kPatience_s;
  while (num_forged < 50 && WallSeconds() < end_s) attacker.Poll(50'000);
  ASSERT_EQ(num_forged, 50);
  const std::string text =
      "messages refused whose seals do not prove this mission's secret; the "
      "first: on NAV_ALPHA in the name of vehicle_sim_alpha";
  EXPECT_NE(AwaitStatus(folder, "helm_alpha", {text}).find(text), std::string::npos);
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "warp", "max"}).exit_code, 0);
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  EXPECT_EQ(finished.output.find(" 0 refused"), std::string::npos) << finished.output;
  // Nothing of it is in the log: it is that of an undisturbed run.
  const Finished undisturbed = RunShoal(folder, {"run", MissionFile("alpha.toml"), "--warp", "max",
                                                 "--record", folder / "undisturbed"});
  EXPECT_EQ(undisturbed.exit_code, 0) << undisturbed.output;
  const Finished difference = RunShoal(
      folder, {"log", "diff", folder / "record/mission.lcm", folder / "undisturbed/mission.lcm"});
  EXPECT_EQ(difference.exit_code, 0) << difference.output;
}

TEST(Attack, AnswersWithoutTheSecretAreRefusedAndNamed) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "2");
  LcmBus bus(PortsOf(folder));
  step_done_t done{};
  done.step = 3;
  done.mission_id = FindRunningMission(0)->mission_id;
  done.participant = "helm_alpha";
  done.fault = "forged";
  Publish(bus, channels::StepDone(), done);
  tick_t tick{};
  tick.mission_id = done.mission_id;
  tick.step = 1'000'000;
  tick.kind = tick_t::END;
  Publish(bus, channels::Tick(), tick);
  EXPECT_TRUE(process->WaitFor("an answer in the name of helm_alpha was refused"))
      << process->Output();
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "warp", "max"}).exit_code, 0);
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
}

TEST(Attack, AFloodOfSealedMessagesWhileTheClockIsPausedTakesNoMemory) {
  const TestFolder folder;
  const auto process = StartAlpha(folder, "2");
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "pause"}).exit_code, 0);
  const PortPlan ports = PortsOf(folder);
  const RunningMission running = *FindRunningMission(0);
  const auto resident_kB = [&] {
    std::ifstream in("/proc/" + std::to_string(running.pid) + "/statm");
    int64_t pages = 0;
    in >> pages >> pages;
    return pages * sysconf(_SC_PAGESIZE) / 1024;
  };
  const int64_t before_kB = resident_kB();
  LcmTransport attacker;
  for (uint32_t i = 0; i < 60'000; ++i) {
    Bytes bytes(1000);
    AppendSeal({.publisher = "vehicle_sim_alpha",
                .mission_id = running.mission_id,
                .step = 1 + i % 1000,
                .sequence = i},
               MissionSecret{}, "NODE_REPORT_ALPHA", &bytes);
    attacker.Send(ports.shore_port(), i % 2 == 0 ? "NODE_REPORT_ALPHA" : "HELM_STATE_ALPHA", bytes);
  }
  EXPECT_LT(resident_kB() - before_kB, 20'000) << "60 MB were sent";
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "resume"}).exit_code, 0);
  EXPECT_EQ(RunShoal(folder, {"send", "clock", "warp", "max"}).exit_code, 0);
  const Finished finished = process->Wait();
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
}

TEST(LossForGood, EndsTheMissionWithTheRightAdvice) {
  const TestFolder folder;
  const Finished finished = RunShoal(
      folder, {"run", MissionFile("alpha.toml"), "--warp", "max", "--lose-forever", "NAV_ALPHA"});
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("on NAV_ALPHA in step 0 never reached"), std::string::npos)
      << finished.output;
  const std::string advice = ReceiveBufferLimit() < 4'194'304
                                 ? "sudo sysctl -w net.core.rmem_max=4194304"
                                 : "a program floods its ports";
  EXPECT_NE(finished.output.find(advice), std::string::npos) << finished.output;
}

TEST(TwoMissions, AtOnceTakePortsOfTheirOwn) {
  const TestFolder folder;
  const auto first = StartAlpha(folder, "2");  // So that they overlap on any machine.
  const auto second = StartAlpha(folder, "2");
  const Finished status = RunShoal(folder, {"status"});
  EXPECT_EQ(status.exit_code, 3);
  EXPECT_NE(status.output.find("several missions that were started in this folder are running"),
            std::string::npos)
      << status.output;
  for (const auto* process : {&first, &second}) {
    const std::string port = FirstPortOf(**process);
    EXPECT_EQ(RunShoal(folder, {"send", "--port", port, "clock", "warp", "max"}).exit_code, 0);
    const Finished finished = (*process)->Wait();
    EXPECT_EQ(finished.exit_code, 0) << finished.output;
    EXPECT_NE(finished.output.find("Reproducible: yes"), std::string::npos) << finished.output;
  }
}

}  // namespace shoal::bus_trouble_test
