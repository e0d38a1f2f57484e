#include "lib/helm/behaviors/timer.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::timer_test {

TEST(Timer, HasNoPreferenceAndNeverEndsByItself) {
  TestVessel vessel;
  TimerBehavior timer{TimerOptions()};
  for (const double time_s : {0.0, 10.0, 1e6}) {
    const BehaviorAnswer answer = vessel.RunAt(timer, time_s);
    EXPECT_FALSE(answer.objective.has_value());
    EXPECT_FALSE(answer.completes);
  }
}

}  // namespace shoal::timer_test
