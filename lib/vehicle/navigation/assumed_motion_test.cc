#include "lib/vehicle/navigation/assumed_motion.h"

#include <gtest/gtest.h>

#include "lib/vehicle/navigation/navigation_filter.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "lib/vehicle/vehicle/sway_in_turns.h"

namespace shoal::assumed_motion_test {

TEST(AssumeMotionOf, TakesTheSwayInTurnsFromTheModel) {
  const Remus100 auv = BuildRemus100({});
  FilterOptions options;
  AssumeMotionOf(auv, &options);
  EXPECT_GT(options.sway_in_turns.lever_m, 0);
  EXPECT_EQ(options.sway_in_turns.lever_m, SwayInTurnsOf(auv).lever_m);
  EXPECT_LT(options.sway_mps, FilterOptions().sway_mps) << "it leaves less to chance";
}

}  // namespace shoal::assumed_motion_test
