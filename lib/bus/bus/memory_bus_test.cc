#include "lib/bus/bus/memory_bus.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <random>
#include <set>

#include "lib/bus/bus/channels.h"

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

/// A mission of small participants that publish at random, in one hub or in several parts.
class PartsOfAMission {
 public:
  static constexpr int kNumParticipants = 12;
  static constexpr int kNumChannels = 9;

  PartsOfAMission(int num_parts, uint64_t seed) : hubs_(static_cast<size_t>(num_parts)) {
    std::mt19937_64 random(seed);  // The same draws, whatever the number of parts.
    received_.resize(kNumParticipants);
    for (int i = 0; i < kNumParticipants; ++i) {
      for (int part = 0; part < num_parts; ++part) {
        MemoryBus& hub = hubs_[static_cast<size_t>(part)];
        if (part == PartOf(i)) {
          buses_.push_back(&hub.Join(NameOf(i)));
        } else {
          numbers_[{part, NameOf(i)}] = hub.JoinElsewhere(NameOf(i));
        }
      }
      for (int channel = 0; channel < kNumChannels; ++channel) {
        if (random() % 4 == 0) Subscribe(i, channel);
      }
    }
    ShareInterests();
  }

  void Step(std::mt19937_64* random) {
    for (int i = 0; i < kNumParticipants; ++i) {
      for (uint64_t n = (*random)() % 5; n > 0; --n) {
        const auto channel = static_cast<int>((*random)() % kNumChannels);
        buses_[static_cast<size_t>(i)]->PublishBytes(
            ChannelOf(channel), std::vector<uint8_t>{static_cast<uint8_t>((*random)() % 3)});
      }
    }
    for (int from = 0; from < num_parts(); ++from) Exchange(from);
    for (MemoryBus& hub : hubs_) hub.NextStep();
    for (int i = 0; i < kNumParticipants; ++i) {
      received_[static_cast<size_t>(i)] += "| ";
      hubs_[static_cast<size_t>(PartOf(i))].Handle(*buses_[static_cast<size_t>(i)]);
    }
  }

  void Subscribe(int participant, int channel) {
    std::string& received = received_[static_cast<size_t>(participant)];
    buses_[static_cast<size_t>(participant)]->SubscribeBytes(
        ChannelOf(channel), [&received](const Message& message) {
          received += fmt::format("{}/{}{} ", message.channel, message.publisher, message.data[0]);
        });
  }

  /// Has every part keep what the others read.
  void ShareInterests() {
    for (int part = 0; part < num_parts(); ++part) {
      std::set<std::string, std::less<>> wanted;
      for (int other = 0; other < num_parts(); ++other) {
        if (other == part) continue;
        for (const auto channel : hubs_[static_cast<size_t>(other)].SubscribedChannels()) {
          wanted.emplace(channel);
        }
      }
      hubs_[static_cast<size_t>(part)].KeepFor(
          [wanted](std::string_view channel) { return wanted.contains(channel); });
    }
  }

  const std::vector<std::string>& received() const { return received_; }

 private:
  int num_parts() const { return static_cast<int>(hubs_.size()); }
  int PartOf(int participant) const { return participant * 7 % num_parts(); }
  static std::string NameOf(int participant) {
    return std::string(1, static_cast<char>('a' + participant * 5 % kNumParticipants));
  }
  static std::string ChannelOf(int channel) { return fmt::format("C{}", channel * 4 % 9); }

  void Exchange(int from) {
    hubs_[static_cast<size_t>(from)].VisitPublished([&](const MemoryBus::Published& each) {
      for (int to = 0; to < num_parts(); ++to) {
        if (to == from) continue;
        hubs_[static_cast<size_t>(to)].Insert(numbers_.at({to, std::string(each.publisher)}),
                                              each.channel, each.sequence, each.data);
      }
    });
  }

  std::vector<MemoryBus> hubs_;
  std::vector<Bus*> buses_;
  std::map<std::pair<int, std::string>, uint32_t> numbers_;
  std::vector<std::string> received_;
};

TEST(MemoryBus, GivesTheSameInPartsAsInOne) {
  for (uint64_t seed = 1; seed <= 15; ++seed) {
    PartsOfAMission whole(1, seed);
    std::mt19937_64 random(seed);
    for (int step = 0; step < 20; ++step) {
      if (step == 10) whole.Subscribe(3, 2);
      whole.Step(&random);
    }
    for (const int num_parts : {2, 3, 5, 12}) {
      PartsOfAMission parts(num_parts, seed);
      std::mt19937_64 again(seed);
      for (int step = 0; step < 20; ++step) {
        if (step == 10) {
          parts.Subscribe(3, 2);
          parts.ShareInterests();
        }
        parts.Step(&again);
      }
      ASSERT_EQ(parts.received(), whole.received()) << "seed " << seed << ", parts " << num_parts;
    }
    EXPECT_GT(fmt::format("{}", fmt::join(whole.received(), "")).size(), 2000U);
  }
}

