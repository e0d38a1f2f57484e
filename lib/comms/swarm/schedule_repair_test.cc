#include "lib/comms/swarm/schedule_repair.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace shoal::schedule_repair_test {

using Ids = std::vector<int64_t>;

TEST(ScheduleRepair, PutsTheMissingIdBack) {
  EXPECT_EQ(RepairSchedule({2, 3, 40'000, 5}, {2, 3, 4, 5}), (Ids{2, 3, 4, 5}));
}

TEST(ScheduleRepair, KeepsAnOtherOrder) {
  EXPECT_EQ(RepairSchedule({3, 2, 4, 5}, {2, 3, 4, 5}), (Ids{3, 2, 4, 5}));
}

TEST(ScheduleRepair, ReplacesTheCopyThatIsNotInItsPlace) {
  EXPECT_EQ(RepairSchedule({2, 2, 4, 5}, {2, 3, 4, 5}), (Ids{2, 3, 4, 5}));
  EXPECT_EQ(RepairSchedule({3, 3, 4, 5}, {2, 3, 4, 5}), (Ids{2, 3, 4, 5}));
}

TEST(ScheduleRepair, TakesTheIdWithTheFewestDifferingBits) {
  // 0x14 differs from 4 by one bit and from 3 by four.
  EXPECT_EQ(RepairSchedule({0x14, 2, 9, 5}, {2, 3, 4, 5}), (Ids{4, 2, 3, 5}));
}

TEST(ScheduleRepair, TakesTheNearerPlaceAmongEquals) {
  // 12 differs by one bit from 4 and from 8, whose places are 0 and 3. It is in place 2.
  EXPECT_EQ(RepairSchedule({5, 6, 12, 40}, {4, 5, 6, 8}), (Ids{5, 6, 8, 4}));
}

TEST(ScheduleRepair, GivesUpWhenMoreThanHalfIsLost) {
  EXPECT_TRUE(RepairSchedule({2, 3, 100'000, 200'000}, {2, 3, 4, 5}));
  EXPECT_FALSE(RepairSchedule({2, 300'000, 100'000, 200'000}, {2, 3, 4, 5}));
}

TEST(ScheduleRepair, CannotCompareDifferentLengths) {
  EXPECT_FALSE(RepairSchedule({2, 3, 4, 5, 6}, {2, 3, 4, 5}));
  EXPECT_FALSE(RepairSchedule({}, {}));
}

RC_GTEST_PROP(ScheduleRepair, GivesEachIdOfTheReferenceOnce, ()) {
  const auto reference = *rc::gen::unique<Ids>(rc::gen::inRange<int64_t>(1, 1000));
  auto damaged = reference;
  for (int64_t& id : damaged) {
    if (*rc::gen::inRange(0, 4) == 0) id ^= int64_t{1} << *rc::gen::inRange(0, 32);
  }
  auto repaired = RepairSchedule(damaged, reference);
  if (!repaired) return;
  auto expected = reference;
  std::sort(expected.begin(), expected.end());
  std::sort(repaired->begin(), repaired->end());
  RC_ASSERT(*repaired == expected);
}

}  // namespace shoal::schedule_repair_test
