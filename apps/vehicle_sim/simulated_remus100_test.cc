// The Remus 100 as NAV shows it: in the world frame, with its signs.
#include "apps/vehicle_sim/simulated_remus100.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal::simulated_remus100_test {

constexpr double kTick_s = 0.1;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

actuators_t Command(double rudder_deg, double stern_plane_deg, double propeller_rpm) {
  actuators_t actuators{};
  actuators.rudder_deg = rudder_deg;
  actuators.stern_plane_deg = stern_plane_deg;
  actuators.propeller_rpm = propeller_rpm;
  return actuators;
}

nav_t NavOf(const SimulatedCraft& craft, const Water& water = {}) {
  nav_t nav{};
  craft.Show(water, &nav);
  return nav;
}

/// All numbers of a NAV but utime and the geodetic position.
std::vector<double> NumbersOf(const nav_t& nav) {
  return {nav.x_m,
          nav.y_m,
          nav.z_m,
          nav.roll_deg,
          nav.pitch_deg,
          nav.heading_deg,
          nav.surge_mps,
          nav.sway_mps,
          nav.heave_mps,
          nav.roll_rate_degps,
          nav.pitch_rate_degps,
          nav.yaw_rate_degps,
          nav.speed_mps,
          nav.speed_over_ground_mps,
          nav.course_over_ground_deg,
          nav.descent_mps,
          nav.altitude_m};
}

