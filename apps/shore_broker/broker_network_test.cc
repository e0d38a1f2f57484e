// Which vehicles have a channel, what a modem changes, and how the log's rules show both.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_network_test {

Mission WithoutALeader() {
  Mission mission = QuietNetwork();
  mission.acoustics.options.access_mode = AccessMode::kTdmaLf;
  return mission;
}

class NetworkWithoutALeader : public AcousticFixture {
 protected:
  NetworkWithoutALeader() : AcousticFixture(WithoutALeader()) {}
};

TEST_F(NetworkWithoutALeader, CarriesNothing) {  // A log's COMMS_RULES may have no leader.
  Begin();
  SendPacket("alpha", {1});
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>(1, "alpha>bravo no_channel"));
}

Mission ThinBand() {
  Mission mission = QuietNetwork();
  mission.acoustics.options.access_mode = AccessMode::kFdma;
  mission.acoustics.options.bandwidth_khz = 2.75;  // Two channels.
  return mission;
}

class NarrowBand : public AcousticFixture {
 protected:
  NarrowBand() : AcousticFixture(ThinBand()) {}
};

TEST_F(NarrowBand, HasNoChannelForAnUnregisteredVehicle) {
  Begin();
  Send(ReportFrom("nemo", 100));
  Step();
  SendPacket("alpha", {1});
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>nemo no_channel"});
  SendPacket("nemo", {1});
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

class UnusableNetwork : public AcousticFixture {
 protected:
  UnusableNetwork() : AcousticFixture(TooManyForTheBand()) {}
};

TEST_F(UnusableNetwork, IsNotReportedWhereNothingIsSentOverIt) {
  Begin();
  Send(ReportFrom("alpha", 0));
  Step();
  EXPECT_EQ(broker_.Status().run_warnings, std::vector<std::string>());
}

TEST_F(UnusableNetwork, IsReportedWhenAVehicleSends) {
  Begin();
  SendPacket("alpha", {1});
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>bravo no_channel"});
  const StatusPage page = broker_.Status();
  ASSERT_EQ(page.run_warnings.size(), 1U);
  EXPECT_NE(page.run_warnings[0].find("20 nodes need"), std::string::npos) << page.run_warnings[0];
}

Mission WithModem() {
  Mission mission = AcousticReports();
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

class SmallModem : public AcousticFixture {
 protected:
  SmallModem() : AcousticFixture(WithModem()) {}
};

TEST_F(SmallModem, TakesNothingLongerThanItsPackets) {
  Begin();
  EXPECT_EQ(Fates(), (std::vector<std::string>{"alpha>bravo too_long", "bravo>alpha too_long"}));
  EXPECT_EQ(fates_[0].length_bytes, 37);
  EXPECT_EQ(fates_[0].length_limit_bytes, 36);
  SendPacket("alpha", Bytes(37));
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha> too_long"});
}

TEST_F(SmallModem, ReportsTheSignalToNoiseRatioOfThePacket) {
  Begin();
  SendPacket("alpha", {1, 2});
  StepUntilFates();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>bravo delivered"});
  EXPECT_GT(fates_[0].path.at(0).snr_db, 20);
  EXPECT_LT(fates_[0].path.at(0).loss_probability, 0.01);
}

TEST_F(SmallModem, ReceivesNothingWhileItSends) {
  Begin();
  SendPacket("alpha", Bytes(30));
  SendPacket("bravo", Bytes(30));
  StepUntilFates();
  EXPECT_EQ(Fates(),
            (std::vector<std::string>{"alpha>bravo half_duplex", "bravo>alpha half_duplex"}));
  EXPECT_EQ(fates_[0].path.at(0).own_packet, 0);
}

TEST_F(SmallModem, StandsInTheRulesOfTheLog) {
  Step();
  ASSERT_EQ(rules_.size(), 1U);
  const Result<BrokerSetup> setup = SetupOf(rules_[0]);
  ASSERT_TRUE(setup.ok()) << setup.error();
  EXPECT_EQ(setup->media.acoustics, mission_.acoustics);
  EXPECT_EQ(setup->rules, mission_.comms);
  ASSERT_EQ(setup->nodes.size(), 2U);
  EXPECT_EQ(setup->nodes[1].address, 2);
  EXPECT_EQ(setup->origin.lat_deg, mission_.origin_lat_deg);
}

TEST_F(SmallModem, WithImpossibleRulesIsRefused) {
  Step();
  ASSERT_TRUE(SetupOf(rules_.at(0)).ok());
  const auto is_refused = [&](auto change) {
    BrokerRules rules = rules_.at(0);
    change(&rules);
    return !SetupOf(rules).ok();
  };
  EXPECT_TRUE(is_refused([](BrokerRules* rules) { rules->rules.reports_over = Over("smoke"); }));
  EXPECT_TRUE(is_refused([](BrokerRules* rules) { rules->media = "crc = maybe"; }));
  EXPECT_TRUE(is_refused([](BrokerRules* rules) { rules->origin.lat_deg = 91; }));
  EXPECT_TRUE(is_refused([](BrokerRules* rules) { rules->vehicles[0].address = -1; }));
}

}  // namespace shoal::broker_network_test
