#include "lib/helm/behaviors/full_stop.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::full_stop_test {

TEST(FullStop, PrefersLessSpeedToMore) {
  TestVessel vessel;
  FullStopBehavior behavior{FullStopOptions()};
  const BehaviorAnswer answer = vessel.Run(behavior);
  ASSERT_TRUE(answer.objective.has_value());
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 0), 100);
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 20), 50);
  EXPECT_DOUBLE_EQ(ValueAt(*answer.objective, 0, 40), 0);
}

}  // namespace shoal::full_stop_test
