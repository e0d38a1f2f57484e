#include "lib/vehicle/control/speed_controller.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace shoal::speed_controller_test {

// A vessel whose speed follows thrust / 20 within an acceleration limit; `drag` is what its thrust
// map does not know of.
struct Vessel {
  double speed_mps = 0;
  double drag = 0;

  void Step(double thrust_pct, double dt_s) {
    const double target_mps = thrust_pct / 20 * (1 - drag);
    speed_mps += std::clamp(target_mps - speed_mps, -0.5 * dt_s, 0.5 * dt_s);
  }
};

constexpr SpeedGains kGains{.kp = 5, .ki = 2, .integral_limit_pct = 20};

TEST(SpeedController, GivesTheForeseenThrustWhenTheSpeedIsRight) {
  SpeedController speed(kGains);
  EXPECT_DOUBLE_EQ(speed.Update(2, 40, 2, 0.1), 40);
}

TEST(SpeedController, GivesNoThrustForNoSpeed) {
  SpeedController speed(kGains);
  EXPECT_EQ(speed.Update(0, 40, -3, 0.1), 0);
  EXPECT_EQ(speed.Update(-1, 40, -3, 0.1), 0);
}

TEST(SpeedController, ReachesTheSpeedAlthoughTheMapIsWrong) {
  SpeedController speed(kGains);
  Vessel vessel{.drag = 0.15};
  for (int i = 0; i < 600; ++i) vessel.Step(speed.Update(2, 40, vessel.speed_mps, 0.1), 0.1);
  EXPECT_NEAR(vessel.speed_mps, 2, 0.02);
}

TEST(SpeedController, DoesNotOvershootAfterAnAcceleration) {
  SpeedController speed(kGains);
  Vessel vessel;
  double fastest_mps = 0;
  for (int i = 0; i < 600; ++i) {
    vessel.Step(speed.Update(2, 40, vessel.speed_mps, 0.1), 0.1);
    fastest_mps = std::max(fastest_mps, vessel.speed_mps);
  }
  EXPECT_LT(fastest_mps, 2.02);
  EXPECT_NEAR(vessel.speed_mps, 2, 0.01);
}

TEST(SpeedController, KeepsItsThrustBetweenNoneAndFull) {
  SpeedController speed({.kp = 1000, .ki = 0});
  EXPECT_EQ(speed.Update(2, 40, -5, 100), 100);
  speed.Reset();
  speed.Update(2, 40, 2, 0.1);
  EXPECT_EQ(speed.Update(2, 40, 9, 0.1), 0);
}

TEST(SpeedController, DoesNotWindUpAtFullThrust) {
  SpeedController speed({.kp = 5, .ki = 2});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(speed.Update(6, 100, 5, 0.1), 100);
  EXPECT_NEAR(speed.Update(6, 50, 6, 0.1), 50, 1e-9);
}

}  // namespace shoal::speed_controller_test
