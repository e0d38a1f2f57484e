// Packets over broker and acoustic network: what goes in, what comes out and when, and their fates.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_packets_test {

using Texts = std::vector<std::string>;

class CalmPackets : public AcousticFixture {};

TEST_F(CalmPackets, ArriveInTheStepOfTheirLastByte) {
  Begin();
  const Bytes payload(37, 7);
  SendPacket("alpha", payload);
  const int64_t published_utime = utime_;
  // 41 bytes take 0.328 s, the way 0.1 s: 0.428 s after it was published.
  EXPECT_EQ(StepUntilFates(), 5);
  ASSERT_EQ(packets_["bravo"].size(), 1U);
  EXPECT_TRUE(packets_["alpha"].empty());
  const acoustic_rx_t& packet = packets_["bravo"][0];
  EXPECT_EQ(packet.payload, payload);
  EXPECT_EQ(packet.source, "alpha");
  EXPECT_EQ(packet.number, 0);
  EXPECT_EQ(packet.utime, published_utime + 500'000);
  EXPECT_EQ(packet.sent_utime, published_utime);
  EXPECT_EQ(packet.arrived_utime, published_utime + 428'000);
  ASSERT_EQ(fates_.size(), 1U);
  EXPECT_EQ(fates_[0].kind, "packet");
  EXPECT_EQ(fates_[0].cause, "delivered");
  EXPECT_EQ(fates_[0].range_m, 150);
  EXPECT_EQ(fates_[0].limit_m, 250);
  ASSERT_EQ(fates_[0].path.size(), 1U);
  const acoustic_path_t& path = fates_[0].path[0];
  EXPECT_EQ(path.sent_utime, published_utime);
  EXPECT_EQ(path.num_bytes, 41);
  EXPECT_NEAR(path.air_s, 0.328, 1e-12);
  EXPECT_NEAR(path.travel_s, 0.1, 1e-12);
  EXPECT_EQ(path.jitter_s, 0);
  EXPECT_EQ(path.loss_probability, -1);
  EXPECT_EQ(path.snr_db, -999);
  EXPECT_EQ(pulses_.size(), 1U);
}

class PacketsByTruth : public AcousticFixture {
 protected:
  void SendNav(const std::string& name, double x_m) {
    nav_t nav{};
    nav.x_m = x_m;
    Publish(listener_, channels::Nav(name), nav);
  }
};

TEST_F(PacketsByTruth, TakeAsLongAsTheWayIsInTruth) {
  Send(ReportFrom("alpha", 0));
  Send(ReportFrom("bravo", 393));
  SendNav("alpha", 10);
  SendNav("bravo", 46);
  Step();
  SendPacket("alpha", Bytes(37, 7));
  EXPECT_GT(StepUntilFates(), 0);
  ASSERT_EQ(Fates(), Texts{"alpha>bravo delivered"}) << "393 m would be out of range";
  EXPECT_EQ(fates_[0].range_m, 36);
  EXPECT_NEAR(fates_[0].path.at(0).travel_s, 36 / 1500.0, 1e-12);
  ASSERT_EQ(pulses_.size(), 1U);
  EXPECT_EQ(pulses_[0].sx_m, 10);
}

TEST_F(PacketsByTruth, GoToAndFromVehiclesThatNeverReport) {
  SendNav("alpha", 0);
  SendNav("bravo", 150);
  Step();
  SendPacket("alpha", {1});
  EXPECT_GT(StepUntilFates(), 0);
  EXPECT_EQ(Fates(), Texts{"alpha>bravo delivered"});
  Send(MessageFrom("alpha", "bravo"));
  Step();
  EXPECT_EQ(Fates(), Texts{"alpha>bravo unknown_source"}) << "messages need reports";
}

TEST_F(PacketsByTruth, FindVehiclesFromOutsideWhereTheyReport) {
  SendNav("alpha", 0);
  SendNav("charlie", 5000);  // No vehicle of the mission.
  Send(ReportFrom("charlie", 90));
  Step();
  SendPacket("alpha", {1});
  EXPECT_GT(StepUntilFates(), 0);
  ASSERT_EQ(Fates(), Texts{"alpha>charlie delivered"});
  EXPECT_EQ(fates_[0].range_m, 90);
}

TEST_F(CalmPackets, OfAModemGoAtItsRateAndHaveNoRange) {
  Send(ReportFrom("alpha", 0));
  Send(ReportFrom("bravo", 1500));
  Step();
  SendPacket("alpha", {1, 2, 3});
  Step();
  ASSERT_EQ(Fates(), Texts{"alpha>bravo out_of_range"});
  SendModemPacket("alpha", Bytes(6, 7), 80);
  const int64_t published_utime = utime_;
  EXPECT_GT(StepUntilFates(), 0);
  ASSERT_EQ(Fates(), Texts{"alpha>bravo delivered"});
  EXPECT_EQ(fates_[0].limit_m, -1);
  ASSERT_EQ(fates_[0].path.size(), 1U);
  EXPECT_EQ(fates_[0].path[0].num_bytes, 10);
  EXPECT_NEAR(fates_[0].path[0].air_s, 1, 1e-12) << "10 bytes at 80 bit/s";
  EXPECT_EQ(packets_["bravo"].at(0).arrived_utime, published_utime + 2'000'000);
  for (const double bad_bps : {-1.0, 0.01, std::numeric_limits<double>::quiet_NaN()}) {
    SendModemPacket("alpha", Bytes(6, 7), bad_bps);
    Step();
    EXPECT_EQ(Fates(), Texts{"alpha> invalid"}) << bad_bps;
  }
}

TEST_F(CalmPackets, AreShownOnThePageWhileTheyAreInTransit) {
  Begin();
  SendPacket("alpha", {1, 2, 3});
  Step();
  EXPECT_TRUE(fates_.empty());
  EXPECT_TRUE(PageHas("Total Packets Received: 1")) << broker_.Status().text;
  EXPECT_TRUE(PageHas("In Transit: 1"));
  StepUntilFates();
  EXPECT_FALSE(PageHas("In Transit"));
  EXPECT_TRUE(PageHas("    transmissions                    1")) << broker_.Status().text;
}

TEST_F(CalmPackets, ThatOverlapAtTheirReceiverCollideAndNameEachOther) {
  Begin();
  Send(ReportFrom("charlie", 75));
  Step();
  SendPacket("alpha", {1, 2, 3});
  SendPacket("bravo", {4, 5, 6});
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

TEST_F(CalmPackets, LeaveInTheirOrderWhereAStepIsLongerThanATick) {
  // A live broker steps when something comes: what waits in one modem is due before another sends.
  Begin();
  SendPacket("alpha", Bytes(20));
  SendPacket("alpha", Bytes(20));
  Step();
  SendPacket("bravo", Bytes(20));
  Step(20 * kStep_us);
  Texts fates = Fates();
  for (int i = 0; i < 50; ++i) {
    Step();
    for (const std::string& fate : Fates()) fates.push_back(fate);
  }
  EXPECT_FALSE(PageHas("In Transit"));
  EXPECT_EQ(fates,
            (Texts{"alpha>bravo delivered", "alpha>bravo delivered", "bravo>alpha delivered"}));
}

TEST_F(CalmPackets, WithoutSenderOrPayloadAreRefused) {
  Begin();
  SendPacket("alpha", {});
  SendPacket("no name", {1});
  SendPacket("unregistered", {1});
  SendPacket("alpha", Bytes(70'000));
  Step();
  EXPECT_EQ(Fates(), (std::vector<std::string>{"alpha> invalid", "> invalid",
                                               "unregistered> unknown_source", "alpha> too_long"}));
  EXPECT_EQ(fates_[3].length_limit_bytes, 65'535);
}

Mission WithoutQueue() {
  Mission mission = QuietNetwork();
  mission.acoustics.queue = false;
  return mission;
}

class PacketsWithoutQueue : public AcousticFixture {
 protected:
  PacketsWithoutQueue() : AcousticFixture(WithoutQueue()) {}
};

TEST_F(PacketsWithoutQueue, OfAVehicleWithTooManyInTransitFindNoChannel) {
  Begin();
  for (int i = 0; i < AcousticTraffic::kMaxPacketsOfOne + 3; ++i) SendPacket("alpha", Bytes(1000));
  Step();
  EXPECT_EQ(Fates(), std::vector<std::string>(3, "alpha>bravo no_channel"));
}

}  // namespace shoal::broker_packets_test
