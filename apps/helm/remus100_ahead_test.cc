#include "apps/helm/remus100_ahead.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apps/helm/remus100_testing.h"

namespace shoal::remus100_ahead_test {

TEST(Remus100Ahead, IsWhereTheVehicleWillBe) {
  for (const char* set : {"default", "munet"}) {
    const Remus100 auv = BuildRemus100(*Remus100ParamsByName(set));
    constexpr double kTick_s = 0.1;
    constexpr int kSubsteps = 5;
    Remus100Ahead ahead(auv, kTick_s / kSubsteps);
    Remus100State state;
    state.eta[2] = 20;
    Remus100Actuators before;
    for (int i = 0; i < 100; ++i) {
      const Remus100State then = ahead.Predict(NavOf(state), kTick_s);
      const Remus100Actuators command = {0.1 * std::sin(0.3 * i), 0.05 * std::cos(0.2 * i), 1200};
      // What the vehicle carries out meanwhile was commanded a step before.
      for (int k = 0; k < kSubsteps; ++k) {
        state = Step(auv, state, before, {}, kTick_s / kSubsteps);
      }
      before = command;
      ahead.Command(command);
      ASSERT_LT((then.eta - state.eta).tail<4>().norm(), 1e-9) << set << " " << i;
      ASSERT_LT((then.nu - state.nu).norm(), 1e-9) << set << " " << i;
    }
    EXPECT_GT(state.nu[0], 1);
  }
}

TEST(Remus100Ahead, IsFiniteWhateverNavHolds) {
  const Remus100 auv = BuildRemus100(MunetRemus100());
  Remus100Ahead ahead(auv, 0.02);
  nav_t nav = NavOf({});
  nav.pitch_deg = nav.yaw_rate_degps = nav.surge_mps = 1e300;
  nav.heading_deg = nav.roll_deg = -1e300;
  const Remus100State then = ahead.Predict(nav, 1);
  EXPECT_TRUE(then.eta.tail<4>().allFinite());
  EXPECT_TRUE(then.nu.allFinite());
}

}  // namespace shoal::remus100_ahead_test
