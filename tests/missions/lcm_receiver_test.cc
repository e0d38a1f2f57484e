// What LcmReceiver receives from liblcm's own publishers, and from programs that send what liblcm
// never would.
#include "lib/bus/bus/lcm_receiver.h"

#include <gtest/gtest.h>
#include <lcm/lcm.h>

#include <map>
#include <random>

#include "lib/bus/bus/layout.h"
#include "lib/bus/bus/socket_drops.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_registry.h"
#include "tests/missions/shoal_process.h"

namespace shoal::lcm_receiver_test {

class LcmReceiverTest : public testing::Test {
 protected:
  static constexpr int kNumPorts = 2;

  LcmReceiverTest() : base_(*ClaimPorts(0, kNumPorts)) {
    for (int i = 0; i < kNumPorts; ++i) senders_.push_back(lcm_create(LcmUrl(base_ + i).c_str()));
  }
  ~LcmReceiverTest() override {
    for (lcm_t* each : senders_) lcm_destroy(each);
  }

  void Publish(int number, const std::string& channel, const Bytes& message) {
    EXPECT_EQ(lcm_publish(senders_[static_cast<size_t>(number)], channel.c_str(), message.data(),
                          static_cast<unsigned>(message.size())),
              0);
  }

  /// Receives until `awaited` has come, or patience ends; returns the last message of each channel.
  static std::map<std::string, Bytes> ReceiveUntil(LcmReceiver* receiver,
                                                   const std::string& awaited) {
    EXPECT_EQ(receiver->error(), "");
    std::map<std::string, Bytes> received;
    const double end_s = WallSeconds() + kPatience_s;
    while (!received.contains(awaited) && WallSeconds() < end_s) {
      receiver->Poll(50'000, -1, [&](int, std::string_view channel, std::span<const uint8_t> data) {
        received[std::string(channel)] = Bytes(data.begin(), data.end());
      });
    }
    return received;
  }

  int base_;
  std::vector<lcm_t*> senders_;
};

Bytes Counted(size_t size) {
  Bytes bytes(size);
  for (size_t i = 0; i < size; ++i) bytes[i] = static_cast<uint8_t>(i * 7 + i / 251);
  return bytes;
}

TEST_F(LcmReceiverTest, ReceivesTheChannelsOfEachPort) {
  LcmReceiver receiver;
  receiver.Listen(base_, "NAV_ALPHA");
  receiver.Listen(base_, "DONE");
  receiver.Listen(base_ + 1, "NAV_BRAVO");
  receiver.Poll(0, -1, [](int, std::string_view, std::span<const uint8_t>) {});
  const Bytes message = Counted(40);
  for (const std::string channel : {"NAV_ALPHA", "NAV_BRAVO", "NAV_ALPHA2", "HELM", "NAV_ALPH"}) {
    Publish(0, channel, message);
    Publish(1, channel, message);
  }
  std::map<std::string, Bytes> received = ReceiveUntil(&receiver, "NAV_BRAVO");
  // What is awaited is published last, so that the others would have come before it.
  Publish(0, "DONE", message);
  received.merge(ReceiveUntil(&receiver, "DONE"));
  EXPECT_EQ(received, (std::map<std::string, Bytes>{
                          {"NAV_ALPHA", message}, {"NAV_BRAVO", message}, {"DONE", message}}));
}

TEST_F(LcmReceiverTest, ReceivesMessagesOfEverySizeThatLiblcmFragments) {
  for (const size_t size : {size_t{0}, size_t{1}, size_t{1400}, size_t{65'000}, size_t{65'487},
                            size_t{65'536}, size_t{200'000}, size_t{1'000'000}}) {
    LcmReceiver receiver;
    receiver.ListenToAll(base_);
    Publish(0, "BIG", Counted(size));
    const auto received = ReceiveUntil(&receiver, "BIG");
    ASSERT_TRUE(received.contains("BIG")) << size;
    EXPECT_EQ(received.at("BIG"), Counted(size)) << size;
    EXPECT_EQ(receiver.num_refused(), 0);
  }
}

TEST_F(LcmReceiverTest, KeepsTheRestForTheNextPollWhereTheHandlerEndsOne) {
  LcmReceiver receiver;
  receiver.StampArrivals();
  receiver.Listen(base_, "N");
  const int64_t before_us = UnixMicroseconds();
  for (uint8_t i = 0; i < 100; ++i) Publish(0, "N", Bytes{i});
  std::vector<uint8_t> received;
  int num_polls = 0;
  const double end_s = WallSeconds() + kPatience_s;
  while (received.size() < 100 && WallSeconds() < end_s) {
    int num_in_poll = 0;
    receiver.Poll(50'000, -1, [&](int, std::string_view, std::span<const uint8_t> data) {
      received.push_back(data[0]);
      EXPECT_GE(receiver.arrived_utime(), before_us);
      EXPECT_LE(receiver.arrived_utime(), UnixMicroseconds());
      if (++num_in_poll == 7) receiver.EndPoll();
    });
    EXPECT_LE(num_in_poll, 7);
    EXPECT_TRUE(num_in_poll < 7 || receiver.has_more());
    ++num_polls;
  }
  std::vector<uint8_t> expected(100);
  for (size_t i = 0; i < 100; ++i) expected[i] = static_cast<uint8_t>(i);
  EXPECT_EQ(received, expected);
  EXPECT_GE(num_polls, 15);
}

