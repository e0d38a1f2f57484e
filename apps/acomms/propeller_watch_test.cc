#include "apps/acomms/propeller_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal::propeller_watch_test {

constexpr int64_t kTick_us = 100'000;
const Motion kOwn = {.position_m = {0, 0, 20}, .velocity_mps = {1, 0, 0}};

PropellerWatch WatchOf(const std::string& parameters, double max_rate_rpmps) {
  return PropellerWatch(AnyModel(
      Remus100Options{.parameters = parameters, .max_propeller_rate_rpmps = max_rate_rpmps}));
}

/// Shows `watch` ACTUATORS with these revolutions, one tick after the other; returns the time of
/// the last.
int64_t Show(PropellerWatch* watch, const std::vector<double>& each_rpm) {
  actuators_t actuators{};
  for (const double rpm : each_rpm) {
    actuators.utime += kTick_us;
    actuators.propeller_rpm = rpm;
    watch->OnActuators(actuators);
  }
  return actuators.utime;
}

TEST(PropellerWatch, AcceleratesByTheSlopeOfTheMapTimesTheRateOfTheRevolutions) {
  PropellerWatch munet = WatchOf("munet", 50);
  const int64_t utime = Show(&munet, {600, 602});
  const SpeedPlan plan = munet.PlanOf(kOwn, utime);
  EXPECT_EQ(plan.speed_mps, 1);
  EXPECT_NEAR(plan.acceleration_mps2, 0.0016922 * 20, 1e-12) << "20 rpm/s on muNet's third line";
  EXPECT_NEAR(plan.max_speed_mps, 0.0016922 * 1525 - 0.0273616, 1e-12);

  // 60 m ahead: v_f^2 = 1 + 2 x 0.033844 x 60.
  const Motion next = PredictAtPoint(kOwn, {60, 0, 20}, plan);
  EXPECT_NEAR(next.velocity_mps.x(), std::sqrt(1 + 2 * 0.0016922 * 20 * 60), 1e-12);
}

TEST(PropellerWatch, TakesTheSlopeOfTheVehiclesOwnMap) {
  PropellerWatch watch = WatchOf("default", 50);
  const SpeedPlan plan = watch.PlanOf(kOwn, Show(&watch, {900, 898}));
  const Remus100 auv = BuildRemus100({});
  const double slope = (SteadySpeed(auv, 903) - SteadySpeed(auv, 893)) / 10;
  EXPECT_NEAR(plan.acceleration_mps2, -20 * slope, 20 * slope * 1e-3);
  EXPECT_LT(plan.acceleration_mps2, -0.02);
  EXPECT_EQ(PredictAtPoint(kOwn, {500, 0, 20}, plan).velocity_mps.norm(), 0)
      << "it stops before it gets there";
}

TEST(PropellerWatch, KnowsNoRateAtTheSetPoint) {
  PropellerWatch watch = WatchOf("default", 50);
  const SpeedPlan plan = watch.PlanOf(kOwn, Show(&watch, {1195, 1200, 1200}));
  EXPECT_EQ(plan.acceleration_mps2, 0);
  EXPECT_EQ(PredictAtPoint(kOwn, {60, 0, 20}, plan).velocity_mps, kOwn.velocity_mps);
}

TEST(PropellerWatch, TakesAPropellerThatIsCommandedAtOnceForAConstantOne) {
  PropellerWatch watch = WatchOf("default", 0);
  EXPECT_FALSE(watch.is_needed());
  EXPECT_EQ(watch.PlanOf(kOwn, Show(&watch, {0, 1200})).acceleration_mps2, 0);
  EXPECT_FALSE(PropellerWatch(AnyModel(SurfaceCraftParams())).is_needed());
}

TEST(PropellerWatch, BelievesNoRateBeyondTheLimitAndNoneThatIsOld) {
  PropellerWatch watch = WatchOf("munet", 50);
  const int64_t utime = Show(&watch, {1200, 0});
  const double stop_mps2 = watch.PlanOf(kOwn, utime).acceleration_mps2;
  EXPECT_NEAR(stop_mps2, -50 * 0.000611108, 1e-12) << "an all-stop is not a ramp";
  EXPECT_EQ(watch.PlanOf(kOwn, utime + PropellerWatch::kTimeout_us).acceleration_mps2, stop_mps2);
  EXPECT_EQ(watch.PlanOf(kOwn, utime + PropellerWatch::kTimeout_us + 1).acceleration_mps2, 0);
}

TEST(PropellerWatch, IgnoresActuatorsThatAreNotFiniteOrRepeatATime) {
  PropellerWatch watch = WatchOf("munet", 50);
  actuators_t actuators{};
  actuators.utime = Show(&watch, {500, 502});
  actuators.propeller_rpm = std::numeric_limits<double>::quiet_NaN();
  watch.OnActuators(actuators);
  EXPECT_GT(watch.PlanOf(kOwn, actuators.utime).acceleration_mps2, 0);
  actuators.propeller_rpm = 504;
  watch.OnActuators(actuators);
  EXPECT_EQ(watch.PlanOf(kOwn, actuators.utime).acceleration_mps2, 0);
}

}  // namespace shoal::propeller_watch_test
