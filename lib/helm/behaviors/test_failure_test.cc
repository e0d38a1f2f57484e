#include "lib/helm/behaviors/test_failure.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::test_failure_test {

TEST(TestFailure, KeepsTheHelmBusyOnceItCompletes) {
  TestVessel vessel;
  TestFailureBehavior behavior({.failure_type = "burn", .burn_time = 2});
  EXPECT_EQ(vessel.Run(behavior).busy_s, 0);
  EXPECT_EQ(behavior.Complete(vessel.Inputs()).busy_s, 2);
}

TEST(TestFailure, CrashesTheHelmOnceItCompletes) {
  TestVessel vessel;
  TestFailureBehavior behavior({.failure_type = "crash"});
  EXPECT_FALSE(vessel.Run(behavior).crashes);
  const BehaviorAnswer answer = behavior.Complete(vessel.Inputs());
  EXPECT_TRUE(answer.crashes);
  EXPECT_EQ(answer.busy_s, 0);
}

}  // namespace shoal::test_failure_test
