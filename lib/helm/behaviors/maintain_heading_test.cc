#include "lib/helm/behaviors/maintain_heading.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::maintain_heading_test {

TEST(MaintainHeading, KeepsTheHeadingOfItsBeginAndTakesAnotherAfterAPause) {
  TestVessel vessel;
  MaintainHeadingBehavior behavior(MaintainHeadingOptions{});
  vessel.own.motion.heading_deg = 123;
  EXPECT_EQ(vessel.Best(vessel.Run(behavior)).course_deg, 123);
  vessel.own.motion.heading_deg = 200;
  EXPECT_EQ(vessel.Best(vessel.Run(behavior)).course_deg, 123);
  (void)behavior.Idle(vessel.Inputs());
  EXPECT_EQ(vessel.Best(vessel.Run(behavior)).course_deg, 200);
}

}  // namespace shoal::maintain_heading_test
