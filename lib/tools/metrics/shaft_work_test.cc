#include "lib/tools/metrics/shaft_work.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal::shaft_work_test {

constexpr double kTwoPi = 6.283185307179586;

/// The work of `duration_s` at steady revolutions: from long after the start on.
double SteadyWork(double rpm, double surge_mps, double duration_s) {
  ShaftWork work((Remus100Params()));
  for (int i = 0; i < 600; ++i) work.Step(rpm, surge_mps, 0.1);
  const double before_j = work.work_j();
  for (int i = 0; i < std::lround(duration_s * 10); ++i) work.Step(rpm, surge_mps, 0.1);
  return work.work_j() - before_j;
}

TEST(ShaftWork, IsTheBollardTorqueTimesRevolutionsAtRest) {
  // KQ_0 = 0.07, D = 0.14 m, rho = 1026 kg/m3, 20 revolutions per second.
  const double torque_nm = 0.07 * 1026 * std::pow(0.14, 5) * 20 * 20;
  EXPECT_NEAR(SteadyWork(1200, 0, 10), kTwoPi * 20 * torque_nm * 10, 1e-6);
}

TEST(ShaftWork, FallsWithTheAdvanceRatio) {
  // J = 0.944 * 1.5 / (20 * 0.14); the torque falls linearly to 0.0312 at J = 0.6632.
  const double advance = 0.944 * 1.5 / (20 * 0.14);
  const double coefficient = 0.07 + (0.0312 - 0.07) * advance / 0.6632;
  const double torque_nm = coefficient * 1026 * std::pow(0.14, 5) * 20 * 20;
  EXPECT_NEAR(SteadyWork(1200, 1.5, 1), kTwoPi * 20 * torque_nm, 1e-6);
}

TEST(ShaftWork, IsMoreThanWhatMovesTheVehicle) {
  const Remus100 auv = BuildRemus100({});
  const double speed_mps = SteadySpeed(auv, 1200);
  const double thrust_n =
      ForceOf(auv.params.propeller, auv.params.water_density_kgpm3, 1200, speed_mps).thrust_n;
  const double useful_j = (1 - auv.params.propeller.thrust_deduction) * thrust_n * speed_mps;
  const double work_j = SteadyWork(1200, speed_mps, 1);
  EXPECT_GT(work_j, useful_j);
  EXPECT_LT(work_j, 2 * useful_j) << "an efficiency of more than a half";
}

TEST(ShaftWork, FollowsTheCommandWithTheModelsLag) {
  const Remus100 auv = BuildRemus100({});
  ShaftWork work(auv.params);
  Remus100State state;
  state.eta << 0, 0, 20, 0, 0, 0;
  for (int i = 0; i < 100; ++i) {
    const double command_rpm = i < 50 ? 1000 : 2500;
    work.Step(command_rpm, state.nu[0], 0.1);
    state = Step(auv, state, {.propeller_rpm = command_rpm}, {}, 0.1);
    EXPECT_NEAR(work.rpm(), state.actuators.propeller_rpm, 1e-9) << i;
  }
  EXPECT_LE(work.rpm(), auv.params.propeller.max_rpm);
}

TEST(ShaftWork, CountsAsternToo) {
  EXPECT_NEAR(SteadyWork(-600, 0, 1), SteadyWork(600, 0, 1), 1e-9);
  EXPECT_GT(SteadyWork(-600, 0, 1), 0);
}

TEST(ShaftWork, IsNoneOfAPropellerAtRestOrDrivenByTheWater) {
  EXPECT_EQ(SteadyWork(0, 1.5, 10), 0);
  EXPECT_EQ(SteadyWork(100, 2.5, 10), 0) << "J = 10: the torque drives the propeller";
}

TEST(ShaftWork, TakesNumbersThatAreNotFiniteAsZero) {
  ShaftWork work((Remus100Params()));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  work.Step(kNan, kNan, 0.1);
  work.Step(std::numeric_limits<double>::infinity(), 1, 0.1);
  EXPECT_EQ(work.work_j(), 0);
  EXPECT_EQ(work.rpm(), 0);
}

}  // namespace shoal::shaft_work_test
