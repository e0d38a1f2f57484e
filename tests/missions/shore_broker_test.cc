// The broker as a process: killed and started again in the midst of a mission, and without a
// mission's clock.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <map>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/bus/record/log_reader.h"
#include "lib/run/broker/broker_rules.h"
#include "lib/run/run/run_registry.h"
#include "tests/missions/shoal_process.h"

namespace shoal::shore_broker_test {

/// What a log shows about the broker.
struct BrokerHistory {
  std::vector<BrokerRules> rules;
  std::vector<int64_t> fate_utimes;  ///< Of each COMMS_FATES.
};

BrokerHistory ReadHistory(const std::string& path) {
  BrokerHistory history;
  Result<LogReader> reader = LogReader::Open(path);
  EXPECT_TRUE(reader.ok());
  while (const auto event = reader->Next()) {
    comms_fates_t fates;
    if (event->channel == "COMMS_RULES") {
      const auto rules = ReadBrokerRules(event->data);
      EXPECT_TRUE(rules);
      if (rules) history.rules.push_back(*rules);
    }
    if (event->channel == "COMMS_FATES" && Decode(event->data, &fates)) {
      history.fate_utimes.push_back(fates.utime);
    }
  }
  EXPECT_EQ(reader->error(), "");
  return history;
}

TEST(KilledBroker, ComesBackWithItsControlsAfterOneReportOfEachVehicleAndItsStartIsInTheLog) {
  const TestFolder folder;
  const std::string dir = (folder / "rec").string();
  RunningProcess mission(folder, {Program("shoal"), "run", MissionFile("berta.toml"), "--warp", "5",
                                  "--record", dir, "--set", "mission.on_loss=restart"});
  ASSERT_TRUE(mission.WaitFor("x real time")) << mission.Output();
  ASSERT_EQ(RunShoal(folder, {"send", "comms_range", "90"}).exit_code, 0);
  ASSERT_EQ(RunShoal(folder, {"send", "stealth", "alpha", "0.5"}).exit_code, 0);
  const std::vector<std::string> texts = {"Comms Range: 90\n", "ALPHA: stealth 0.5",
                                          "Known Vehicles: 2"};
  const auto expect_all = [&](const std::string& page) {
    for (const std::string& text : texts) EXPECT_NE(page.find(text), std::string::npos) << page;
  };
  expect_all(AwaitStatus(folder, "shore_broker", texts));
  kill(mission.Participants().at("shore_broker"), SIGKILL);
  ASSERT_TRUE(mission.WaitFor("shore_broker starts again")) << mission.Output();
  expect_all(AwaitStatus(folder, "shore_broker", texts));
  mission.Signal(SIGINT);
  mission.Wait();

  const BrokerHistory history = ReadHistory(dir + "/mission.lcm");
  ASSERT_GE(history.rules.size(), 3U) << "two at least before, one at the new start";
  const BrokerRules& again = history.rules.back();
  EXPECT_TRUE(history.rules.front().is_start);
  EXPECT_TRUE(again.is_start);
  EXPECT_EQ(again.rules.comms_range_m, 90);
  ASSERT_EQ(again.factors.size(), 1U);
  EXPECT_EQ(again.factors[0].second.stealth, 0.5);
  EXPECT_GT(again.utime, history.rules.front().utime);
  // How many reports were lost with the old broker depends on the moment of the kill, and it may be
  // none: what is promised is how soon the new one routes.
  const auto first_after = std::find_if(history.fate_utimes.begin(), history.fate_utimes.end(),
                                        [&](int64_t utime) { return utime >= again.utime; });
  ASSERT_NE(first_after, history.fate_utimes.end());
  EXPECT_LE(*first_after - again.utime, 500'000)
      << "reports come at 2 Hz, and one of each vehicle is enough";
}

/// A broker without a clock, on ports of its own, and a bus to it.
class LiveBroker : public testing::Test {
 protected:
  LiveBroker() {
    WriteFile(folder_ / "live.toml",
              "[mission]\nduration_s = 60\n[comms]\ncomms_range = 250\n"
              "[[vehicle]]\nname = \"alpha\"\n[[vehicle]]\nname = \"bravo\"\n");
    broker_ = std::make_unique<RunningProcess>(
        folder_, std::vector<std::string>{Program("shore_broker"), "--live", "--mission",
                                          folder_ / "live.toml", "--port", std::to_string(base_)});
    EXPECT_TRUE(broker_->WaitFor("live on")) << broker_->Output();
    for (const std::string name : {"alpha", "bravo"}) {
      Subscribe(bus_, channels::NodeReport(name),
                [this, name](const node_report_t&) { ++received_[name]; });
    }
    Subscribe(bus_, channels::CommsFates(), [this](const comms_fates_t& message) {
      fates_.insert(fates_.end(), message.fates.begin(), message.fates.end());
      fate_utime_ = message.utime;
    });
  }

  void Report(const std::string& name, double x_m) {
    node_report_t report{};
    report.name = name;
    report.x_m = x_m;
    Publish(bus_, channels::NodeReportFromOutside(), report);
  }
  /// Receives until `done`, or for `patience_s`.
  template <class F>
  bool Receive(F done, double patience_s = kPatience_s) {
    for (const double begin = WallSeconds(); WallSeconds() - begin < patience_s;) {
      bus_.Poll(10'000);
      if (done()) return true;
    }
    return false;
  }

  /// Of this test alone, whatever else runs on the machine: the lock goes with the process.
  static int ClaimBase() {
    const Result<int> base = ClaimPorts(0, PortPlan::NumPorts(Layout::kShared, 2) + 1);
    EXPECT_TRUE(base.ok());
    return base.ok() ? *base : 0;
  }

  const int64_t began_s_ = time(nullptr);
  const int base_ = ClaimBase();
  TestFolder folder_;
  std::unique_ptr<RunningProcess> broker_;
  LcmBus bus_{PortPlan(base_, Layout::kShared, {"alpha", "bravo"})};
  std::map<std::string, int> received_;
  std::vector<fate_t> fates_;
  int64_t fate_utime_ = 0;
};

TEST_F(LiveBroker, TakesReportsAsTheyComeAndPublishesTheirFates) {
  Report("alpha", 0);
  bus_.Poll(50'000);
  Report("bravo", 100);
  ASSERT_TRUE(Receive([&] { return received_["alpha"] >= 1; })) << broker_->Output();
  Report("alpha", 0);
  // Where both first reports came in one round, bravo has received two of alpha's.
  ASSERT_TRUE(Receive([&] { return received_["bravo"] >= 1; }));
  EXPECT_TRUE(Receive([&] { return fates_.size() >= 2; }));
  constexpr int64_t kSecondOfTime_us = 1'000'000;
  EXPECT_GE(fate_utime_, began_s_ * kSecondOfTime_us) << "the wall's time";
  EXPECT_LE(fate_utime_, (time(nullptr) + 1) * kSecondOfTime_us) << "the wall's time";
}

TEST_F(LiveBroker, CarriesAcousticPacketsInRealTime) {
  std::vector<acoustic_rx_t> packets;
  Subscribe(bus_, channels::AcousticRx("bravo"),
            [&](const acoustic_rx_t& packet) { packets.push_back(packet); });
  Report("alpha", 0);
  Report("bravo", 150);
  ASSERT_TRUE(Receive([&] { return received_["alpha"] == 1; }));
  acoustic_tx_t packet = {};
  packet.source = "alpha";
  packet.num_bytes = 8;
  packet.payload = {1, 2, 3, 4, 5, 6, 7, 8};
  for (int i = 0; i < 30 && packets.empty(); ++i) {  // 2 % are lost, 10 % damaged.
    Publish(bus_, channels::AcousticTx(), packet);
    Receive([&] { return !packets.empty(); }, 5);
  }
  ASSERT_FALSE(packets.empty());
  EXPECT_EQ(packets[0].payload, packet.payload);
  // 12 bytes on the air, 150 m, and up to 0.2 s of jitter.
  const auto delay_us = static_cast<double>(packets[0].arrived_utime - packets[0].sent_utime);
  EXPECT_GE(delay_us, 0.196e6);
  EXPECT_LE(delay_us, 0.396e6);
}

TEST_F(LiveBroker, IsFoundBySendAndStatusAndEndsOnASignal) {
  Report("alpha", 0);
  EXPECT_EQ(RunShoal(folder_, {"send", "comms_range", "77"}).exit_code, 0);
  const std::vector<std::string> texts = {"Comms Range: 77\n", "ALPHA: 1 "};
  const std::string page = AwaitStatus(folder_, "shore_broker", texts);
  for (const std::string& text : texts) EXPECT_NE(page.find(text), std::string::npos) << page;
  broker_->Signal(SIGTERM);
  EXPECT_EQ(broker_->Wait().exit_code, 0);
  EXPECT_NE(RunShoal(folder_, {"status"}).exit_code, 0) << "nothing runs any more";
}

TEST_F(LiveBroker, SurvivesBytesThatAreNoMessagesAndCountsThem) {
  const Bytes garbage = {1, 2, 3};
  for (const ChannelRow& row : ChannelTable()) {
    if (row.home == ChannelHome::kShore) bus_.PublishBytes(row.topic, garbage);
  }
  Report("alpha", 0);
  Report("bravo", 0);
  EXPECT_TRUE(Receive([&] { return received_["alpha"] == 1; }));
  const std::vector<std::string> texts = {"1 undecodable messages on UNC_STEALTH",
                                          "1 undecodable messages on NODE_MESSAGE_LOCAL"};
  const std::string page = AwaitStatus(folder_, "shore_broker", texts);
  for (const std::string& text : texts) EXPECT_NE(page.find(text), std::string::npos) << page;
}

TEST_F(LiveBroker, RefusesPortsThatAnotherHas) {
  RunningProcess second(folder_, {Program("shore_broker"), "--live", "--mission",
                                  folder_ / "live.toml", "--port", std::to_string(base_ + 1)});
  const Finished finished = second.Wait();
  EXPECT_EQ(finished.exit_code, 3) << finished.output;
  EXPECT_NE(finished.output.find("choose others with --port"), std::string::npos)
      << finished.output;
}

}  // namespace shoal::shore_broker_test