TEST(MemoryBus, KeepsTheOrderWhenAParticipantElsewhereJoinsInMidMission) {
  MemoryBus hub;
  Bus& b = hub.Join("b");
  Bus& d = hub.Join("d");
  std::string received;
  d.SubscribeBytes("C", [&](const Message& message) {
    received += fmt::format("{}{} ", message.publisher, message.data[0]);
  });
  const auto publish = [](Bus& bus, uint8_t value) {
    bus.PublishBytes("C", std::vector<uint8_t>{value});
  };
  publish(d, 1);
  publish(b, 2);
  hub.NextStep();
  publish(d, 3);
  publish(b, 4);
  const uint32_t c = hub.JoinElsewhere("c");
  const uint32_t outside = hub.JoinElsewhere("");
  hub.Handle(d);
  EXPECT_EQ(received, "b2 d1 ");
  hub.Insert(c, "C", 1, std::vector<uint8_t>{6});
  hub.Insert(c, "C", 0, std::vector<uint8_t>{5});
  hub.Insert(outside, "C", 0, std::vector<uint8_t>{7});
  hub.Insert(c, "UNREAD", 2, std::vector<uint8_t>{8});
  received.clear();
  hub.NextStep();
  hub.Handle(d);
  EXPECT_EQ(received, "7 b4 c5 c6 d3 ");
}

TEST(MemoryBus, OrdersByPlacesWhatSeveralPartsPublishAsOneParticipant) {
  std::vector<std::string> received(2);
  std::vector<MemoryBus> hubs(2);
  std::vector<Bus*> shared;
  std::vector<Bus*> readers;
  for (size_t part = 0; part < 2; ++part) {
    shared.push_back(&hubs[part].JoinShared("broker"));
    readers.push_back(&hubs[part].Join(part == 0 ? "reader_0" : "reader_1"));
    hubs[part].JoinElsewhere(part == 0 ? "reader_1" : "reader_0");
    readers[part]->SubscribeBytes("C", [&received, part](const Message& message) {
      received[part] += fmt::format("{}{} ", message.publisher, message.data[0]);
    });
    hubs[part].KeepFor([](std::string_view) { return true; });
  }
  const auto publish = [&](size_t part, uint8_t value) {
    shared[part]->PublishBytes("C", std::vector<uint8_t>{value});
  };
  for (int step = 0; step < 2; ++step) {
    received = {"", ""};
    publish(0, 1);
    shared[0]->SetPlace(2);
    publish(0, 4);
    publish(0, 5);
    shared[1]->SetPlace(1);
    publish(1, 2);
    publish(1, 3);
    shared[1]->SetPlace(kNumPlaces - 1);
    publish(1, 6);
    std::vector<std::tuple<size_t, uint32_t, uint8_t>> sent;
    for (size_t part = 0; part < 2; ++part) {
      hubs[part].VisitPublished([&](const MemoryBus::Published& each) {
        EXPECT_EQ(each.publisher, "broker");
        sent.emplace_back(1 - part, each.sequence, each.data[0]);
      });
    }
    EXPECT_EQ(sent.size(), 6U);
    for (const auto& [to, sequence, value] : sent) {
      hubs[to].Insert(0, "C", sequence, std::vector<uint8_t>{value});
    }
    for (size_t part = 0; part < 2; ++part) {
      hubs[part].NextStep();
      hubs[part].Handle(*readers[part]);
      EXPECT_EQ(received[part], "broker1 broker2 broker3 broker4 broker5 broker6 ");
    }
  }
}

TEST(MemoryBus, ShowsWhatIsWantedElsewhereAndNothingThatCameFromThere) {
  MemoryBus hub;
  Bus& a = hub.Join("a");
  const uint32_t b = hub.JoinElsewhere("b");
  hub.Join("reader").SubscribeBytes("BOTH", [](const Message&) {});
  hub.KeepFor([](std::string_view channel) { return channel != "HERE"; });
  EXPECT_EQ(hub.SubscribedChannels(), std::vector<std::string_view>{"BOTH"});
  hub.NextStep();
  const std::vector<uint8_t> data = {1};
  for (const char* channel : {"HERE", "THERE", "BOTH"}) a.PublishBytes(channel, data);
  hub.Insert(b, "BOTH", 0, data);
  std::string published;
  hub.VisitPublished([&](const MemoryBus::Published& each) {
    published += fmt::format("{} {} {}; ", each.channel, each.publisher, each.sequence);
  });
  EXPECT_EQ(published, "THERE a 1; BOTH a 2; ");
  hub.KeepFor({});
  hub.NextStep();
  a.PublishBytes("THERE", data);
  hub.VisitPublished([&](const MemoryBus::Published&) { ADD_FAILURE() << "nothing is wanted"; });
}

}  // namespace shoal::memory_bus_test
