#include "lib/bus/memory_bus.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

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

TEST(MemoryBus, DeliversNothingToSubscriptionsThatEndedAndAgainToNewOnes) {
  MemoryBus hub;
  Bus& a = hub.Join("a");
  Bus& b = hub.Join("b");
  const Channel<unc_control_t> channel = channels::Control(*FindControl("comms_range"));
  std::vector<double> first;
  std::vector<double> second;
  const auto step = [&](double value) {
    Publish(a, channel, ControlOf(value));
    hub.NextStep();
    hub.HandleAll();
  };
  Subscribe(b, channel, [&](const unc_control_t& m) { first.push_back(m.value); });
  step(1);
  Publish(a, channel, ControlOf(2));
  hub.EndSubscriptions(b);
  hub.NextStep();
  hub.HandleAll();
  step(3);
  Subscribe(b, channel, [&](const unc_control_t& m) { second.push_back(m.value); });
  step(4);
  EXPECT_EQ(first, std::vector<double>{1});
  EXPECT_EQ(second, std::vector<double>{4});
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

/// Counts how often it is made of a message.
struct CountedView {
  explicit CountedView(const unc_control_t& message) : value(message.value) { ++num_made; }
  double value;
  static inline int num_made = 0;
};

struct ReportView {
  explicit ReportView(const node_report_t& report) : name(report.name) { ++num_made; }
  std::string name;
  static inline int num_made = 0;
};

TEST(MemoryBus, MakesAViewOfAMessageOnceForAllItsSubscribers) {
  MemoryBus hub;
  Bus& publisher = hub.Join("publisher");
  const auto channel = channels::Control(*FindControl("comms_range"));
  std::vector<double> received;
  std::set<const CountedView*> views;
  for (const char* name : {"a", "b", "c"}) {
    SubscribeAs<CountedView>(hub.Join(name), channel, [&](const CountedView& view) {
      received.push_back(view.value);
      views.insert(&view);
    });
  }
  CountedView::num_made = 0;
  for (const double value : {1, 2, 3, 4}) {
    Publish(publisher, channel, ControlOf(value));
    hub.NextStep();
    hub.HandleAll();
  }
  EXPECT_EQ(received, (std::vector<double>{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}));
  EXPECT_EQ(CountedView::num_made, 4);
  EXPECT_EQ(views.size(), 2U) << "the storage of the step before the last is used again";
}

TEST(MemoryBus, MakesAViewOnceForTheSameBytesOnManyChannels) {
  MemoryBus hub;
  Bus& broker = hub.Join("broker");
  std::vector<std::string> received;
  for (const char* name : {"alpha", "bravo", "charlie"}) {
    SubscribeAs<ReportView>(hub.Join(name), channels::NodeReport(name),
                            [&received, name](const ReportView& view) {
                              received.push_back(name + (" " + view.name));
                            });
  }
  ReportView::num_made = 0;
  node_report_t report{};
  for (const char* source : {"xray", "yoke"}) {
    report.name = source;
    for (const char* name : {"alpha", "bravo", "charlie"}) {
      Publish(broker, channels::NodeReport(name), report);
    }
  }
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(received, (std::vector<std::string>{"alpha xray", "alpha yoke", "bravo xray",
                                                "bravo yoke", "charlie xray", "charlie yoke"}));
  EXPECT_EQ(ReportView::num_made, 2);
}

TEST(MemoryBus, CountsABadMessageForEachOfItsSubscribers) {
  MemoryBus hub;
  Bus& publisher = hub.Join("publisher");
  Bus& a = hub.Join("a");
  Bus& b = hub.Join("b");
  const auto channel = channels::Control(*FindControl("comms_range"));
  int num_received = 0;
  Subscribe(a, channel, [&](const unc_control_t&) { ++num_received; });
  SubscribeAs<CountedView>(b, channel, [&](const CountedView&) { ++num_received; });
  Publish(publisher, channel, ControlOf(1));
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(num_received, 2);
  publisher.PublishBytes(channel.name, std::vector<uint8_t>{1, 2, 3});
  hub.NextStep();
  hub.HandleAll();
  EXPECT_EQ(num_received, 2) << "what the message before was is forgotten";
  EXPECT_EQ(a.counters().undecodable, 1);
  EXPECT_EQ(b.counters().undecodable, 1);
}

TEST(MemoryBus, GivesAnEmptyListWhereAnEarlierMessageHadNumbers) {
  MemoryBus hub;
  Bus& publisher = hub.Join("publisher");
  std::vector<size_t> sizes;
  for (const char* name : {"a", "b"}) {
    Subscribe(hub.Join(name), channels::SimCommand("alpha"),
              [&](const sim_command_t& command) { sizes.push_back(command.values.size()); });
  }
  for (const bool is_empty : {false, false, true, true}) {
    sim_command_t command{};
    if (!is_empty) command.values = {1, 2, 3};
    command.num_values = static_cast<int32_t>(command.values.size());
    Publish(publisher, channels::SimCommand("alpha"), command);
    hub.NextStep();
    hub.HandleAll();
  }
  EXPECT_EQ(sizes, (std::vector<size_t>{3, 3, 3, 3, 0, 0, 0, 0}));
}

TEST(MemoryBus, GivesNumbersAsTheyWerePublishedAndAsTheirBytesAre) {
  MemoryBus hub;
  Bus& publisher = hub.Join("publisher");
  Bus& reader = hub.Join("reader");
  nav_t published{};
  published.utime = -5;
  published.x_m = std::numeric_limits<double>::quiet_NaN();
  published.y_m = -0.0;
  published.altitude_m = 1e-310;
  Bytes of_bytes;
  Bytes of_view;
  Subscribe(reader, channels::Nav("alpha"), [&](const nav_t& nav) { EncodeInto(nav, &of_view); });
  reader.SubscribeBytes("NAV_ALPHA", [&](const Message& message) {
    of_bytes.assign(message.data.begin(), message.data.end());
  });
  Publish(publisher, channels::Nav("alpha"), published);
  hub.NextStep();
  hub.HandleAll();
  Bytes expected;
  EncodeInto(published, &expected);
  EXPECT_EQ(of_bytes, expected);
  EXPECT_EQ(of_view, expected);
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
