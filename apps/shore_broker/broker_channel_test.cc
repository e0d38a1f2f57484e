// ACOUSTIC_TX_ON: packets on a channel that their sender chooses, through the broker.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_channel_test {

Mission ThreeInFdma() {
  Mission mission = QuietNetwork();
  mission.acoustics.options.access_mode = AccessMode::kFdma;
  Vehicle charlie = mission.vehicles[1];
  charlie.name = "charlie";
  mission.vehicles.push_back(charlie);
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    mission.vehicles[i].acoustic_address = static_cast<int>(i) + 1;
  }
  return mission;
}

class ChosenChannels : public AcousticFixture {
 protected:
  ChosenChannels() : AcousticFixture(ThreeInFdma()) {
    for (const std::string name : {"alpha", "bravo", "charlie"}) {
      Subscribe(listener_, channels::AcousticRxOn(name),
                [this, name](const acoustic_rx_on_t& packet) { on_[name].push_back(packet); });
      Subscribe(listener_, channels::AcousticRx(name),
                [this, name](const acoustic_rx_t& packet) { plain_[name].push_back(packet); });
    }
    Subscribe(listener_, channels::CommsFates(), [this](const comms_fates_t& message) {
      for (const fate_t& fate : message.fates) causes_[fate.destination] = fate;
    });
    Send(ReportFrom("charlie", 120));
    Begin();
  }

  void SendOn(const std::string& source, int channel, const Bytes& payload) {
    acoustic_tx_on_t packet = {};
    packet.source = source;
    packet.channel = channel;
    packet.num_bytes = static_cast<int32_t>(payload.size());
    packet.payload = payload;
    Publish(listener_, channels::AcousticTxOn(), packet);
  }

  /// Until every packet has its fates.
  void StepToTheEnd() {
    causes_.clear();
    for (int i = 0; i < 10; ++i) Step();
    ASSERT_EQ(causes_.size(), 2U);
  }

  std::map<std::string, std::vector<acoustic_rx_on_t>> on_;
  std::map<std::string, std::vector<acoustic_rx_t>> plain_;
  std::map<std::string, fate_t> causes_;  ///< By destination.
};

TEST_F(ChosenChannels, AreGivenToTheReceiverBesideThePacket) {
  const Bytes payload(37, 7);
  SendOn("alpha", 2, payload);  // Bravo's own: it does not listen on it.
  StepToTheEnd();
  ASSERT_EQ(plain_["charlie"].size(), 1U);
  ASSERT_EQ(on_["charlie"].size(), 1U);
  const acoustic_rx_on_t& packet = on_["charlie"][0];
  EXPECT_EQ(packet.channel, 2);
  EXPECT_EQ(packet.source, "alpha");
  EXPECT_EQ(packet.payload, payload);
  EXPECT_EQ(packet.number, plain_["charlie"][0].number);
  EXPECT_EQ(packet.sent_utime, plain_["charlie"][0].sent_utime);
  EXPECT_EQ(packet.arrived_utime, plain_["charlie"][0].arrived_utime);
  EXPECT_TRUE(on_["bravo"].empty());
  EXPECT_EQ(causes_["bravo"].cause, "not_listening");
}

TEST_F(ChosenChannels, AreNotPublishedForPacketsWithoutOne) {
  SendPacket("alpha", Bytes(37, 7));
  StepToTheEnd();
  EXPECT_EQ(plain_["charlie"].size(), 1U);
  EXPECT_TRUE(on_["charlie"].empty());
}

TEST_F(ChosenChannels, AreInTheFateOfThePacket) {
  SendOn("alpha", 3, Bytes(37, 7));
  StepToTheEnd();
  EXPECT_EQ(causes_["bravo"].cause, "delivered");
  EXPECT_EQ(causes_["bravo"].path.at(0).channel, 3);
}

TEST_F(ChosenChannels, ThatTheNetworkDoesNotHaveAreRefusedAndNamedInAWarning) {
  SendOn("alpha", 17, Bytes(37, 7));
  StepToTheEnd();
  EXPECT_EQ(causes_["bravo"].cause, "no_channel");
  EXPECT_EQ(causes_["charlie"].cause, "no_channel");
  EXPECT_TRUE(plain_.empty());
  const StatusPage page = broker_.Status();
  ASSERT_FALSE(page.run_warnings.empty());
  EXPECT_EQ(page.run_warnings[0],
            "ACOUSTIC_TX_ON of alpha: acoustic has no channel 17: send on one of its channels, "
            "1, 2, 3");
}

}  // namespace shoal::broker_channel_test
