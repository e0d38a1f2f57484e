// The broker and the water: what goes in, what comes out, when, and what is told of it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "apps/shore_broker/broker_fixture.h"

namespace shoal {
namespace {

/// One channel for both, 1000 bit/s, no loss, no errors, no jitter.
Mission CalmWater() {
  Mission mission = TwoVehicles();
  mission.acoustics.is_used = true;
  AcousticOptions& options = mission.acoustics.options;
  options.access_mode = AccessMode::kShared;
  options.jitter = JitterModel::kOff;
  options.packet_loss_model = PacketLossModel::kOff;
  options.bit_error_model = BitErrorModel::kOff;
  return mission;
}

class WaterFixture : public BrokerFixture {
 protected:
  explicit WaterFixture(const Mission& mission = CalmWater()) : BrokerFixture(mission) {}

  /// alpha at the origin, bravo 150 m from it, known to the broker.
  void Begin() {
    Say(ReportFrom("alpha", 0));
    Say(ReportFrom("bravo", 150));
    Step();
  }

  /// Steps until something was decided, and returns how many steps that took; 0: nothing was.
  int StepUntilFates(int at_most = 100) {
    for (int i = 1; i <= at_most; ++i) {
      Step();
      if (!fates_.empty()) return i;
    }
    return 0;
  }
};

class CalmPackets : public WaterFixture {};

TEST_F(CalmPackets, ArriveInTheStepOfTheirLastByte) {
  Begin();
  const Bytes payload(37, 7);
  SayPacket("alpha", payload);
  const int64_t said_utime = utime_;
  // 41 bytes take 0.328 s, the way 0.1 s: 0.428 s after it was said.
  EXPECT_EQ(StepUntilFates(), 5);
  ASSERT_EQ(packets_["bravo"].size(), 1U);
  EXPECT_TRUE(packets_["alpha"].empty());
  const acoustic_rx_t& packet = packets_["bravo"][0];
  EXPECT_EQ(packet.payload, payload);
  EXPECT_EQ(packet.source, "alpha");
  EXPECT_EQ(packet.number, 0);
  EXPECT_EQ(packet.utime, said_utime + 500'000);
  EXPECT_EQ(packet.sent_utime, said_utime);
  EXPECT_EQ(packet.arrived_utime, said_utime + 428'000);
  ASSERT_EQ(fates_.size(), 1U);
  EXPECT_EQ(fates_[0].kind, "packet");
  EXPECT_EQ(fates_[0].cause, "delivered");
  EXPECT_EQ(fates_[0].range_m, 150);
  EXPECT_EQ(fates_[0].limit_m, 250);
  ASSERT_EQ(fates_[0].path.size(), 1U);
  const acoustic_path_t& path = fates_[0].path[0];
  EXPECT_EQ(path.sent_utime, said_utime);
  EXPECT_EQ(path.num_bytes, 41);
  EXPECT_NEAR(path.air_s, 0.328, 1e-12);
  EXPECT_NEAR(path.travel_s, 0.1, 1e-12);
  EXPECT_EQ(path.jitter_s, 0);
  EXPECT_EQ(path.loss_probability, -1);
  EXPECT_EQ(path.snr_db, -999);
  EXPECT_EQ(pulses_.size(), 1U);
}

TEST_F(CalmPackets, AreShownOnThePageWhileTheyAreInTheWater) {
  Begin();
  SayPacket("alpha", {1, 2, 3});
  Step();
  EXPECT_TRUE(fates_.empty());
  EXPECT_TRUE(PageHas("Total Packets Received: 1")) << broker_.Status().text;
  EXPECT_TRUE(PageHas("In The Water: 1"));
  StepUntilFates();
  EXPECT_FALSE(PageHas("In The Water"));
  EXPECT_TRUE(PageHas("    transmissions                    1")) << broker_.Status().text;
}

TEST_F(CalmPackets, ThatOverlapAtTheirReceiverCollideAndNameEachOther) {
  Begin();
  Say(ReportFrom("charlie", 75));
  Step();
  SayPacket("alpha", {1, 2, 3});
  SayPacket("bravo", {4, 5, 6});
  StepUntilFates();
  int num_collisions = 0;
  for (const fate_t& fate : fates_) {
    if (fate.destination != "charlie") continue;
    ++num_collisions;
    EXPECT_EQ(fate.cause, "collision");
    ASSERT_EQ(fate.path.size(), 1U);
    EXPECT_EQ(fate.path[0].num_colliders, 1);
    EXPECT_EQ(fate.path[0].colliders,
              std::vector<std::string>{fate.source == "alpha" ? "bravo 0" : "alpha 0"});
  }
  EXPECT_EQ(num_collisions, 2);
  EXPECT_TRUE(packets_["charlie"].empty());
}

TEST_F(CalmPackets, WithoutSenderOrPayloadAreRefused) {
  Begin();
  SayPacket("alpha", {});
  SayPacket("no name", {1});
  SayPacket("stranger", {1});
  SayPacket("alpha", Bytes(70'000));
  Step();
  EXPECT_EQ(Fates(), (std::vector<std::string>{"alpha> invalid", "> invalid",
                                               "stranger> unknown_source", "alpha> too_long"}));
  EXPECT_EQ(fates_[3].length_limit_bytes, 65'535);
}

TEST_F(CalmPackets, OfOneWhoTalksFasterThanTheWaterCarriesFindNoChannel) {
  Begin();
  for (int i = 0; i < AcousticTraffic::kMaxPacketsOfOne + 3; ++i) SayPacket("alpha", Bytes(1000));
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>(3, "alpha>bravo no_channel"));
}

Mission WithoutALeader() {
  Mission mission = CalmWater();
  mission.acoustics.options.access_mode = AccessMode::kTdmaLf;
  return mission;
}

class WaterWithoutALeader : public WaterFixture {
 protected:
  WaterWithoutALeader() : WaterFixture(WithoutALeader()) {}
};

TEST_F(WaterWithoutALeader, CarriesNothing) {  // A log's COMMS_RULES may say so.
  Begin();
  SayPacket("alpha", {1});
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>(1, "alpha>bravo no_channel"));
}

Mission ReportsInWater() {
  Mission mission = CalmWater();
  mission.comms.reports_over = Medium::kAcoustic;
  mission.comms.messages_over = Medium::kAcoustic;
  return mission;
}

class CalmReports : public WaterFixture {
 protected:
  CalmReports() : WaterFixture(ReportsInWater()) {}
};

TEST_F(CalmReports, WithGiantTextsStayOutOfTheWater) {
  Begin();
  for (int i = 0; i < 20; ++i) Step();
  node_report_t report = ReportFrom("bravo", 150);
  report.mode.assign(200'000, 'z');
  Say(report);
  Step();
  ASSERT_EQ(Fates(), std::vector<std::string>(1, "bravo>alpha too_long"));
  EXPECT_GT(fates_[0].length_bytes, 200'000);
  EXPECT_EQ(fates_[0].length_limit_bytes, AcousticTraffic::kMaxMessage_bytes);
}

TEST_F(CalmReports, TakeTheTimeOf37BytesAndArriveAsTheyWereSaid) {
  Begin();
  EXPECT_TRUE(heard_["alpha"].empty());
  for (int i = 0; i < 20; ++i) Step();
  const node_report_t report = ReportFrom("bravo", 150);
  Say(report);
  EXPECT_EQ(StepUntilFates(), 5) << "0.328 s and 0.1 s";
  ASSERT_EQ(heard_["alpha"].size(), 1U);
  node_report_t heard;
  ASSERT_TRUE(Decode(heard_["alpha"][0], &heard));
  EXPECT_EQ(heard.x_m, 150);
  EXPECT_EQ(heard.extra.size(), 1U) << "the user's own fields too";
  EXPECT_EQ(fates_[0].kind, "report");
  EXPECT_EQ(fates_[0].path.at(0).num_bytes, 41);
  EXPECT_EQ(fates_[0].age_limit_s, 5);
}

TEST_F(CalmReports, CarryMessagesAsTheirTextAndTheirAcks) {
  Begin();
  for (int i = 0; i < 20; ++i) Step();
  Say(MessageFrom("alpha", "bravo"));
  StepUntilFates();
  ASSERT_EQ(messages_["bravo"].size(), 1U);
  const std::string text = "src_node=alpha,dest_node=bravo,var_name=FOOBAR,string_val=hello";
  EXPECT_EQ(fates_[0].path.at(0).num_bytes, static_cast<int32_t>(text.size()) + 4);
  ack_message_t ack = {};
  ack.src_node = "bravo";
  ack.dest_node = "alpha";
  ack.ack_id = "m1";
  Say(ack);
  StepUntilFates();
  EXPECT_EQ(acks_["alpha"].size(), 1U);
  EXPECT_EQ(Fates(), std::vector<std::string>{"bravo>alpha delivered"});
}

Mission ErrorsInWater(bool crc) {
  Mission mission = ReportsInWater();
  mission.acoustics.crc = crc;
  mission.acoustics.options.bit_error_model = BitErrorModel::kPoisson;
  mission.acoustics.options.bit_error_rate = 0.01;
  return mission;
}

/// Counts what becomes of 400 reports of alpha at bravo.
struct ReportCounts {
  std::map<std::string, int> causes;
  int num_heard = 0;
  int num_wrong = 0;  ///< Heard, and not as they were said.
};

class DamagingWater : public WaterFixture {
 protected:
  explicit DamagingWater(bool crc) : WaterFixture(ErrorsInWater(crc)) {}

  ReportCounts SendReports() {
    ReportCounts counts;
    Begin();
    while (broker_.water().num_in_transit() > 0) Step();
    for (int i = 0; i < 400; ++i) {
      Say(ReportFrom("bravo", 150));  // So that it is not stale.
      while (broker_.water().num_in_transit() > 0) Step();
      Say(ReportFrom("alpha", 100));
      bool is_decided = false;
      while (!is_decided) {
        Step();
        for (const Bytes& bytes : heard_["bravo"]) {
          node_report_t heard;
          EXPECT_TRUE(Decode(bytes, &heard));
          ++counts.num_heard;
          for (const double number : {heard.x_m, heard.y_m, heard.depth_m, heard.lat_deg,
                                      heard.lon_deg, heard.speed_mps, heard.heading_deg}) {
            EXPECT_TRUE(std::isfinite(number));
          }
          if (heard.name != "alpha" || heard.x_m != 100 || heard.speed_mps != 0 ||
              heard.depth_m != 0 || heard.y_m != 0 || heard.utime != 0) {
            ++counts.num_wrong;
          }
        }
        for (const fate_t& fate : fates_) {
          if (fate.source != "alpha") continue;
          is_decided = true;
          ++counts.causes[fate.cause];
          const bool has_flips = !fate.path.empty() && fate.path[0].bits_flipped > 0;
          EXPECT_EQ(has_flips, fate.cause != "delivered");
        }
      }
    }
    return counts;
  }
};

class CheckedReports : public DamagingWater {
 protected:
  CheckedReports() : DamagingWater(true) {}
};

TEST_F(CheckedReports, ThatAreDamagedAreThrownAwayForTheirBitErrors) {
  const ReportCounts counts = SendReports();
  // 328 bits are all right with probability 0.99^328 = 0.037: 14.8 of 400; 5 sigma: 19.
  EXPECT_EQ(counts.causes.size(), 2U);
  EXPECT_NEAR(counts.causes.at("delivered"), 14.8, 19);
  EXPECT_EQ(counts.causes.at("bit_errors"), 400 - counts.causes.at("delivered"));
  EXPECT_EQ(counts.num_heard, counts.causes.at("delivered"));
  EXPECT_EQ(counts.num_wrong, 0);
  EXPECT_TRUE(PageHas("Bit Errors: "));
}

class UncheckedReports : public DamagingWater {
 protected:
  UncheckedReports() : DamagingWater(false) {}
};

TEST_F(UncheckedReports, ThatAreDamagedAreHeardWrongOrRejected) {
  const ReportCounts counts = SendReports();
  EXPECT_EQ(counts.causes.size(), 3U);
  EXPECT_GT(counts.causes.at("damaged"), 20);
  EXPECT_GT(counts.causes.at("rejected"), 20);
  EXPECT_EQ(counts.num_heard, counts.causes.at("delivered") + counts.causes.at("damaged"));
  EXPECT_GT(counts.num_wrong, counts.causes.at("damaged") / 2);
}

Mission ThinBand() {
  Mission mission = CalmWater();
  mission.acoustics.options.access_mode = AccessMode::kFdma;
  mission.acoustics.options.bandwidth_khz = 2.75;  // Two channels.
  return mission;
}

class ThinWater : public WaterFixture {
 protected:
  ThinWater() : WaterFixture(ThinBand()) {}
};

TEST_F(ThinWater, HasNoChannelForAStranger) {
  Begin();
  Say(ReportFrom("nemo", 100));
  Step();
  SayPacket("alpha", {1});
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>nemo no_channel"});
  SayPacket("nemo", {1});
  StepUntilFates();
  const std::vector<std::string> fates = Fates();
  EXPECT_EQ(std::count(fates.begin(), fates.end(), "nemo>alpha no_channel"), 1);
}

Mission TooManyForTheBand() {
  Mission mission = TwoVehicles();
  mission.vehicles.resize(20);
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    if (i > 1) mission.vehicles[i].name = "v" + std::to_string(i);
    mission.vehicles[i].acoustic_address = static_cast<int>(i) + 1;
  }
  return mission;
}

class UnusedWater : public WaterFixture {
 protected:
  UnusedWater() : WaterFixture(TooManyForTheBand()) {}
};

TEST_F(UnusedWater, ThatIsTooSmallIsToldWhenSomebodySpeaks) {
  Begin();
  SayPacket("alpha", {1});
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>bravo no_channel"});
  const StatusPage page = broker_.Status();
  ASSERT_EQ(page.run_warnings.size(), 1U);
  EXPECT_NE(page.run_warnings[0].find("20 nodes need"), std::string::npos) << page.run_warnings[0];
}

Mission WithModem() {
  Mission mission = ReportsInWater();
  AcousticOptions& options = mission.acoustics.options;
  options.modem = ModemPreset{.name = "tiny",
                              .low_khz = 20,
                              .high_khz = 30,
                              .data_rate_bps = 1000,
                              .max_packet_bytes = 36,
                              .source_level_db = 190,
                              .typical_range_m = 1000};
  for (const char* number : {"band", "data_rate_bps", "max_packet_bytes", "source_level_db",
                             "typical_range_m", "modulation", "fading", "code"}) {
    options.modem->sources[number] = "estimate: made up";
  }
  options.packet_loss_model = PacketLossModel::kModem;
  options.half_duplex = true;
  return mission;
}

class SmallModem : public WaterFixture {
 protected:
  SmallModem() : WaterFixture(WithModem()) {}
};

TEST_F(SmallModem, TakesNothingLongerThanItsPackets) {
  Begin();
  EXPECT_EQ(Fates(), (std::vector<std::string>{"alpha>bravo too_long", "bravo>alpha too_long"}));
  EXPECT_EQ(fates_[0].length_bytes, 37);
  EXPECT_EQ(fates_[0].length_limit_bytes, 36);
  SayPacket("alpha", Bytes(37));
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha> too_long"});
}

TEST_F(SmallModem, SaysHowLoudThePacketWas) {
  Begin();
  SayPacket("alpha", {1, 2});
  StepUntilFates();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>bravo delivered"});
  EXPECT_GT(fates_[0].path.at(0).snr_db, 20);
  EXPECT_LT(fates_[0].path.at(0).loss_probability, 0.01);
}

TEST_F(SmallModem, DoesNotHearWhileItSends) {
  Begin();
  SayPacket("alpha", Bytes(30));
  SayPacket("bravo", Bytes(30));
  StepUntilFates();
  EXPECT_EQ(Fates(),
            (std::vector<std::string>{"alpha>bravo half_duplex", "bravo>alpha half_duplex"}));
  EXPECT_EQ(fates_[0].path.at(0).own_packet, 0);
}

TEST_F(SmallModem, IsToldInTheRulesOfTheLog) {
  Step();
  ASSERT_EQ(rules_.size(), 1U);
  const Result<BrokerSetup> setup = SetupOf(rules_[0]);
  ASSERT_TRUE(setup.ok()) << setup.error();
  EXPECT_EQ(setup->acoustics, mission_.acoustics);
  EXPECT_EQ(setup->rules, mission_.comms);
  ASSERT_EQ(setup->nodes.size(), 2U);
  EXPECT_EQ(setup->nodes[1].address, 2);
  EXPECT_EQ(setup->origin.lat_deg, mission_.origin_lat_deg);
}

TEST_F(SmallModem, WithImpossibleRulesIsRefused) {
  Step();
  ASSERT_TRUE(SetupOf(rules_.at(0)).ok());
  const auto is_refused = [&](auto change) {
    comms_rules_t rules = rules_.at(0);
    change(&rules);
    return !SetupOf(rules).ok();
  };
  EXPECT_TRUE(is_refused([](comms_rules_t* rules) { rules->reports_over = "smoke"; }));
  EXPECT_TRUE(is_refused([](comms_rules_t* rules) { rules->acoustics = "crc = maybe"; }));
  EXPECT_TRUE(is_refused([](comms_rules_t* rules) { rules->origin_lat_deg = 91; }));
  EXPECT_TRUE(is_refused([](comms_rules_t* rules) { rules->acoustic_addresses[0] = -1; }));
}

RC_GTEST_PROP(Water, LosesTrackOfNothing, ()) {
  Mission mission = ReportsInWater();
  AcousticOptions& options = mission.acoustics.options;
  const auto choose = [](auto* choice, int num) {
    *choice = static_cast<std::remove_pointer_t<decltype(choice)>>(*rc::gen::inRange(0, num));
  };
  choose(&options.jitter, 2);
  choose(&options.collisions, 3);
  choose(&options.packet_loss_model, 4);
  choose(&options.bit_error_model, 4);
  options.packet_loss = 0.3;
  options.half_duplex = *rc::gen::arbitrary<bool>();
  mission.acoustics.crc = *rc::gen::arbitrary<bool>();
  choose(&mission.comms.reports_over, 2);
  mission.comms.stale_forget_s = 3;
  mission.comms.min_msg_interval_s = -1;
  MemoryBus hub;
  Bus& broker_bus = hub.Join("shore_broker");
  Bus& others = hub.Join("others");
  ShoreBrokerApp broker(mission, broker_bus);
  std::array<int64_t, kNumKinds> num_told = {};
  int64_t num_handed_over = 0;
  Subscribe(others, channels::CommsFates(), [&](const comms_fates_t& message) {
    for (const fate_t& fate : message.fates) {
      for (int kind = 0; kind < kNumKinds; ++kind) {
        if (fate.kind == KindText(static_cast<Kind>(kind))) {
          num_told[static_cast<size_t>(kind)] += fate.count;
        }
      }
      if (fate.cause == "delivered" || fate.cause == "damaged") ++num_handed_over;
    }
  });
  int64_t num_heard = 0;
  others.SubscribeAll([&](const Message& message) {
    const bool is_for_a_vehicle =
        message.channel.ends_with("_ALPHA") || message.channel.ends_with("_BRAVO") ||
        message.channel.ends_with("_NEMO") || message.channel.ends_with("_DORY");
    if (message.publisher == "shore_broker" && is_for_a_vehicle) ++num_heard;
  });
  const std::vector<std::string> names = {"alpha", "bravo", "nemo", "dory"};
  const auto name = [&] { return *rc::gen::elementOf(names); };
  for (int step = 0; step < 60; ++step) {
    const int num_said = *rc::gen::inRange(0, 4);
    for (int i = 0; i < num_said; ++i) {
      switch (*rc::gen::inRange(0, 4)) {
        case 0:
          Publish(others, channels::NodeReportLocal(),
                  ReportFrom(name(), *rc::gen::inRange(0, 300)));
          break;
        case 1:
          Publish(others, channels::NodeMessageLocal(), MessageFrom(name(), name()));
          break;
        case 2: {
          acoustic_tx_t packet = {};
          packet.source = name();
          packet.num_bytes = *rc::gen::inRange(0, 60);
          packet.payload.resize(static_cast<size_t>(packet.num_bytes));
          Publish(others, channels::AcousticTx(), packet);
          break;
        }
        default:
          break;
      }
    }
    hub.NextStep();
    hub.HandleAll();
    broker.Tick(kStart_utime + step * kStep_us);
    hub.NextStep();
    hub.HandleAll();
    for (int kind = 0; kind < kNumKinds; ++kind) {
      const CauseCounts& counts = broker.router().counts(static_cast<Kind>(kind));
      const int64_t in_transit = counts[static_cast<size_t>(Cause::kInTransit)];
      RC_ASSERT(std::accumulate(counts.begin(), counts.end(), int64_t{0}) - in_transit ==
                num_told[static_cast<size_t>(kind)]);
    }
    RC_ASSERT(num_heard == num_handed_over);
  }
}

}  // namespace
}  // namespace shoal