/// From the body's axes (forward, starboard, down) to North, East, Down, by the textbook's Euler
/// angles: roll to starboard, pitch bow up, heading clockwise.
Eigen::Matrix3d BodyToNed(const nav_t& nav) {
  return (Eigen::AngleAxisd(DegToRad(nav.heading_deg), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(DegToRad(nav.pitch_deg), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(DegToRad(nav.roll_deg), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Vector3d NedOf(const nav_t& nav) { return {nav.y_m, nav.x_m, nav.z_m}; }

class EveryParameterSet : public testing::TestWithParam<const char*> {
 protected:
  EveryParameterSet() : auv_({.parameters = GetParam()}) {
    auv_.Reset({.x_m = 5, .y_m = 7, .heading_deg = 350, .speed_mps = 2, .depth_m = 30}, {});
  }

  void Run(double duration_s) {
    for (int i = 0; i < std::lround(duration_s / kTick_s); ++i) auv_.Step({}, kTick_s);
  }

  SimulatedRemus100 auv_;
};

INSTANTIATE_TEST_SUITE_P(Remus100, EveryParameterSet, testing::Values("default", "munet", "fossen"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(EveryParameterSet, StartsWhereItIsPut) {
  const nav_t nav = NavOf(auv_);
  EXPECT_EQ(nav.x_m, 5);
  EXPECT_EQ(nav.y_m, 7);
  EXPECT_EQ(nav.z_m, 30);
  EXPECT_NEAR(nav.heading_deg, 350, 1e-9);
  EXPECT_NEAR(nav.course_over_ground_deg, 350, 1e-9);
  EXPECT_NEAR(nav.speed_mps, 2, 1e-12);
  EXPECT_NEAR(nav.surge_mps, 2, 1e-12);
  EXPECT_NEAR(nav.speed_over_ground_mps, 2, 1e-12);
}

TEST_P(EveryParameterSet, TurnsClockwiseUnderPositiveRudder) {
  ASSERT_TRUE(auv_.Execute(Command(10, 0, 1200)));
  Run(4);
  const nav_t nav = NavOf(auv_);
  EXPECT_GT(WrapPi(DegToRad(nav.heading_deg - 350)), DegToRad(5));
  EXPECT_GT(nav.yaw_rate_degps, 1);
  EXPECT_LT(nav.sway_mps, -0.01) << "it slides out of the turn, to port";
}

TEST_P(EveryParameterSet, RaisesItsBowUnderPositiveSternPlane) {
  ASSERT_TRUE(auv_.Execute(Command(0, 5, 1200)));
  Run(1);
  EXPECT_GT(NavOf(auv_).pitch_rate_degps, 0);
  Run(4);
  const nav_t nav = NavOf(auv_);
  EXPECT_GT(nav.pitch_deg, 1);
  EXPECT_LT(nav.descent_mps, -0.01);
  EXPECT_LT(nav.z_m, 30);
}

TEST_P(EveryParameterSet, PublishesVelocitiesThatMatchItsMotionByTheTextbooksAngles) {
  ASSERT_TRUE(auv_.Execute(Command(8, -3, 1300)));
  Run(3);
  nav_t last = NavOf(auv_);
  for (int i = 0; i < 100; ++i) {
    auv_.Step({}, kTick_s);
    const nav_t nav = NavOf(auv_);
    const auto ned_mps = [](const nav_t& at) -> Eigen::Vector3d {
      return BodyToNed(at) * Eigen::Vector3d(at.surge_mps, at.sway_mps, at.heave_mps);
    };
    const Eigen::Vector3d went_mps = (NedOf(nav) - NedOf(last)) / kTick_s;
    ASSERT_LT((went_mps - (ned_mps(last) + ned_mps(nav)) / 2).norm(), 0.01) << i;
    ASSERT_NEAR(nav.descent_mps, went_mps.z(), 0.02) << i;
    last = nav;
  }
  EXPECT_GT(std::abs(last.sway_mps), 0.03) << "so that its sign was put to the test";
}

TEST_P(EveryParameterSet, PublishesRatesThatMatchItsTurningByTheTextbooksAngles) {
  ASSERT_TRUE(auv_.Execute(Command(8, -3, 1300)));
  double most_roll_rate_degps = 0;
  nav_t last = NavOf(auv_);
  for (int i = 0; i < 100; ++i) {
    auv_.Step({}, kTick_s / 5);
    const nav_t nav = NavOf(auv_);
    const Eigen::Vector3d rates_degps(nav.roll_rate_degps, nav.pitch_rate_degps,
                                      nav.yaw_rate_degps);
    const double roll_rad = DegToRad(last.roll_deg);
    const double pitch_rad = DegToRad(last.pitch_deg);
    const double across_degps =
        rates_degps.y() * std::sin(roll_rad) + rates_degps.z() * std::cos(roll_rad);
    const Eigen::Vector3d angle_rates_degps(
        rates_degps.x() + across_degps * std::tan(pitch_rad),
        rates_degps.y() * std::cos(roll_rad) - rates_degps.z() * std::sin(roll_rad),
        across_degps / std::cos(pitch_rad));
    const Eigen::Vector3d turned_degps =
        Eigen::Vector3d(nav.roll_deg - last.roll_deg, nav.pitch_deg - last.pitch_deg,
                        RadToDeg(WrapPi(DegToRad(nav.heading_deg - last.heading_deg)))) /
        (kTick_s / 5);
    ASSERT_LT((turned_degps - angle_rates_degps).norm(), 0.2) << i;
    most_roll_rate_degps = std::max(most_roll_rate_degps, std::abs(nav.roll_rate_degps));
    last = nav;
  }
  EXPECT_GT(most_roll_rate_degps, 0.5) << "so that its sign was put to the test";
}

TEST_P(EveryParameterSet, RefusesActuatorsThatAreNoNumbersAndKeepsTheLast) {
  SimulatedRemus100 twin({.parameters = GetParam()});
  twin.Reset({.x_m = 5, .y_m = 7, .heading_deg = 350, .speed_mps = 2, .depth_m = 30}, {});
  ASSERT_TRUE(twin.Execute(Command(5, 2, 1000)));
  ASSERT_TRUE(auv_.Execute(Command(5, 2, 1000)));
  EXPECT_FALSE(auv_.Execute(Command(kNan, 0, 0)));
  EXPECT_FALSE(auv_.Execute(Command(0, kInfinity, 0)));
  EXPECT_FALSE(auv_.Execute(Command(0, 0, -kInfinity)));
  for (int i = 0; i < 50; ++i) twin.Step({}, kTick_s);
  Run(5);
  EXPECT_EQ(NumbersOf(NavOf(auv_)), NumbersOf(NavOf(twin)));
}

RC_GTEST_PROP(SimulatedRemus100, PublishesFiniteNumbersForAnyCommand, ()) {
  const auto any = [] {
    return *rc::gen::element(0.0, 1.0, -30.0, 1500.0, 1e300, -1e300, 1e-300,
                             std::numeric_limits<double>::max());
  };
  SimulatedRemus100 auv({.parameters = *rc::gen::element<std::string>("default", "munet", "fossen"),
                         .model_step_s = *rc::gen::element(0.005, 0.02, 0.2)});
  const Water water = {.velocity_mps = {*rc::gen::element(0.0, 100.0, -3.0), 100},
                       .floor_z_m = *rc::gen::element(0.0, 50.0, 6000.0)};
  auv.Reset({.x_m = *rc::gen::element(0.0, 1e6),
             .y_m = -1e6,
             .heading_deg = *rc::gen::element(0.0, 1e9, -359.0),
             .speed_mps = *rc::gen::element(0.0, 100.0, -100.0),
             .depth_m = *rc::gen::element(0.0, 20000.0)},
            water);
  for (int i = 0; i < 30; ++i) {
    if (i % 10 == 0) RC_ASSERT(auv.Execute(Command(any(), any(), any())));
    auv.Step(water, 0.1);
    for (const double number : NumbersOf(NavOf(auv, water))) RC_ASSERT(std::isfinite(number));
  }
}

/// The state after one tick cut into `num_steps`, without the simulator.
std::vector<double> PositionAfterSteps(int num_steps) {
  const Remus100 auv = BuildRemus100({});
  Remus100State state;
  state.eta << 0, 0, 30, 0, 0, PsiFromHeading(0);
  state.nu[0] = 2;
  for (int i = 0; i < num_steps; ++i) {
    state = Step(auv, state, {.rudder_rad = -DegToRad(10), .propeller_rpm = 1200}, {},
                 kTick_s / num_steps);
  }
  return {state.eta[0], state.eta[1], state.eta[2]};
}

TEST(SimulatedRemus100, CutsATickIntoTheFewestEqualStepsThatAreShortEnough) {
  const auto position_with = [](double model_step_s) -> std::vector<double> {
    SimulatedRemus100 auv({.model_step_s = model_step_s, .buoyancy_by_weight = 1});
    auv.Reset({.speed_mps = 2, .depth_m = 30}, {});
    EXPECT_TRUE(auv.Execute(Command(10, 0, 1200)));
    auv.Step({}, kTick_s);
    const Eigen::Vector3d position_m = auv.position_m();
    return {position_m.x(), position_m.y(), position_m.z()};
  };
  EXPECT_EQ(position_with(0.02), PositionAfterSteps(5));
  EXPECT_EQ(position_with(0.03), PositionAfterSteps(4));
  EXPECT_EQ(position_with(0.05), PositionAfterSteps(2));
  EXPECT_EQ(position_with(0.1), PositionAfterSteps(1));
  EXPECT_EQ(position_with(0.2), PositionAfterSteps(1));
  EXPECT_NE(PositionAfterSteps(1), PositionAfterSteps(2)) << "so that this can fail";
}

TEST(SimulatedRemus100, DistinguishesSpeedRelativeToTheWaterFromThatOverGround) {
  const Water water = {.velocity_mps = {0.5, 0}, .floor_z_m = std::nullopt};
  SimulatedRemus100 auv(Remus100Options{});
  auv.Reset({.heading_deg = 0, .speed_mps = 1.5, .depth_m = 30}, water);
  const auto expect_triangle = [&](double tolerance) {
    const nav_t nav = NavOf(auv, water);
    EXPECT_NEAR(nav.speed_mps, 1.5, tolerance);
    EXPECT_NEAR(nav.speed_over_ground_mps, std::hypot(1.5, 0.5), tolerance);
    EXPECT_NEAR(nav.course_over_ground_deg, RadToDeg(std::atan2(0.5, 1.5)), 100 * tolerance);
  };
  expect_triangle(1e-9);
  ASSERT_TRUE(auv.Execute(Command(0, 0, RpmForSpeed(BuildRemus100({}), 1.5))));
  for (int i = 0; i < 1000; ++i) auv.Step(water, kTick_s);
  expect_triangle(0.02);
}

TEST(SimulatedRemus100, DriftsWithTheWaterAtRest) {
  const Water water = {.velocity_mps = {-0.3, 0.4}, .floor_z_m = 80};
  SimulatedRemus100 auv({.buoyancy_by_weight = 1});
  auv.Reset({.heading_deg = 120, .depth_m = 30}, water);
  for (int i = 0; i < 600; ++i) auv.Step(water, kTick_s);
  const nav_t nav = NavOf(auv, water);
  EXPECT_NEAR(nav.speed_mps, 0, 1e-9);
  EXPECT_NEAR(nav.x_m, -18, 1e-6);
  EXPECT_NEAR(nav.y_m, 24, 1e-6);
  EXPECT_NEAR(nav.altitude_m, 50, 1e-6);
  EXPECT_NEAR(nav.course_over_ground_deg, 360 - RadToDeg(std::atan2(0.3, 0.4)), 1e-6);
}

TEST(SimulatedRemus100, FloatsWhereItIsPutAtTheSurfaceAndComesUpFromBelow) {
  SimulatedRemus100 auv(Remus100Options{});
  auv.Reset({.depth_m = 0}, {});
  for (int i = 0; i < 600; ++i) {
    auv.Step({}, kTick_s);
    ASSERT_NEAR(NavOf(auv).z_m, 0.09, 0.02);
  }
  auv.Reset({.depth_m = 10}, {});
  for (int i = 0; i < 1200; ++i) auv.Step({}, kTick_s);
  EXPECT_NEAR(NavOf(auv).z_m, 0.09, 0.02);
}

TEST(SimulatedRemus100, FloatsUpByDefaultAndIsNeutralWithTheParametersOfThePublishedPrograms) {
  EXPECT_EQ(BuoyancyOf({}), 1.005);
  EXPECT_EQ(BuoyancyOf({.parameters = "munet"}), 1);
  EXPECT_EQ(BuoyancyOf({.parameters = "fossen"}), 1);
  EXPECT_EQ(BuoyancyOf({.parameters = "munet", .buoyancy_by_weight = 1.01}), 1.01);
}

TEST(SimulatedRemus100, KnowsNoAltitudeWithoutAFloor) {
  SimulatedRemus100 auv(Remus100Options{});
  auv.Reset({.depth_m = 30}, {});
  EXPECT_EQ(NavOf(auv).altitude_m, -1);
  EXPECT_EQ(NavOf(auv, {.floor_z_m = 100}).altitude_m, 70);
  EXPECT_EQ(NavOf(auv, {.floor_z_m = 20}).altitude_m, 0) << "inside the floor";
}

}  // namespace shoal::simulated_remus100_test
