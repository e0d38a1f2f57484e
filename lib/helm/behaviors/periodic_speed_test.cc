#include "lib/helm/behaviors/periodic_speed.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::periodic_speed_test {

const PeriodicSpeedOptions kOptions = {.period_lazy = 10, .period_busy = 5, .period_speed = 1.5};

TEST(PeriodicSpeed, AlternatesBetweenLazyAndBusy) {
  TestVessel vessel;
  PeriodicSpeedBehavior behavior(kOptions);
  EXPECT_FALSE(vessel.RunAt(behavior, 100.0).objective.has_value());
  EXPECT_FALSE(vessel.RunAt(behavior, 109.0).objective.has_value());
  const BehaviorAnswer busy = vessel.RunAt(behavior, 110.0);
  EXPECT_DOUBLE_EQ(vessel.Best(busy).speed_mps, 1.5);
  EXPECT_EQ(PostOf(busy, "PERIODIC_SPEED_COUNT"), VariableValue(1.0));
  EXPECT_EQ(PostOf(busy, "PERIODIC_SPEED_PENDING_LAZY"), VariableValue(5.0));
  const BehaviorAnswer lazy = vessel.RunAt(behavior, 115.0);
  EXPECT_FALSE(lazy.objective.has_value());
  EXPECT_EQ(PostOf(lazy, "PERIODIC_SPEED_PENDING_BUSY"), VariableValue(10.0));
}

TEST(PeriodicSpeed, BeginsAnewAfterAPauseUnlessItsClockRunsOn) {
  for (const bool resets : {true, false}) {
    TestVessel vessel;
    PeriodicSpeedOptions options = kOptions;
    options.reset_upon_running = resets;
    PeriodicSpeedBehavior behavior(options);
    (void)vessel.RunAt(behavior, 0.0);
    (void)behavior.Idle(vessel.Inputs());
    EXPECT_EQ(vessel.RunAt(behavior, 12.0).objective.has_value(), !resets);
  }
}

TEST(PeriodicSpeed, BeginsBusyWhereThatIsAskedFor) {
  TestVessel vessel;
  PeriodicSpeedOptions options = kOptions;
  options.initially_busy = true;
  PeriodicSpeedBehavior behavior(options);
  EXPECT_TRUE(vessel.RunAt(behavior, 0.0).objective.has_value());
}

}  // namespace shoal::periodic_speed_test
