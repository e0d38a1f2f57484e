#include "lib/bus/memory_bus.h"

#include <gtest/gtest.h>

#include "lib/bus/channels.h"

namespace shoal::memory_bus_test {

unc_control_t ControlOf(double value) {
  unc_control_t message{};
  message.value = value;
  return message;
}

TEST(MemoryBus, DeliversInTheNextStepAndNotBefore) {
  MemoryBus hub;
  Bus& a = hub.Join("a");
  Bus& b = hub.Join("b");
  std::vector<double> received;
  Subscribe(b, channels::Control(*FindControl("comms_range")),
            [&](const unc_control_t& m) { received.push_back(m.value); });
  Publish(a, channels::Control(*FindControl("comms_range")), ControlOf(1));
  hub.HandleAll();
  EXPECT_TRUE(received.empty());
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(received, std::vector<double>{1});
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(received, std::vector<double>{1});
}

TEST(MemoryBus, OrdersByChannelThenPublisherThenSequence) {
  MemoryBus hub;
  Bus& b = hub.Join("b");
  Bus& a = hub.Join("a");
  Bus& listener = hub.Join("listener");
  std::string received;
  listener.SubscribeAll([&](const Message& message) {
    unc_control_t control{};
    ASSERT_TRUE(Decode(message.data, &control));
    received += std::string(message.channel.substr(4)) + "/" + std::string(message.publisher) +
                std::to_string(static_cast<int>(control.value)) + " ";
  });
  Publish(b, channels::Control(*FindControl("stale_time")), ControlOf(1));
  Publish(b, channels::Control(*FindControl("comms_range")), ControlOf(2));
  Publish(a, channels::Control(*FindControl("stale_time")), ControlOf(3));
  Publish(a, channels::Control(*FindControl("stale_time")), ControlOf(4));
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(received, "COMMS_RANGE/b2 STALE_TIME/a3 STALE_TIME/a4 STALE_TIME/b1 ");
}

TEST(MemoryBus, LetsAnAppReceiveItsOwnMessages) {
  MemoryBus hub;
  Bus& a = hub.Join("a");
  int received = 0;
  Subscribe(a, channels::Control(*FindControl("comms_range")),
            [&](const unc_control_t&) { ++received; });
  Publish(a, channels::Control(*FindControl("comms_range")), ControlOf(1));
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(received, 1);
}

TEST(Bus, CountsWhatDoesNotDecodeAndGoesOn) {
  MemoryBus hub;
  Bus& a = hub.Join("a");
  int received = 0;
  Subscribe(a, channels::Control(*FindControl("comms_range")),
            [&](const unc_control_t&) { ++received; });
  const Bytes garbage = {1, 2, 3};
  a.PublishBytes("UNC_COMMS_RANGE", garbage);
  Publish(a, Channel<nav_t>{"UNC_COMMS_RANGE"}, nav_t{});
  Publish(a, channels::Control(*FindControl("comms_range")), ControlOf(1));
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(received, 1);
  EXPECT_EQ(a.counters().undecodable, 2);
  EXPECT_EQ(a.counters().undecodable_by_channel.at("UNC_COMMS_RANGE"), 2);
}

TEST(Decode, RefusesFalseLengths) {
  comms_fates_t fates{};
  fates.num_fates = 0;
  Bytes bytes;
  EncodeInto(fates, &bytes);
  bytes[16] = 0x7f;  // The high byte of num_fates: two thousand million fates in 20 bytes.
  comms_fates_t decoded{};
  EXPECT_FALSE(Decode(bytes, &decoded));
}

TEST(Decode, RefusesBytesTooManyAndTooFew) {
  Bytes bytes;
  EncodeInto(ControlOf(1), &bytes);
  unc_control_t decoded{};
  EXPECT_TRUE(Decode(bytes, &decoded));
  bytes.push_back(0);
  EXPECT_FALSE(Decode(bytes, &decoded));
  bytes.resize(bytes.size() - 2);
  EXPECT_FALSE(Decode(bytes, &decoded));
}

}  // namespace shoal::memory_bus_test
