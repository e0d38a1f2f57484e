#include "lib/helm/behaviors/hysteresis.h"

#include <gtest/gtest.h>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::hysteresis_test {

const HysteresisOptions kOptions = {.memory_time = 10,
                                    .min_heading_window = 10,
                                    .max_heading_window = 60,
                                    .max_window_utility = 40};

/// Degrees to either side at which the value is 100, after `swing_deg` to and fro about North.
int WindowAfter(double swing_deg) {
  TestVessel vessel;
  HysteresisBehavior behavior(kOptions);
  BehaviorAnswer answer;
  for (int i = 0; i <= 20; ++i) {
    vessel.own.motion.heading_deg = Wrap360(i % 2 == 0 ? swing_deg : -swing_deg);
    vessel.time_s += 1;
    (void)behavior.Idle(vessel.Inputs());
  }
  vessel.own.motion.heading_deg = 0;
  answer = vessel.Run(behavior);
  EXPECT_NEAR(answer.relevance, 0.4, 1e-12);
  int window = 0;
  while (ValueAt(*answer.objective, window + 1, 0) > 50) ++window;
  return window;
}

TEST(Hysteresis, HasAWindowThatIsWiderTheSteadierTheVesselWas) {
  EXPECT_EQ(WindowAfter(0), 30);
  EXPECT_NEAR(WindowAfter(15), 18, 1);
  EXPECT_EQ(WindowAfter(60), 5);
}

TEST(Hysteresis, ForgetsHeadingsThatAreOlderThanItsMemory) {
  TestVessel vessel;
  HysteresisBehavior behavior(kOptions);
  vessel.own.motion.heading_deg = 180;
  (void)vessel.RunAt(behavior, 0.0);
  vessel.own.motion.heading_deg = 0;
  EXPECT_EQ(vessel.RunAt(behavior, 10.5).state, "window 60 deg");
}

}  // namespace shoal::hysteresis_test
