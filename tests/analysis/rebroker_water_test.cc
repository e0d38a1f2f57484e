// Rebroker, with acoustic traffic.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "apps/shore_broker/shore_broker_app.h"
#include "lib/bus/bus/memory_bus.h"
#include "tests/analysis/rebroker_runs.h"

namespace shoal::rebroker_water_test {

TEST(RebrokerTestMission, HasAllSortsOfAcousticFates) {
  const std::map<std::string, int64_t> causes = CausesOf(RecordedEvents(kAcousticTraffic));
  for (const char* cause : {"report delivered", "report damaged", "report rejected",
                            "report half_duplex", "report packet_loss"}) {
    EXPECT_TRUE(causes.contains(cause)) << cause;
  }
}

TEST(Rebroker, DecidesAcousticTrafficAsRecorded) {
  std::vector<TestEvent> recorded = RecordedEvents(kAcousticTraffic);
  std::vector<TestEvent> written;
  const RebrokerOutcome outcome = AsRecorded(LogOf(recorded), &written);
  EXPECT_GT(outcome.comparison.num_recorded(), 100);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
  // Where vehicles are in truth, too: the network goes by it.
  std::erase_if(recorded, [](const TestEvent& event) {
    return !IsOfBroker(event.channel) && !event.channel.starts_with("NAV_");
  });
  ASSERT_EQ(written.size(), recorded.size());
  for (size_t i = 0; i < written.size(); ++i) {
    ASSERT_EQ(written[i].channel, recorded[i].channel) << i;
    ASSERT_EQ(written[i].data, recorded[i].data) << i << " " << written[i].channel;
  }
  EXPECT_TRUE(AsRecorded(LogOf(Sealed(recorded))).comparison.IsEqual()) << "lcm-logger's, too";
}

TEST(Rebroker, ShowsWhatDiffersWhereALogHasOtherPlacesInTruth) {
  std::vector<TestEvent> events = RecordedEvents(kAcousticTraffic);
  for (TestEvent& event : events) {
    nav_t nav;
    if (!event.channel.starts_with("NAV_") || !Decode(event.data, &nav)) continue;
    nav.x_m *= 3;
    EncodeInto(nav, &event.data);
  }
  const RebrokerOutcome outcome = AsRecorded(LogOf(events));
  EXPECT_GT(outcome.comparison.num_recorded(), 100);
  EXPECT_FALSE(outcome.comparison.IsEqual());
}

TEST(Rebroker, DecidesPacketsAsRecorded) {
  std::vector<TestEvent> recorded = RecordedEvents(kAcousticTraffic);
  acoustic_tx_t packet = {};
  packet.source = "alpha";
  packet.num_bytes = 20;
  packet.payload.resize(20);
  Bytes bytes;
  EncodeInto(packet, &bytes);
  for (const int64_t utime : {10'000'000, 20'000'000, 39'500'000}) {
    const auto place = std::find_if(recorded.begin(), recorded.end(),
                                    [&](const TestEvent& each) { return each.utime >= utime; });
    recorded.insert(place, {utime, channels::AcousticTx().name, bytes});
  }
  std::vector<TestEvent> written;
  AsRecorded(LogOf(recorded), &written);
  int64_t num_packets = 0;
  for (const auto& [cause, count] : CausesOf(written)) {
    if (cause.starts_with("packet ")) num_packets += count;
  }
  EXPECT_GE(num_packets, 4) << "the last may be in transit at the end";
  EXPECT_LE(num_packets, 6);
  EXPECT_TRUE(AsRecorded(LogOf(written)).comparison.IsEqual());
}

TEST(Rebroker, SendsAcousticallyWhatHadBeenSentDirectly) {
  const CommsLog log = LogOf(RecordedEvents());
  BrokerSetup setup = SetupFor(log);
  setup.rules.reports_over = Over("acoustic");
  setup.rules.groups = false;
  setup.media.acoustics.is_used = true;
  const RebrokerOutcome outcome = Rebroker(log, {.setup = setup}, MakeShoreBroker, {});
  const LinkTable::Change lost = outcome.links.Of("report", "alpha", "bravo", "bit_errors");
  EXPECT_EQ(lost.recorded, 0);
  EXPECT_GT(lost.now, 0);
}

/// Acoustic traffic counts its time from the mission's start, even after a broker's restart.
TEST(Rebroker, KnowsAfterARestartWhenTheMissionBegan) {
  std::vector<TestEvent> events = RecordedEvents(kAcousticTraffic);
  const Mission mission = TestMission(kAcousticTraffic);
  constexpr int64_t kFrom_utime = 19'900'000;
  constexpr int64_t kRestart_utime = 20'000'000;
  std::vector<TestEvent> late;
  std::erase_if(events, [&](const TestEvent& event) {
    const bool is_input = LogOf({event}).inputs.size() == 1;
    if (is_input && event.utime >= kFrom_utime) late.push_back(event);
    return !is_input && event.utime >= kFrom_utime;
  });
  MemoryBus hub;
  Bus& sender = hub.Join("sender");
  Bus& bus = hub.Join("shore_broker");
  ShoreBrokerApp broker(mission, bus);
  int64_t now_utime = 0;
  sender.SubscribeAll([&](const Message& message) {
    if (message.publisher != "shore_broker") return;
    events.push_back(
        {now_utime, std::string(message.channel), {message.data.begin(), message.data.end()}});
  });
  size_t next = 0;
  for (now_utime = kRestart_utime; now_utime <= 40'000'000; now_utime += mission.tick_us) {
    for (; next < late.size() && late[next].utime < now_utime; ++next) {
      sender.PublishBytes(late[next].channel, late[next].data);
    }
    hub.NextStep();
    hub.Handle(bus);
    broker.Tick(now_utime);
    hub.NextStep();
    hub.Handle(sender);
  }
  std::stable_sort(events.begin(), events.end(), [](const TestEvent& a, const TestEvent& b) {
    return std::tie(a.utime, a.channel) < std::tie(b.utime, b.channel);
  });
  const CommsLog log = LogOf(events);
  ASSERT_EQ(log.starts.size(), 2u);
  const RebrokerOutcome outcome = AsRecorded(log);
  EXPECT_GT(CausesOf(events)["report rejected"], 10);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
}

/// One step each would take this test for ever.
TEST(Rebroker, PassesOverTheStepsInWhichNothingArrives) {
  std::string slow = kAcousticTraffic;
  slow.replace(slow.find("data_rate_bps = 3000"), 20, "data_rate_bps = 0.1\nsound_speed_mps = 1");
  slow.replace(slow.find("duration_s = 40"), 15, "duration_s = 20");
  std::vector<TestEvent> events = RecordedEvents(slow);
  broker_rules_t rules;
  for (TestEvent& event : events) {
    if (event.channel != "COMMS_RULES" || !Decode(event.data, &rules)) continue;
    rules.tick_us = 1;
    EncodeInto(rules, &event.data);
  }
  const auto last_report = std::find_if(events.rbegin(), events.rend(), [](const auto& event) {
    return event.channel == "NODE_REPORT_LOCAL";
  });
  ASSERT_NE(last_report, events.rend());
  TestEvent report = *last_report;
  report.utime = 10 * 86'400'000'000;
  events.push_back(report);
  std::vector<TestEvent> written;
  AsRecorded(LogOf(events), &written);
  int64_t num_arrived = 0;
  for (const auto& [cause, count] : CausesOf(written)) num_arrived += count;
  EXPECT_GT(num_arrived, 0);
}

}  // namespace shoal::rebroker_water_test
