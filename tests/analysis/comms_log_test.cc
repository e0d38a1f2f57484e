#include "lib/tools/rebroker/comms_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "lib/tools/rebroker/rebroker.h"
#include "sim/app_factory.h"
#include "tests/analysis/rebroker_testing.h"

namespace shoal::comms_log_test {

std::vector<TestEvent> RecordedEvents() {
  const TestDirectory directory;
  Record(kMixedTraffic, directory.File("m.lcm"));
  return EventsOf(directory.File("m.lcm"));
}

RebrokerOutcome AsRecorded(const CommsLog& log) {
  const Result<BrokerSetup> setup = SetupOf(*log.rules);
  EXPECT_TRUE(setup.ok());
  return Rebroker(log, {.setup = *setup}, MakeShoreBroker, {});
}

TEST(CommsLog, TakesTheTimesOfARecordingAsTheyAre) {
  const CommsLog log = LogOf(RecordedEvents());
  EXPECT_EQ(log.time, LogTime::kMission);
  EXPECT_EQ(log.tick_us, 100'000);
  EXPECT_FALSE(log.tick_is_guessed);
  EXPECT_EQ(log.first_utime, 0);
  EXPECT_EQ(log.last_utime, 20'000'000);
  ASSERT_EQ(log.starts.size(), 1u);
  EXPECT_EQ(log.starts[0].utime, 0);
  EXPECT_FALSE(log.starts[0].in_the_midst);
  EXPECT_TRUE(log.gaps.empty());
}

TEST(CommsLog, RestoresStepsAndOrderFromSeals) {
  std::vector<TestEvent> events = Sealed(RecordedEvents());
  std::shuffle(events.begin(), events.end(), std::mt19937(1));
  const CommsLog log = LogOf(events);
  EXPECT_EQ(log.time, LogTime::kSeals);
  EXPECT_EQ(log.first_utime, 0);
  EXPECT_EQ(log.last_utime, 20'000'000);
  const RebrokerOutcome outcome = AsRecorded(log);
  EXPECT_GT(outcome.comparison.num_recorded(), 200);
  EXPECT_TRUE(outcome.comparison.IsEqual()) << outcome.comparison.first_difference();
}

TEST(CommsLog, TakesWhatIsInTwoLogsOnce) {
  const std::vector<TestEvent> events = Sealed(RecordedEvents());
  CommsLogBuilder builder;
  int64_t count = 0;
  for (int round = 0; round < 2; ++round) {
    builder.BeginLog();
    for (const TestEvent& event : events) {
      // Each log lost something else.
      if (++count % 7 == round) continue;
      builder.Add({.utime = event.utime, .channel = event.channel, .data = event.data});
    }
  }
  const CommsLog log = builder.Build();
  EXPECT_GT(log.num_repeated, 100);
  EXPECT_TRUE(AsRecorded(log).comparison.IsEqual());
}

TEST(CommsLog, LeavesOtherMissionsOut) {
  std::vector<TestEvent> events = Sealed(RecordedEvents());
  const std::vector<TestEvent> others = Sealed(RecordedEvents(), 100'000, 43);
  events.insert(events.end(), others.begin(), others.end());
  const CommsLog log = LogOf(events);
  EXPECT_GT(log.num_foreign, 100);
  EXPECT_TRUE(AsRecorded(log).comparison.IsEqual());
}

TEST(CommsLog, CountsTheReportsThatAreMissing) {
  std::vector<TestEvent> events = Sealed(RecordedEvents());
  int64_t num_taken = 0;
  int64_t num_reports = 0;
  std::erase_if(events, [&](const TestEvent& event) {
    node_report_t report;
    const auto bytes = Unseal(event.data).message;
    if (event.channel != "NODE_REPORT_LOCAL" || !Decode(bytes, &report)) return false;
    if (report.name != "bravo") return false;
    ++num_reports;
    const bool is_taken = report.index == 0 || report.index == 4 || report.index == 5;
    if (is_taken) ++num_taken;
    return is_taken;
  });
  ASSERT_EQ(num_taken, 3);
  const CommsLog log = LogOf(events);
  ASSERT_EQ(log.gaps.size(), 1u);
  EXPECT_EQ(log.gaps[0].vehicle, "bravo");
  EXPECT_EQ(log.gaps[0].num_missing, 3);
  EXPECT_EQ(log.gaps[0].num_found, num_reports - 3);
}

TEST(CommsLog, TakesAReporterThatCountsAnewForOneThatWasStartedAgain) {
  std::vector<TestEvent> events;
  for (const int64_t index : {0, 1, 2, 0, 1, 4}) {
    node_report_t report{};
    report.name = "alpha";
    report.index = index;
    report.utime = static_cast<int64_t>(events.size()) * 100'000;
    events.push_back({report.utime, "NODE_REPORT_LOCAL", Encoded(report)});
  }
  const CommsLog log = LogOf(events);
  ASSERT_EQ(log.gaps.size(), 1u);
  EXPECT_EQ(log.gaps[0].num_missing, 2) << "numbers 2 and 3 of the second count";
}

TEST(CommsLog, GuessesTheTickWhereNoRulesStateIt) {
  std::vector<TestEvent> events = RecordedEvents();
  std::erase_if(events, [](const TestEvent& event) { return event.channel == "COMMS_RULES"; });
  const CommsLog recording = LogOf(events);
  EXPECT_TRUE(recording.tick_is_guessed);
  EXPECT_EQ(recording.tick_us, 100'000);
  EXPECT_FALSE(recording.rules);
  for (TestEvent& event : events) event.utime *= 2;
  EXPECT_EQ(LogOf(Sealed(events, 200'000)).tick_us, 100'000) << "by the reports' own times";
}

TEST(CommsLog, GivesAnUnsealedMessageTheStepOfTheMessageBefore) {
  std::vector<TestEvent> events = Sealed(RecordedEvents());
  size_t num_controls = 0;
  for (TestEvent& event : events) {
    if (event.channel != "UNC_COMMS_RANGE") continue;
    const auto bytes = Unseal(event.data).message;
    event.data = Bytes(bytes.begin(), bytes.end());
    ++num_controls;
  }
  ASSERT_EQ(num_controls, 1u);
  const CommsLog log = LogOf(events);
  EXPECT_EQ(log.num_unsealed, 1);
  EXPECT_TRUE(AsRecorded(log).comparison.IsEqual());
}

TEST(CommsLog, SortsEventsThatGoBackward) {
  std::vector<TestEvent> events = RecordedEvents();
  std::rotate(events.begin(), events.begin() + static_cast<int64_t>(events.size() / 2),
              events.end());
  while (events.back().utime == events.front().utime) events.pop_back();
  const CommsLog log = LogOf(events);
  EXPECT_EQ(log.num_backward, 1);
  EXPECT_TRUE(std::is_sorted(
      log.inputs.begin(), log.inputs.end(),
      [](const LoggedMessage& a, const LoggedMessage& b) { return a.utime < b.utime; }));
}

TEST(CommsLog, LeavesOutTimesThatNoMissionHas) {
  std::vector<TestEvent> events = RecordedEvents();
  events.front().utime = INT64_MIN;
  events.back().utime = INT64_MAX;
  const CommsLog log = LogOf(events);
  EXPECT_EQ(log.num_impossible, 2);
  EXPECT_EQ(log.last_utime, 20'000'000);
}

TEST(CommsLog, HandlesTogetherWhatALiveBrokerDecidedTogether) {
  std::vector<TestEvent> events;
  const auto report = [&](int64_t utime) {
    node_report_t message{};
    message.name = "alpha";
    message.utime = 5;
    events.push_back({utime, "NODE_REPORT", Encoded(message)});
  };
  report(1'000'000);
  report(2'000'000);
  report(2'000'900);
  comms_fates_t fates{};
  fates.utime = 7;
  events.push_back({2'001'000, "COMMS_FATES", Encoded(fates)});
  const CommsLog log = LogOf(events);
  EXPECT_EQ(log.time, LogTime::kWall);
  ASSERT_EQ(log.inputs.size(), 3u);
  EXPECT_EQ(log.inputs[0].utime, 1'000'000) << "too long before any decision";
  EXPECT_EQ(log.inputs[1].utime, 2'001'000);
  EXPECT_EQ(log.inputs[2].utime, 2'001'000);
}

TEST(StepsLater, ReturnsNothingWhereTheTimeCannotBe) {
  EXPECT_EQ(StepsLater(5, 3, 10), 35);
  EXPECT_EQ(StepsLater(0, INT64_MAX, 2), std::nullopt);
  EXPECT_EQ(StepsLater(INT64_MAX, 1, 1), std::nullopt);
  EXPECT_EQ(StepsLater(0, -1, INT64_MAX), std::nullopt);
}

}  // namespace shoal::comms_log_test
