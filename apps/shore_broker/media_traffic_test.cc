// Radio, sound and gateways at the broker.
#include "apps/shore_broker/media_traffic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/shore_broker/broker_testing.h"

namespace shoal::media_traffic_test {

/// alpha and bravo with vhf of 1000 m; charlie with sound too. Reports go by vhf, else by sound.
Mission ThreeVehicles() {
  Mission mission = TwoVehicles();
  mission.vehicles.resize(3);
  mission.vehicles[2].name = "charlie";
  mission.vehicles[2].acoustic_address = 3;
  mission.comms.comms_range_m = -1;
  mission.comms.stale_time_s = -1;
  mission.comms.min_msg_interval_s = -1;
  mission.acoustics.is_used = true;
  AcousticOptions& options = mission.acoustics.options;
  options.access_mode = AccessMode::kShared;
  options.jitter = JitterModel::kOff;
  options.packet_loss_model = PacketLossModel::kOff;
  options.bit_error_model = BitErrorModel::kOff;
  MediumOptions vhf = {.name = "vhf"};
  vhf.radio.range_m = 1000;
  mission.media = {vhf};
  for (Vehicle& vehicle : mission.vehicles) vehicle.media.names = {"vhf", "acoustic"};
  mission.vehicles[0].media.names = {"vhf"};
  mission.comms.reports_over = Over("vhf,acoustic");
  mission.comms.messages_over = Over("vhf,acoustic");
  return mission;
}

class MediaFixture : public BrokerFixture {
 protected:
  explicit MediaFixture(const Mission& mission = ThreeVehicles()) : BrokerFixture(mission) {
    Subscribe(listener_, channels::CommsMedia(), [this](const comms_media_t& message) {
      media_.insert(media_.end(), message.media.begin(), message.media.end());
    });
    Subscribe(listener_, channels::RelayRx("charlie"),
              [this](const relay_t& relay) { relays_.push_back(relay); });
  }

  void SendNav(const std::string& name, double x_m, double depth_m) {
    nav_t nav{};
    nav.x_m = x_m;
    nav.z_m = depth_m;
    Publish(listener_, channels::Nav(name), nav);
  }
  /// All three report from x; where they are in truth is NAV's affair.
  void Begin(double alpha_m, double bravo_m, double charlie_m) {
    Send(ReportFrom("alpha", alpha_m));
    Send(ReportFrom("bravo", bravo_m));
    Send(ReportFrom("charlie", charlie_m));
    Step();
    for (int i = 0; i < 30; ++i) Step();  // What is in transit arrives.
    media_.clear();
  }
  /// Steps until `destination` has a fate; its cause, or "none".
  std::string CauseAt(const std::string& destination, int at_most = 40) {
    for (int i = 0; i < at_most; ++i) {
      Step();
      for (const fate_t& fate : fates_) {
        if (fate.destination == destination) return fate.cause;
      }
    }
    return "none";
  }
  const fate_medium_t* MediumAt(const std::string& destination) {
    const auto found = std::ranges::find(media_, destination, &fate_medium_t::destination);
    return found == media_.end() ? nullptr : &*found;
  }

  std::vector<fate_medium_t> media_;
  std::vector<relay_t> relays_;
};

TEST_F(MediaFixture, TakesTheFirstMediumThatCanWork) {
  Begin(0, 900, 1100);
  Send(ReportFrom("bravo", 900));
  EXPECT_EQ(CauseAt("alpha"), "delivered");
  ASSERT_NE(MediumAt("alpha"), nullptr);
  EXPECT_EQ(MediumAt("alpha")->medium, "vhf");
  EXPECT_EQ(MediumAt("alpha")->range_m, 900);
  EXPECT_EQ(MediumAt("alpha")->limit_m, 1000);
}

TEST_F(MediaFixture, FallsBackOnSoundWhereAnAntennaIsInTheWater) {
  SendNav("charlie", 1100, 12);
  Begin(0, 900, 1100);
  Send(ReportFrom("bravo", 900));
  EXPECT_EQ(CauseAt("charlie"), "delivered");
  ASSERT_NE(MediumAt("charlie"), nullptr);
  EXPECT_EQ(MediumAt("charlie")->medium, "acoustic");
  EXPECT_GT(MediumAt("charlie")->delay_s, 0.1);
}

TEST_F(MediaFixture, GivesTheFaultOfTheMediumThatBothHaveWithItsNumbers) {
  SendNav("charlie", 500, 12);
  Begin(0, 900, 500);
  Send(ReportFrom("alpha", 0));
  EXPECT_EQ(CauseAt("charlie"), "submerged") << "alpha has no modem";
  ASSERT_NE(MediumAt("charlie"), nullptr);
  EXPECT_EQ(MediumAt("charlie")->medium, "vhf");
  EXPECT_EQ(MediumAt("charlie")->depth_m, 12);
  EXPECT_EQ(MediumAt("charlie")->depth_limit_m, 0.5);
}

TEST_F(MediaFixture, DecidesByTheTruthNotByWhatIsReported) {
  Begin(0, 900, 5000);
  Send(ReportFrom("alpha", 0));
  EXPECT_EQ(CauseAt("charlie"), "out_of_range");
  SendNav("charlie", 800, 0);
  Step();
  Send(ReportFrom("alpha", 0));
  EXPECT_EQ(CauseAt("charlie"), "delivered");
}

class OneMedium : public MediaFixture {
 protected:
  OneMedium()
      : MediaFixture([] {
          Mission mission = ThreeVehicles();
          mission.vehicles[1].media.names = {"acoustic"};
          mission.media[0].radio.latency_s = 0.75;
          return mission;
        }()) {}
};

TEST_F(OneMedium, DeliversInTheStepInWhichItHasArrived) {
  Begin(0, 900, 500);
  Send(ReportFrom("alpha", 0));
  int num_steps = 0;
  while (received_["charlie"].empty() && num_steps < 40) {
    Step();
    ++num_steps;
  }
  EXPECT_EQ(num_steps, 8) << "sent one step before; 0.75 s later it is there in the eighth";
}

TEST_F(OneMedium, NamesNoMediumWhereTheTwoHaveNone) {
  Begin(0, 900, 500);
  Send(ReportFrom("alpha", 0));
  EXPECT_EQ(CauseAt("bravo"), "no_medium");
  EXPECT_EQ(MediumAt("bravo")->medium, "");
}

class AllAtOnce : public MediaFixture {
 protected:
  AllAtOnce()
      : MediaFixture([] {
          Mission mission = ThreeVehicles();
          mission.comms.reports_over = Over("vhf+acoustic");
          return mission;
        }()) {}
};

TEST_F(AllAtOnce, GivesOneFateAndDeliversTheFirstToArrive) {
  Begin(0, 900, 500);
  Send(ReportFrom("bravo", 900));
  int num_fates = 0;
  int num_received = 0;
  for (int i = 0; i < 40; ++i) {
    Step();
    num_fates += static_cast<int>(std::ranges::count(fates_, "charlie", &fate_t::destination));
    num_received += static_cast<int>(received_["charlie"].size());
  }
  EXPECT_EQ(num_fates, 1);
  EXPECT_EQ(num_received, 1);
  EXPECT_EQ(MediumAt("charlie")->medium, "vhf") << "sound is slower";
}

class GatewayFixture : public MediaFixture {
 protected:
  GatewayFixture()
      : MediaFixture([] {
          Mission mission = ThreeVehicles();
          mission.vehicles[2].media.gateway = {.exists = true, .from = {"acoustic"}, .to = {"vhf"}};
          return mission;
        }()) {}

