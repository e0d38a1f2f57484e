#include "lib/vehicle/vehicle/buoy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shoal::buoy_test {

BuoyState Moored(const Eigen::Vector2d& anchor_m) {
  return {.anchor_m = anchor_m, .position_m = anchor_m};
}

BuoyState After(double duration_s, BuoyState state, const Eigen::Vector2d& current_mps,
                const BuoyParams& params) {
  for (int i = 0; i < std::lround(duration_s / 0.1); ++i) {
    state = Step(params, state, {}, current_mps, 0.1);
  }
  return state;
}

TEST(Buoy, DriftsWithTheCurrentUntilItsMooringIsTaut) {
  const BuoyParams params = {.watch_radius_m = 20};
  const BuoyState slack = After(50, Moored({100, -40}), {0.3, 0}, params);
  EXPECT_NEAR(slack.position_m.x(), 115, 1e-9);
  EXPECT_NEAR(slack.velocity_mps.x(), 0.3, 1e-9);
  const BuoyState taut = After(500, slack, {0.3, 0}, params);
  EXPECT_NEAR(taut.position_m.x(), 120, 1e-9);
  EXPECT_NEAR(taut.position_m.y(), -40, 1e-9);
  EXPECT_NEAR(taut.velocity_mps.norm(), 0, 1e-9);
}

TEST(Buoy, SlidesAlongItsWatchCircleWhereTheCurrentTurns) {
  const BuoyParams params = {.watch_radius_m = 20};
  BuoyState state = After(500, Moored({0, 0}), {0.3, 0}, params);
  state = After(2, state, {0, 0.3}, params);
  EXPECT_NEAR(state.position_m.norm(), 20, 1e-9);
  // For a current across the mooring the angle t changes by dt/ds = v/R cos t: sin t = tanh(v s /
  // R).
  EXPECT_NEAR(state.position_m.y(), 20 * std::tanh(0.3 * 2 / 20), 2e-3);
  state = After(2000, state, {0, 0.3}, params);
  EXPECT_NEAR(state.position_m.y(), 20, 1e-3) << "downstream of its anchor";
}

TEST(Buoy, StaysWhereItIsInStillWaterAndWithoutAnyScope) {
  EXPECT_EQ(After(10, Moored({3, 4}), {0, 0}, {}).position_m, Eigen::Vector2d(3, 4));
  EXPECT_EQ(After(10, Moored({3, 4}), {1, 1}, {.watch_radius_m = 0}).position_m,
            Eigen::Vector2d(3, 4));
}

TEST(Buoy, IsNeverFartherFromItsAnchorThanItsWatchCircle) {
  const BuoyParams params = {.watch_radius_m = 7};
  BuoyState state = Moored({-5, 2});
  for (int i = 0; i < 3000; ++i) {
    const double angle_rad = 0.013 * i;
    state = Step(params, state, {}, {2 * std::cos(angle_rad), 2 * std::sin(3 * angle_rad)}, 0.5);
    ASSERT_LE((state.position_m - state.anchor_m).norm(), 7 * (1 + 1e-12));
  }
}

}  // namespace shoal::buoy_test