TEST_F(LcmReceiverTest, SurvivesDatagramsOfEveryWrongKindAndGoesOnReceiving) {
  LcmReceiver receiver(FilterPlace::kProcess);
  receiver.Listen(base_, "NAV_ALPHA");
  receiver.Listen(base_, "DONE");
  // A name without its end; a fragment whose offset and length wrap; one of a message too large.
  const std::vector<std::string> fatal = {
      "LC02\1\1\1\1NAV_ALPHA",
      std::string("LC03\0\0\0\1\0\0\3\xe8\xff\xff\xff\xce\0\0\0\2NAV_ALPHA\0", 30) +
          std::string(100, 'x'),
      std::string("LC03\0\0\0\1\xff\xff\xff\xff\0\0\0\0\0\0\0\2NAV_ALPHA\0x", 31),
      "",
  };
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    SendDatagram(base_, fatal[static_cast<size_t>(i) % fatal.size()]);
    std::string bytes = fatal[random() % 3];
    for (int k = 0; k < 3; ++k)
      bytes[4 + random() % (bytes.size() - 4)] = static_cast<char>(random());
    SendDatagram(base_, bytes);
    if (i % 100 == 0) receiver.Poll(0, -1, [](int, std::string_view, std::span<const uint8_t>) {});
  }
  const double end_s = WallSeconds() + kPatience_s;
  bool has_come = false;
  while (!has_come && WallSeconds() < end_s) {
    Publish(0, "DONE", Bytes{1});
    receiver.Poll(50'000, -1, [&](int, std::string_view channel, std::span<const uint8_t>) {
      has_come = has_come || channel == "DONE";
    });
  }
  EXPECT_TRUE(has_come);
  EXPECT_GT(receiver.num_refused(), 1000);
}

TEST_F(LcmReceiverTest, HasTheKernelThrowAwayOtherChannels) {
  LcmReceiver receiver;
  receiver.Listen(base_, "NAV_ALPHA");
  const auto ignore = [](int, std::string_view, std::span<const uint8_t>) {};
  receiver.Poll(0, -1, ignore);  // From now on the filter holds.
  for (int i = 0; i < 50; ++i) Publish(0, "NAV_BRAVO", Counted(40));
  const std::vector<int> ports = {base_};
  EXPECT_GE(DroppedDatagrams(ports), 50);  // The kernel counts them so.
  Publish(0, "NAV_ALPHA", Counted(40));
  EXPECT_EQ(ReceiveUntil(&receiver, "NAV_ALPHA").size(), 1U);
}

TEST_F(LcmReceiverTest, DoesNotWakeUpForDeferredPortsAndReadsThemFirst) {
  for (const bool defers_before_it_listens : {true, false}) {
    LcmReceiver receiver;
    if (defers_before_it_listens) receiver.DeferFrom(base_ + 1);
    receiver.Listen(base_, "TICK");
    receiver.Listen(base_ + 1, "NAV_ALPHA");
    if (!defers_before_it_listens) receiver.DeferFrom(base_ + 1);
    std::vector<std::string> received;
    const auto poll = [&](WakeFor wake_for) {
      receiver.Poll(
          1'000, -1,
          [&](int, std::string_view channel, std::span<const uint8_t>) {
            received.emplace_back(channel);
          },
          wake_for);
    };
    poll(WakeFor::kSteps);  // Sets the filters.
    Publish(1, "NAV_ALPHA", Counted(40));
    for (int i = 0; i < 10; ++i) poll(WakeFor::kSteps);
    EXPECT_EQ(received, std::vector<std::string>{});
    Publish(0, "TICK", Counted(40));
    EXPECT_TRUE(AwaitThat([&] {
      poll(WakeFor::kSteps);
      return received.size() >= 2;
    }));
    EXPECT_EQ(received, (std::vector<std::string>{"NAV_ALPHA", "TICK"}));
    Publish(1, "NAV_ALPHA", Counted(40));
    EXPECT_TRUE(AwaitThat([&] {
      poll(WakeFor::kAll);
      return received.size() == 3;
    })) << "with kAll it wakes up for every port";
  }
}

TEST_F(LcmReceiverTest, StatesWhyAPortCannotBeOpened) {
  const int taken = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);  // It does not share.
  sockaddr_in address{};
  address.sin_family = AF_INET;
  ASSERT_EQ(bind(taken, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  socklen_t size = sizeof address;
  ASSERT_EQ(getsockname(taken, reinterpret_cast<sockaddr*>(&address), &size), 0);
  LcmReceiver receiver;
  receiver.Listen(ntohs(address.sin_port), "X");
  EXPECT_NE(receiver.error().find("Choose others with --port"), std::string::npos)
      << receiver.error();
  close(taken);
}

}  // namespace shoal::lcm_receiver_test