  relay_t Forwarded(const node_report_t& report, int64_t number, const std::string& via) {
    relay_t relay{};
    relay.gateway = "charlie";
    relay.kind = "report";
    relay.origin = report.name;
    relay.number = number;
    relay.via = via;
    relay.media = {"vhf"};
    relay.num_media = 1;
    EncodeInto(report, &relay.data);
    relay.num_bytes = static_cast<int32_t>(relay.data.size());
    return relay;
  }
};

TEST_F(GatewayFixture, IsGivenWhatCameByItsMediumAndMessagesForOthers) {
  SendNav("bravo", 900, 20);
  Begin(0, 900, 1000);
  relays_.clear();
  Send(ReportFrom("bravo", 900));
  Send(ReportFrom("alpha", 0));
  for (int i = 0; i < 20; ++i) Step();  // Two packets at once would collide.
  Send(MessageFrom("bravo", "alpha"));
  for (int i = 0; i < 40; ++i) Step();
  ASSERT_EQ(relays_.size(), 2U) << "alpha's report came by radio";
  EXPECT_EQ(relays_[0].kind, "report");
  EXPECT_EQ(relays_[0].origin, "bravo");
  EXPECT_EQ(relays_[0].number, 1);
  EXPECT_EQ(relays_[0].medium, "acoustic");
  EXPECT_EQ(relays_[1].kind, "message");
  EXPECT_TRUE(messages_["charlie"].empty()) << "it was for alpha";
}

TEST_F(GatewayFixture, ForwardsAsATransmissionOfItsOwnToAllThatHaveItNot) {
  SendNav("bravo", 900, 20);
  Begin(0, 900, 950);
  Publish(listener_, channels::RelayTx(), Forwarded(ReportFrom("bravo", 900), 1, "charlie"));
  Step();
  EXPECT_EQ(Fates(), (std::vector<std::string>{"charlie>bravo already_received",
                                               "charlie>alpha delivered"}));
  ASSERT_NE(MediumAt("alpha"), nullptr);
  EXPECT_EQ(MediumAt("alpha")->hop, 1);
  EXPECT_EQ(MediumAt("alpha")->origin, "bravo");
  Publish(listener_, channels::RelayTx(), Forwarded(ReportFrom("bravo", 900), 1, "charlie"));
  Step();
  EXPECT_EQ(Fates(), (std::vector<std::string>{"charlie>bravo already_received",
                                               "charlie>alpha already_received"}));
}

TEST_F(GatewayFixture, GivesWhatItDoesNotForwardAFate) {
  Begin(0, 900, 950);
  relay_t relay = Forwarded(ReportFrom("bravo", 900), 1, "");
  relay.refused = "queue_full";
  Publish(listener_, channels::RelayTx(), relay);
  Step();
  ASSERT_EQ(fates_.size(), 1U);
  EXPECT_EQ(fates_[0].source, "charlie");
  EXPECT_EQ(fates_[0].destination, "");
  EXPECT_EQ(fates_[0].cause, "queue_full");
}

TEST_F(GatewayFixture, IsRefusedWhereItIsNone) {
  Begin(0, 900, 950);
  relay_t relay = Forwarded(ReportFrom("bravo", 900), 1, "alpha");
  relay.gateway = "alpha";
  Publish(listener_, channels::RelayTx(), relay);
  Step();
  EXPECT_TRUE(fates_.empty());
}

}  // namespace shoal::media_traffic_test
