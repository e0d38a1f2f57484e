#include "lib/tools/rebroker/outside_inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "lib/tools/rebroker/rebroker.h"
#include "sim/app_factory.h"
#include "tests/analysis/rebroker_testing.h"

namespace shoal::outside_inputs_test {

DecisionComparison Compared(const CommsLog& log) {
  const Result<BrokerSetup> setup = SetupOf(*log.rules);
  EXPECT_TRUE(setup.ok());
  return Rebroker(log, {.setup = *setup}, MakeShoreBroker, {}).comparison;
}

std::vector<TestEvent> RecordedEvents() {
  const TestDirectory directory;
  Record(kMixedTraffic, directory.File("m.lcm"));
  return EventsOf(directory.File("m.lcm"));
}

/// Puts the first message on `channel` into the log `steps` later, as a recorder that got it later
/// would have.
CommsLog Displaced(const std::string& channel, int64_t steps) {
  CommsLog log = LogOf(RecordedEvents());
  for (LoggedMessage& input : log.inputs) {
    if (BrokerChannels()[input.channel] != channel) continue;
    input.utime += steps * log.tick_us;
    break;
  }
  std::stable_sort(
      log.inputs.begin(), log.inputs.end(),
      [](const LoggedMessage& a, const LoggedMessage& b) { return a.utime < b.utime; });
  return log;
}

TEST(OutsideInputs, GoBackToTheStepInWhichTheBrokerHandledThem) {
  for (const char* channel : {"NODE_MESSAGE_LOCAL", "UNC_COMMS_RANGE", "UNC_STEALTH"}) {
    for (const int64_t steps : {-1, 1}) {
      CommsLog log = Displaced(channel, steps);
      if (steps == 1) {
        ASSERT_FALSE(Compared(log).IsEqual()) << channel;
      }
      EXPECT_EQ(MoveToTheStepsOfTheBroker(&log), 1) << channel;
      EXPECT_TRUE(Compared(log).IsEqual()) << channel << "\n" << Compared(log).first_difference();
    }
  }
}

TEST(OutsideInputs, StayWhereTheyAreRight) {
  CommsLog log = LogOf(RecordedEvents());
  EXPECT_EQ(MoveToTheStepsOfTheBroker(&log), 0);
  EXPECT_TRUE(Compared(log).IsEqual());
}

TEST(OutsideInputs, AreNotMovedByMoreThanAStep) {
  CommsLog log = Displaced("UNC_COMMS_RANGE", 3);
  EXPECT_EQ(MoveToTheStepsOfTheBroker(&log), 0);
}

TEST(OutsideInputs, StayWhereAFateNamesAnImpossibleTime) {
  comms_fates_t fates = {};
  fates.utime = 5'000'000;
  for (const int64_t utime :
       {std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()}) {
    fate_t fate = {};
    fate.kind = "packet";
    fate.source = "alpha";
    fate.num_paths = 1;
    fate.path = {acoustic_path_t{}};
    fate.path.front().sent_utime = utime;
    fate.number = fates.num_fates++;
    fates.fates.push_back(fate);
  }
  Bytes bytes;
  EncodeInto(fates, &bytes);
  std::vector<TestEvent> events = RecordedEvents();
  events.push_back({events.back().utime, "COMMS_FATES", bytes});
  CommsLog log = LogOf(events);
  EXPECT_EQ(MoveToTheStepsOfTheBroker(&log), 0);
}

TEST(OutsideInputs, StayInALogWhoseReportsAreIncomplete) {
  CommsLog log = Displaced("UNC_COMMS_RANGE", 1);
  log.gaps.push_back({.vehicle = "alpha", .num_found = 1, .num_missing = 1});
  EXPECT_EQ(MoveToTheStepsOfTheBroker(&log), 0);
}

}  // namespace shoal::outside_inputs_test
