#include "lib/behaviors/test_failure.h"

#include <gtest/gtest.h>

#include "lib/behaviors/test_vessel.h"

namespace shoal::test_failure_test {

TEST(TestFailure, KeepsTheHelmBusyOnceItCompletes) {
  TestVessel vessel;
  TestFailureBehavior behavior({.failure_type = "burn", .burn_time = 2});
  EXPECT_EQ(vessel.Run(behavior).busy_s, 0);
  EXPECT_EQ(behavior.Complete(vessel.Inputs()).busy_s, 2);
}

TEST(TestFailureDeathTest, AbortsTheHelmOnceItCompletes) {
  TestVessel vessel;
  TestFailureBehavior behavior({.failure_type = "crash"});
  (void)vessel.Run(behavior);
  EXPECT_DEATH((void)behavior.Complete(vessel.Inputs()), "");
}

}  // namespace shoal::test_failure_test
