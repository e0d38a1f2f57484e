#include "apps/shoal/rebroker.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "apps/shoal/rebroker_testing.h"
#include "apps/shore_broker/shore_broker_app.h"
#include "lib/bus/memory_bus.h"

namespace shoal {
namespace {

BrokerSetup SetupFor(const CommsLog& log) {
  const Result<BrokerSetup> setup = SetupOf(*log.rules);
  EXPECT_TRUE(setup.ok());
  return *setup;
}

RebrokerOutcome AsRecorded(const CommsLog& log, std::vector<TestEvent>* out = nullptr) {
  EventSink sink;
  if (out != nullptr) {
    sink = [out](int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
      out->push_back({utime, std::string(channel), {data.begin(), data.end()}});
    };
  }
  return Rebroker(log, {.setup = SetupFor(log), .absences = AbsencesIn(log)}, sink);
}

/// Of broker and log alone: what `shoal rebroker --log` writes.
bool IsOfBroker(const std::string& channel) {
  const auto& names = BrokerChannels();
  return std::find(names.begin(), names.end(), channel) != names.end() ||
         channel == "VIEW_COMMS_PULSE" || channel.starts_with("NODE_REPORT_") ||
         channel.starts_with("NODE_MESSAGE_") || channel.starts_with("ACK_MESSAGE_") ||
         channel.starts_with("ACOUSTIC_RX_");
}

std::vector<TestEvent> Talk(const std::string& mission = kTalkative) {
  const TestDirectory directory;
  Record(mission, directory.File("m.lcm"));
  return EventsOf(directory.File("m.lcm"));
}

std::map<std::string, int64_t> CausesOf(const std::vector<TestEvent>& events) {
  std::map<std::string, int64_t> causes;
  for (const TestEvent& event : events) {
    comms_fates_t fates;
    if (event.channel != "COMMS_FATES" || !Decode(event.data, &fates)) continue;
    for (const fate_t& fate : fates.fates) causes[fate.kind + " " + fate.cause] += fate.count;
  }
  return causes;
}

TEST(RebrokerTestMission, HasAllSortsOfFates) {
  const std::map<std::string, int64_t> causes = CausesOf(Talk());
  for (const char* cause :
       {"report delivered", "report out_of_range", "report dropped", "report other_group",
        "message delivered", "message too_soon", "ack delivered"}) {
    EXPECT_TRUE(causes.contains(cause)) << cause;
  }
}

TEST(Rebroker, DecidesAsRecordedByTheRecordedRules) {
  const CommsLog log = LogOf(Talk());
  EXPECT_EQ(log.time, LogTime::kMission);
  const RebrokerOutcome outcome = AsRecorded(log);
  EXPECT_GT(outcome.comparison.num_recorded(), 200);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
  EXPECT_EQ(outcome.num_too_early, 0);
  EXPECT_TRUE(outcome.absences.empty());
}

TEST(Rebroker, WritesTheBrokersPartOfTheLogByteForByte) {
  std::vector<TestEvent> recorded = Talk();
  std::vector<TestEvent> written;
  AsRecorded(LogOf(recorded), &written);
  std::erase_if(recorded, [](const TestEvent& event) { return !IsOfBroker(event.channel); });
  ASSERT_EQ(written.size(), recorded.size());
  for (size_t i = 0; i < written.size(); ++i) {
    ASSERT_EQ(written[i].utime, recorded[i].utime) << i;
    ASSERT_EQ(written[i].channel, recorded[i].channel) << i;
    ASSERT_EQ(written[i].data, recorded[i].data) << i << " " << written[i].channel;
  }
}

TEST(RebrokerTestMission, HasAllSortsOfFatesInTheWater) {
  const std::map<std::string, int64_t> causes = CausesOf(Talk(kWatery));
  for (const char* cause : {"report delivered", "report damaged", "report rejected",
                            "report half_duplex", "report packet_loss"}) {
    EXPECT_TRUE(causes.contains(cause)) << cause;
  }
}

TEST(Rebroker, DecidesAsRecordedWhatWentThroughTheWater) {
  std::vector<TestEvent> recorded = Talk(kWatery);
  std::vector<TestEvent> written;
  const RebrokerOutcome outcome = AsRecorded(LogOf(recorded), &written);
  EXPECT_GT(outcome.comparison.num_recorded(), 100);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
  std::erase_if(recorded, [](const TestEvent& event) { return !IsOfBroker(event.channel); });
  ASSERT_EQ(written.size(), recorded.size());
  for (size_t i = 0; i < written.size(); ++i) {
    ASSERT_EQ(written[i].channel, recorded[i].channel) << i;
    ASSERT_EQ(written[i].data, recorded[i].data) << i << " " << written[i].channel;
  }
  EXPECT_TRUE(AsRecorded(LogOf(Sealed(recorded))).comparison.IsEqual()) << "lcm-logger's, too";
}

TEST(Rebroker, HearsPacketsAndSaysTheSameOfThemAgain) {
  std::vector<TestEvent> recorded = Talk(kWatery);
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
  EXPECT_GE(num_packets, 4) << "the last may be in the water at the end";
  EXPECT_LE(num_packets, 6);
  EXPECT_TRUE(AsRecorded(LogOf(written)).comparison.IsEqual());
}

TEST(Rebroker, SendsThroughTheWaterWhatHadGoneWithoutIt) {
  const CommsLog log = LogOf(Talk());
  BrokerSetup setup = SetupFor(log);
  setup.rules.reports_over = Medium::kAcoustic;
  setup.rules.groups = false;
  setup.acoustics.is_used = true;
  const RebrokerOutcome outcome = Rebroker(log, {.setup = setup}, {});
  const LinkTable::Change lost = outcome.links.Of("report", "alpha", "bravo", "bit_errors");
  EXPECT_EQ(lost.recorded, 0);
  EXPECT_GT(lost.now, 0);
}

TEST(Rebroker, SaysTheSameOfTheLogThatItWroteByOtherRules) {
  const CommsLog log = LogOf(Talk());
  BrokerSetup setup = SetupFor(log);
  setup.rules.drop_percentage = 60;
  setup.rules.groups = false;
  std::vector<TestEvent> written;
  const RebrokerOutcome other =
      Rebroker(log, {.setup = setup},
               [&](int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
                 written.push_back({utime, std::string(channel), {data.begin(), data.end()}});
               });
  EXPECT_FALSE(other.comparison.IsEqual());
  const RebrokerOutcome again = AsRecorded(LogOf(written));
  EXPECT_EQ(again.comparison.num_recorded(), other.comparison.num_now());
  EXPECT_TRUE(again.comparison.IsEqual()) << again.comparison.first_difference();
}

/// Two vehicles 60 m apart that report twice a second for 20 s.
constexpr char kPair[] = R"(
[mission]
duration_s = 20
[comms]
comms_range = 80
[[vehicle]]
name = "alpha"
reporter = { rate_hz = 2 }
[[vehicle]]
name = "bravo"
start = { x_m = 60, y_m = 0, heading_deg = 0 }
reporter = { rate_hz = 2 }
[[event]]
at_s = 15
rule = "comms_range"
value = 70
)";

struct PairLog {
  CommsLog log;
  int64_t num_at_bravo = 0;  ///< Decisions about alpha's reports.
};

PairLog RecordPair() {
  const TestDirectory directory;
  Record(kPair, directory.File("m.lcm"));
  PairLog pair{.log = LogOf(EventsOf(directory.File("m.lcm")))};
  pair.num_at_bravo = AsRecorded(pair.log).links.Of("report", "alpha", "bravo", "delivered").now;
  EXPECT_GT(pair.num_at_bravo, 30);
  return pair;
}

TEST(Rebroker, TellsWhatIsLostWhereTheRangeIsShorter) {
  const PairLog pair = RecordPair();
  BrokerSetup setup = SetupFor(pair.log);
  setup.rules.comms_range_m = 50;
  setup.rules.critical_range_m = 0;
  const LinkTable links = Rebroker(pair.log, {.setup = setup, .with_controls = false}, {}).links;
  EXPECT_EQ(links.Of("report", "alpha", "bravo", "delivered"),
            (LinkTable::Change{.recorded = pair.num_at_bravo, .now = 0}));
  EXPECT_EQ(links.Of("report", "alpha", "bravo", "out_of_range"),
            (LinkTable::Change{.recorded = 0, .now = pair.num_at_bravo}));
}

TEST(Rebroker, LetsRecordedControlsChangeTheOtherRules) {
  const PairLog pair = RecordPair();
  BrokerSetup setup = SetupFor(pair.log);
  setup.rules.comms_range_m = 50;
  const LinkTable links = Rebroker(pair.log, {.setup = setup}, {}).links;
  const LinkTable::Change heard = links.Of("report", "alpha", "bravo", "delivered");
  // comms_range = 70 was said in the step of 15 s and holds from the next on; reports said in the
  // step of 15 s itself are decided then. At 2 Hz that leaves the last 5 s.
  EXPECT_NEAR(static_cast<double>(heard.now), 10, 1);
  EXPECT_EQ(heard.now + links.Of("report", "alpha", "bravo", "out_of_range").now,
            pair.num_at_bravo);
}

TEST(Rebroker, KeepsTheSeedSoThatLossesFallOnTheSameReports) {
  const CommsLog log = LogOf(Talk());
  BrokerSetup setup = SetupFor(log);
  setup.seed = 8;
  EXPECT_FALSE(Rebroker(log, {.setup = setup}, {}).comparison.IsEqual());
}

TEST(Rebroker, ShowsTheFirstDifference) {
  const PairLog pair = RecordPair();
  BrokerSetup setup = SetupFor(pair.log);
  setup.rules.comms_range_m = 75;
  const std::string difference =
      Rebroker(pair.log, {.setup = setup}, {}).comparison.first_difference();
  EXPECT_NE(difference.find("recorded: report "), std::string::npos) << difference;
  EXPECT_NE(difference.find("limit_m=80"), std::string::npos) << difference;
  EXPECT_NE(difference.find("limit_m=75"), std::string::npos) << difference;
}

/// Takes what the broker said out of [from_s, to_s), and has a new broker start at to_s, whom
/// nobody tells the controls.
std::vector<TestEvent> WithRestart(const std::vector<TestEvent>& events, double from_s,
                                   double to_s) {
  const CommsLog log = LogOf(events);
  const auto utime_of = [](double s) { return static_cast<int64_t>(s * 1e6); };
  // The new broker's part is what a broker says that is given the rest of the log.
  std::vector<TestEvent> early;
  std::vector<TestEvent> late;
  for (const TestEvent& event : events) {
    const bool is_input = LogOf({event}).inputs.size() == 1;
    if (event.utime < utime_of(from_s) || is_input) early.push_back(event);
    if (event.utime >= utime_of(to_s) - log.tick_us && is_input) late.push_back(event);
  }
  CommsLog rest = LogOf(late, log.tick_us);
  rest.starts = {
      {.utime = utime_of(to_s), .rules_utime = utime_of(to_s + 1), .in_the_midst = true}};
  std::vector<TestEvent> said;
  Rebroker(rest, {.setup = SetupFor(log)},
           [&](int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
             if (!LogOf({{utime, std::string(channel), {data.begin(), data.end()}}}).inputs.empty())
               return;
             said.push_back({utime, std::string(channel), {data.begin(), data.end()}});
           });
  early.insert(early.end(), said.begin(), said.end());
  std::stable_sort(early.begin(), early.end(), [](const TestEvent& a, const TestEvent& b) {
    return std::tie(a.utime, a.channel) < std::tie(b.utime, b.channel);
  });
  return early;
}

TEST(Rebroker, StartsANewBrokerWhereTheRecordedOneWasStartedAgain) {
  const TestDirectory directory;
  Record(kPair, directory.File("m.lcm"));
  const CommsLog log = LogOf(WithRestart(EventsOf(directory.File("m.lcm")), 8, 12));
  ASSERT_EQ(log.starts.size(), 2u);
  const RebrokerOutcome outcome = AsRecorded(log);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
  ASSERT_EQ(outcome.absences.size(), 1u);
  EXPECT_LT(outcome.absences[0].after_utime, 8'000'000);
  EXPECT_EQ(outcome.absences[0].before_utime, 12'000'000);
  // Two vehicles, twice a second, for 4 s.
  EXPECT_NEAR(static_cast<double>(outcome.absences[0].num_decisions), 16, 2);
}

/// What goes through the water counts its time from the mission's start, whoever brokers.
TEST(Rebroker, KnowsAfterARestartWhenTheMissionBegan) {
  std::vector<TestEvent> events = Talk(kWatery);
  const Mission mission = TestMission(kWatery);
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
  std::string slow = kWatery;
  slow.replace(slow.find("data_rate_bps = 3000"), 20, "data_rate_bps = 0.1\nsound_speed_mps = 1");
  slow.replace(slow.find("duration_s = 40"), 15, "duration_s = 20");
  std::vector<TestEvent> events = Talk(slow);
  comms_rules_t rules;
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

TEST(Rebroker, KnowsThatABrokerWaitedWhoseQuestionIsNotInTheLog) {
  const TestDirectory directory;
  Record(kPair, directory.File("m.lcm"));
  std::vector<TestEvent> events = WithRestart(EventsOf(directory.File("m.lcm")), 8, 12);
  std::erase_if(events, [](const TestEvent& event) { return event.channel == "UNC_CONTROLS_REQ"; });
  const CommsLog log = LogOf(events);
  ASSERT_EQ(log.starts.size(), 2u);
  EXPECT_EQ(log.starts[1].utime, 12'000'000);
  const RebrokerOutcome outcome = AsRecorded(log);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
}

TEST(Rebroker, CountsApartWhatWasSaidAfterTheLastBrokerDied) {
  const TestDirectory directory;
  Record(kPair, directory.File("m.lcm"));
  std::vector<TestEvent> events = EventsOf(directory.File("m.lcm"));
  std::erase_if(events, [](const TestEvent& event) {
    return event.channel == "COMMS_FATES" && event.utime > 10'000'000;
  });
  const RebrokerOutcome outcome = AsRecorded(LogOf(events));
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
  ASSERT_EQ(outcome.absences.size(), 1u);
  EXPECT_TRUE(outcome.absences[0].to_the_end);
  EXPECT_NEAR(static_cast<double>(outcome.absences[0].num_decisions), 40, 4);
}

TEST(Rebroker, DecidesALiveBrokersLogAtTheTimesOfItsEvents) {
  // What a logger sees of a live broker: no seals, each decision a little later than its report.
  std::vector<TestEvent> events = Talk();
  constexpr int64_t kBegin = 1'700'000'000'000'000;
  int64_t count = 0;
  for (TestEvent& event : events) {
    if (comms_fates_t fates; event.channel == "COMMS_FATES" && Decode(event.data, &fates)) {
      fates.utime += kBegin;
      event.data = Encoded(fates);
    }
    if (comms_rules_t rules; event.channel == "COMMS_RULES" && Decode(event.data, &rules)) {
      rules.utime += kBegin;
      event.data = Encoded(rules);
    }
    const bool is_input = LogOf({event}).inputs.size() == 1;
    event.utime += kBegin + (is_input ? 100'000 : 700) + ++count % 5;
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const TestEvent& a, const TestEvent& b) { return a.utime < b.utime; });
  const CommsLog log = LogOf(events);
  EXPECT_EQ(log.time, LogTime::kWall);
  std::vector<TestEvent> written;
  const RebrokerOutcome outcome = AsRecorded(log, &written);
  EXPECT_GT(outcome.comparison.num_recorded(), 200);
  EXPECT_GT(10 * outcome.comparison.num_reproduced(), 9 * outcome.comparison.num_recorded())
      << outcome.comparison.first_difference();

  const CommsLog again = LogOf(written);
  EXPECT_EQ(again.time, LogTime::kMission);
  const RebrokerOutcome second = AsRecorded(again);
  EXPECT_EQ(second.comparison.num_recorded(), outcome.comparison.num_now());
  EXPECT_TRUE(second.comparison.IsEqual()) << second.comparison.first_difference();
}

RC_GTEST_PROP(Rebroker, SurvivesAnyLog, ()) {
  const auto channel =
      rc::gen::oneOf(rc::gen::elementOf(BrokerChannels()), rc::gen::just(std::string("NAV_ALPHA")));
  static const std::vector<TestEvent> sound = Talk();
  std::vector<TestEvent> events;
  const int count = *rc::gen::inRange(0, 40);
  for (int i = 0; i < count; ++i) {
    TestEvent event = *rc::gen::elementOf(sound);
    switch (*rc::gen::inRange(0, 5)) {
      case 0:
        event.data = *rc::gen::arbitrary<Bytes>();
        break;
      case 1:
        event.channel = *channel;
        break;
      case 2:
        event.utime = *rc::gen::arbitrary<int64_t>();
        break;
      case 3:
        AppendSeal({.publisher = "p",
                    .mission_id = *rc::gen::inRange<int64_t>(0, 2),
                    .step = *rc::gen::arbitrary<int64_t>(),
                    .sequence = *rc::gen::arbitrary<uint32_t>()},
                   &event.data);
        break;
      default:
        if (!event.data.empty()) {
          event.data[*rc::gen::inRange<size_t>(0, event.data.size())] =
              *rc::gen::arbitrary<uint8_t>();
        }
    }
    events.push_back(std::move(event));
  }
  const CommsLog log = LogOf(events);
  BrokerSetup setup;
  if (log.rules) {
    if (const Result<BrokerSetup> recorded = SetupOf(*log.rules); recorded.ok()) setup = *recorded;
  }
  std::vector<TestEvent> written;
  const RebrokerOutcome outcome =
      Rebroker(log, {.setup = setup, .absences = AbsencesIn(log)},
               [&](int64_t utime, std::string_view name, std::span<const uint8_t> data) {
                 written.push_back({utime, std::string(name), {data.begin(), data.end()}});
               });
  RC_ASSERT(outcome.comparison.num_reproduced() <= outcome.comparison.num_recorded());
  for (size_t i = 1; i < written.size(); ++i) {
    RC_ASSERT(std::tie(written[i - 1].utime, written[i - 1].channel) <=
              std::tie(written[i].utime, written[i].channel));
  }
}

}  // namespace
}  // namespace shoal
