#include "lib/tools/rebroker/rebroker.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "tests/analysis/rebroker_runs.h"

namespace shoal::rebroker_test {

TEST(RebrokerTestMission, HasAllSortsOfFates) {
  const std::map<std::string, int64_t> causes = CausesOf(RecordedEvents());
  for (const char* cause :
       {"report delivered", "report out_of_range", "report dropped", "report other_group",
        "message delivered", "message too_soon", "ack delivered"}) {
    EXPECT_TRUE(causes.contains(cause)) << cause;
  }
}

TEST(Rebroker, DecidesAsRecordedByTheRecordedRules) {
  const CommsLog log = LogOf(RecordedEvents());
  EXPECT_EQ(log.time, LogTime::kMission);
  const RebrokerOutcome outcome = AsRecorded(log);
  EXPECT_GT(outcome.comparison.num_recorded(), 200);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
  EXPECT_EQ(outcome.num_too_early, 0);
  EXPECT_TRUE(outcome.absences.empty());
}

TEST(Rebroker, WritesTheBrokersPartOfTheLogByteForByte) {
  std::vector<TestEvent> recorded = RecordedEvents();
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

TEST(Rebroker, DecidesTheSameFromTheLogThatItWroteByOtherRules) {
  const CommsLog log = LogOf(RecordedEvents());
  BrokerSetup setup = SetupFor(log);
  setup.rules.drop_percentage = 60;
  setup.rules.groups = false;
  std::vector<TestEvent> written;
  const RebrokerOutcome other =
      Rebroker(log, {.setup = setup}, MakeShoreBroker,
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

TEST(Rebroker, ReportsWhatIsLostWhereTheRangeIsShorter) {
  const PairLog pair = RecordPair();
  BrokerSetup setup = SetupFor(pair.log);
  setup.rules.comms_range_m = 50;
  setup.rules.critical_range_m = 0;
  const LinkTable links =
      Rebroker(pair.log, {.setup = setup, .with_controls = false}, MakeShoreBroker, {}).links;
  EXPECT_EQ(links.Of("report", "alpha", "bravo", "delivered"),
            (LinkTable::Change{.recorded = pair.num_at_bravo, .now = 0}));
  EXPECT_EQ(links.Of("report", "alpha", "bravo", "out_of_range"),
            (LinkTable::Change{.recorded = 0, .now = pair.num_at_bravo}));
}

TEST(Rebroker, LetsRecordedControlsChangeTheOtherRules) {
  const PairLog pair = RecordPair();
  BrokerSetup setup = SetupFor(pair.log);
  setup.rules.comms_range_m = 50;
  const LinkTable links = Rebroker(pair.log, {.setup = setup}, MakeShoreBroker, {}).links;
  const LinkTable::Change delivered = links.Of("report", "alpha", "bravo", "delivered");
  // comms_range = 70 was published in the step of 15 s and holds from the next on; reports
  // published in the step of 15 s itself are decided then. At 2 Hz that leaves the last 5 s.
  EXPECT_NEAR(static_cast<double>(delivered.now), 10, 1);
  EXPECT_EQ(delivered.now + links.Of("report", "alpha", "bravo", "out_of_range").now,
            pair.num_at_bravo);
}

TEST(Rebroker, KeepsTheSeedSoThatLossesFallOnTheSameReports) {
  const CommsLog log = LogOf(RecordedEvents());
  BrokerSetup setup = SetupFor(log);
  setup.seed = 8;
  EXPECT_FALSE(Rebroker(log, {.setup = setup}, MakeShoreBroker, {}).comparison.IsEqual());
}

TEST(Rebroker, ShowsTheFirstDifference) {
  const PairLog pair = RecordPair();
  BrokerSetup setup = SetupFor(pair.log);
  setup.rules.comms_range_m = 75;
  const std::string difference =
      Rebroker(pair.log, {.setup = setup}, MakeShoreBroker, {}).comparison.first_difference();
  EXPECT_NE(difference.find("recorded: report "), std::string::npos) << difference;
  EXPECT_NE(difference.find("limit_m=80"), std::string::npos) << difference;
  EXPECT_NE(difference.find("limit_m=75"), std::string::npos) << difference;
}

/// Removes what the broker published in [from_s, to_s), and starts a new broker at to_s, which gets
/// no answer to its request for the controls.
std::vector<TestEvent> WithRestart(const std::vector<TestEvent>& events, double from_s,
                                   double to_s) {
  const CommsLog log = LogOf(events);
  const auto utime_of = [](double s) { return static_cast<int64_t>(s * 1e6); };
  // The new broker's part is what a broker publishes that is given the rest of the log.
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
  std::vector<TestEvent> published;
  Rebroker(rest, {.setup = SetupFor(log)}, MakeShoreBroker,
           [&](int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
             if (!LogOf({{utime, std::string(channel), {data.begin(), data.end()}}}).inputs.empty())
               return;
             published.push_back({utime, std::string(channel), {data.begin(), data.end()}});
           });
  early.insert(early.end(), published.begin(), published.end());
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

TEST(Rebroker, CountsSeparatelyWhatWasPublishedAfterTheLastBrokerDied) {
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
  std::vector<TestEvent> events = RecordedEvents();
  constexpr int64_t kBegin = 1'700'000'000'000'000;
  int64_t count = 0;
  for (TestEvent& event : events) {
    if (comms_fates_t fates; event.channel == "COMMS_FATES" && Decode(event.data, &fates)) {
      fates.utime += kBegin;
      event.data = Encoded(fates);
    }
    if (broker_rules_t rules; event.channel == "COMMS_RULES" && Decode(event.data, &rules)) {
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
  static const std::vector<TestEvent> sound = RecordedEvents();
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
                   MissionSecret{}, event.channel, &event.data);
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
      Rebroker(log, {.setup = setup, .absences = AbsencesIn(log)}, MakeShoreBroker,
               [&](int64_t utime, std::string_view name, std::span<const uint8_t> data) {
                 written.push_back({utime, std::string(name), {data.begin(), data.end()}});
               });
  RC_ASSERT(outcome.comparison.num_reproduced() <= outcome.comparison.num_recorded());
  for (size_t i = 1; i < written.size(); ++i) {
    RC_ASSERT(std::tie(written[i - 1].utime, written[i - 1].channel) <=
              std::tie(written[i].utime, written[i].channel));
  }
}

}  // namespace shoal::rebroker_test
