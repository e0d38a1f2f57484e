#include "lib/helm/behaviors/memory_turn_limit.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::memory_turn_limit_test {

const MemoryTurnLimitOptions kOptions = {.memory_time = 10, .turn_range = 40};

/// The course that is liked most, and the value of another one.
double ValueOf(const BehaviorAnswer& answer, int course) {
  return answer.objective ? ValueAt(*answer.objective, course, 0) : -1;
}

TEST(MemoryTurnLimit, RefusesCoursesFarFromTheMeanOfItsHeadings) {
  TestVessel vessel;
  vessel.own.motion.speed_mps = 2;
  MemoryTurnLimitBehavior behavior(kOptions);
  vessel.own.motion.heading_deg = 350;
  (void)vessel.RunAt(behavior, 0.0);
  vessel.own.motion.heading_deg = 30;
  const BehaviorAnswer answer = vessel.RunAt(behavior, 5.0);
  EXPECT_EQ(vessel.Best(answer).course_deg, 10);
  EXPECT_GT(ValueOf(answer, 49), 99);
  EXPECT_EQ(ValueOf(answer, 51), 0);
  EXPECT_GT(ValueOf(answer, 331), 99);
  EXPECT_EQ(ValueOf(answer, 329), 0);
  EXPECT_TRUE(behavior.is_constraint());
}

TEST(MemoryTurnLimit, ForgetsHeadingsThatAreOlderThanItsMemory) {
  TestVessel vessel;
  MemoryTurnLimitBehavior behavior(kOptions);
  vessel.own.motion.heading_deg = 350;
  (void)vessel.RunAt(behavior, 0.0);
  vessel.own.motion.heading_deg = 30;
  EXPECT_EQ(vessel.Best(vessel.RunAt(behavior, 10.5)).course_deg, 30);
}

TEST(MemoryTurnLimit, RemembersHeadingsWhileItIsIdle) {
  TestVessel vessel;
  MemoryTurnLimitBehavior behavior(kOptions);
  vessel.own.motion.heading_deg = 350;
  (void)behavior.Idle(vessel.Inputs());
  vessel.own.motion.heading_deg = 30;
  EXPECT_EQ(vessel.Best(vessel.RunAt(behavior, 1.0)).course_deg, 10);
}

TEST(MemoryTurnLimit, NarrowsItsRangeForSlowVessels) {
  TestVessel vessel;
  vessel.own.motion.speed_mps = 0.75;
  MemoryTurnLimitBehavior behavior(kOptions);
  const BehaviorAnswer answer = vessel.Run(behavior);
  EXPECT_GT(ValueOf(answer, 20), 99);
  EXPECT_EQ(ValueOf(answer, 21), 0);
}

}  // namespace shoal::memory_turn_limit_test
