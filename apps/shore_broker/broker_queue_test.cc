// What a vehicle sends while its modem is busy.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_queue_test {

Mission WithQueue(bool queue, int64_t length = 16,
                  Acoustics::QueueDrop drop = Acoustics::QueueDrop::kOldest) {
  Mission mission = QuietNetwork();
  mission.acoustics.queue = queue;
  mission.acoustics.queue_length = length;
  mission.acoustics.queue_drop = drop;
  return mission;
}

class QueueFixture : public AcousticFixture {
 protected:
  explicit QueueFixture(const Mission& mission = WithQueue(true)) : AcousticFixture(mission) {}

  /// alpha sends packets 1 ... `num_packets` in one step. Returns "number cause" in the order in
  /// which that was known.
  std::vector<std::string> SendAtOnce(int num_packets) {
    Begin();
    for (int i = 1; i <= num_packets; ++i) {
      SendPacket("alpha", Bytes(20, static_cast<uint8_t>(i)));
    }
    std::vector<std::string> causes;
    for (int i = 0; i < 60; ++i) {
      Step();
      for (const fate_t& fate : fates_) {
        if (fate.kind != "packet") continue;
        causes.push_back(std::to_string(fate.number + 1) + " " + fate.cause);
        steps_.push_back(i);
      }
    }
    return causes;
  }

  std::vector<int> steps_;  ///< In which the causes were known.
};

TEST_F(QueueFixture, SendsOnePacketAfterAnother) {
  EXPECT_EQ(SendAtOnce(4),
            (std::vector<std::string>{"1 delivered", "2 delivered", "3 delivered", "4 delivered"}));
  // 24 bytes with the checksum take 0.192 s.
  EXPECT_NEAR(steps_.back() - steps_.front(), 3 * 1.92, 1);
}

class QueueOfReports : public AcousticFixture {
 protected:
  QueueOfReports() : AcousticFixture(AcousticReports()) {}
};

TEST_F(QueueOfReports, KeepsOnlyTheNewest) {
  for (int i = 0; i < 10; ++i) Step();
  Begin();
  for (int i = 0; i < 20; ++i) Step();
  // The first is sent; each of the others takes the place of the one before.
  for (int i = 1; i <= 4; ++i) Send(ReportFrom("alpha", i));
  std::vector<std::string> causes;
  for (int i = 0; i < 30; ++i) {
    Step();
    for (const fate_t& fate : fates_) {
      if (fate.source == "alpha" && fate.kind == "report") causes.push_back(fate.cause);
    }
  }
  std::sort(causes.begin(), causes.end());
  EXPECT_EQ(causes,
            (std::vector<std::string>{"delivered", "delivered", "queue_full", "queue_full"}));
}

class NoQueue : public QueueFixture {
 protected:
  NoQueue() : QueueFixture(WithQueue(false)) {}
};

TEST_F(NoQueue, LetsPacketsOfOneVehicleMeetAsMunetDoes) {
  EXPECT_EQ(SendAtOnce(2), (std::vector<std::string>{"1 collision", "2 collision"}));
}

class ShortQueueOfTheNewest : public QueueFixture {
 protected:
  ShortQueueOfTheNewest() : QueueFixture(WithQueue(true, 2)) {}
};

TEST_F(ShortQueueOfTheNewest, ThrowsAwayWhatHasWaitedLongest) {
  EXPECT_EQ(SendAtOnce(5), (std::vector<std::string>{"2 queue_full", "3 queue_full", "1 delivered",
                                                     "4 delivered", "5 delivered"}));
}

class ShortQueueOfTheOldest : public QueueFixture {
 protected:
  ShortQueueOfTheOldest() : QueueFixture(WithQueue(true, 2, Acoustics::QueueDrop::kNewest)) {}
};

TEST_F(ShortQueueOfTheOldest, TakesNothingMoreIn) {
  EXPECT_EQ(SendAtOnce(5), (std::vector<std::string>{"4 queue_full", "5 queue_full", "1 delivered",
                                                     "2 delivered", "3 delivered"}));
}

/// charlie forwards what comes by vhf, and receives none.
Mission GatewayOfVhf() {
  Mission mission = AcousticReports();
  MediumOptions vhf = {.name = "vhf"};
  mission.media = {vhf};
  Vehicle charlie;
  charlie.name = "charlie";
  charlie.acoustic_address = 3;
  charlie.media.gateway = {.exists = true, .from = {"vhf"}, .to = {"vhf"}};
  mission.vehicles.push_back(charlie);
  for (Vehicle& vehicle : mission.vehicles) vehicle.media.names = {"acoustic"};
  mission.vehicles[2].media.names = {"acoustic", "vhf"};
  return mission;
}

class GatewayOfAnotherMedium : public AcousticFixture {
 protected:
  GatewayOfAnotherMedium() : AcousticFixture(GatewayOfVhf()) {}
};

TEST_F(GatewayOfAnotherMedium, HasNotReceivedWhatItThrowsAway) {
  Send(ReportFrom("charlie", 75));
  Step();
  for (int i = 0; i < 20; ++i) Step();
  Begin();
  for (int i = 0; i < 20; ++i) Step();
  Send(MessageFrom("alpha", "bravo"));
  std::vector<std::string> causes;
  for (int i = 0; i < 30; ++i) {
    Step();
    for (const fate_t& fate : fates_) {
      if (fate.kind == "message") causes.push_back(fate.destination + " " + fate.cause);
    }
  }
  std::sort(causes.begin(), causes.end());
  EXPECT_EQ(causes, (std::vector<std::string>{"bravo delivered", "charlie no_medium"}));
}

}  // namespace shoal::broker_queue_test
