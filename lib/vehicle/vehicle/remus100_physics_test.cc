// Physics of the default parameters that no table gives: energy, symmetry, drift, convergence.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/attitude.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "lib/vehicle/vehicle/vehicle_model.h"

namespace shoal::remus100_physics_test {

static_assert(VehicleModel<Remus100, Remus100State, Remus100Actuators, Remus100Environment>);

constexpr double kStep_s = 0.02;

const Remus100& DefaultAuv() {
  static const Remus100 auv = BuildRemus100({});
  return auv;
}

/// The default without propeller torque, so that port and starboard are alike.
Remus100 AuvWithoutTorque() {
  Remus100Params params;
  params.propeller.torque_on_hull = 0;
  return BuildRemus100(params);
}

Remus100State Deep() {
  Remus100State state;
  state.eta[2] = 50;
  return state;
}

Remus100State Sail(const Remus100& auv, Remus100State state, const Remus100Actuators& command,
                   double duration_s, double dt_s = kStep_s,
                   const Remus100Environment& environment = {}) {
  const auto num_steps = std::lround(duration_s / dt_s);
  for (int64_t i = 0; i < num_steps; ++i) state = Step(auv, state, command, environment, dt_s);
  return state;
}

double Between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 10001) / 10000.0;
}

Remus100State AnyMotion() {
  Remus100State state = Deep();
  state.eta.tail<3>() << Between(-1.5, 1.5), Between(-1.2, 1.2), Between(-3.1, 3.1);
  state.nu << Between(-2.5, 2.5), Between(-1, 1), Between(-1, 1), Between(-2, 2), Between(-1, 1),
      Between(-1, 1);
  return state;
}

Remus100Actuators AnyCommand() {
  return {Between(-0.26, 0.26), Between(-0.26, 0.26), Between(-1500, 1500)};
}

RC_GTEST_PROP(Remus100, NeverGainsEnergyWithoutInput, ()) {
  const Remus100State start = AnyMotion();
  const Remus100Environment environment = {.current_mps =
                                               Eigen::Vector3d(Between(-1, 1), Between(-1, 1), 0)};
  constexpr double kShort_s = 1e-6;
  const Remus100State next = Step(DefaultAuv(), start, {}, environment, kShort_s);
  const double gain_j =
      Energy(DefaultAuv(), next, environment) - Energy(DefaultAuv(), start, environment);
  RC_ASSERT(gain_j / kShort_s < 1e-2);  // Watt; what is left is the integrator's second order.
}

RC_GTEST_PROP(Remus100, EndsAtRestOnAnEvenKeelWithoutInput, ()) {
  Remus100State state = AnyMotion();
  double energy_j = Energy(DefaultAuv(), state, {});
  for (int second = 0; second < 20; ++second) {
    state = Sail(DefaultAuv(), state, {}, 1);
    const double later_j = Energy(DefaultAuv(), state, {});
    RC_ASSERT(later_j <= energy_j);
    energy_j = later_j;
  }
  RC_ASSERT(std::abs(state.eta[3]) < 0.05);
  RC_ASSERT(std::abs(state.eta[4]) < 0.05);
}

TEST(Remus100, LosesSlowSurgeWithItsTimeConstant) {
  Remus100State state = Deep();
  state.nu[0] = 0.004;
  state = Sail(DefaultAuv(), state, {}, 20);
  EXPECT_NEAR(state.nu[0] / 0.004, std::exp(-1.0), 0.01);
}

TEST(Remus100, RollsFreelyWithItsFrequencyAndDamping) {
  Remus100State state = Deep();
  state.eta[3] = 0.1;
  std::vector<double> crossings_s;
  std::vector<double> peaks_rad;
  double before_rad = state.eta[3];
  double before_rate = 0;
  constexpr double kShort_s = 0.001;
  for (int i = 1; i <= 3000; ++i) {
    state = Step(DefaultAuv(), state, {}, {}, kShort_s);
    if (before_rad > 0 && state.eta[3] <= 0) crossings_s.push_back(i * kShort_s);
    if (before_rate > 0 && state.nu[3] <= 0) peaks_rad.push_back(state.eta[3]);
    before_rad = state.eta[3];
    before_rate = state.nu[3];
  }
  ASSERT_GE(crossings_s.size(), 2U);
  ASSERT_GE(peaks_rad.size(), 1U);
  // Damped period 2 pi / (w sqrt(1 - zeta^2)); sway, which roll drags along, makes 5 % of it.
  const double period_s = 2 * kPi / (6.207 * std::sqrt(1 - 0.3 * 0.3));
  EXPECT_NEAR(crossings_s[1] - crossings_s[0], period_s, 0.05 * period_s);
  const double decay = std::exp(-2 * kPi * 0.3 / std::sqrt(1 - 0.3 * 0.3));
  EXPECT_NEAR(peaks_rad[0] / 0.1, decay, 0.3 * decay);
}

TEST(Remus100, GoesAtTheSpeedWhereThrustAndDragBalance) {
  for (const double rpm : {500.0, 1000.0, 1525.0}) {
    const Remus100State state = Sail(DefaultAuv(), Deep(), {.propeller_rpm = rpm}, 120);
    EXPECT_NEAR(state.nu[0] / SteadySpeed(DefaultAuv(), rpm), 1, 0.002) << rpm;
    EXPECT_LT(std::abs(state.eta[3]), DegToRad(1.2)) << rpm;  // Propeller torque.
  }
}

TEST(Remus100, TurnsFasterAndSlowsDownWithMoreRudder) {
  double last_radps = 0;
  double last_mps = 10;
  for (const double rudder_deg : {2.0, 5.0, 10.0, 15.0}) {
    const Remus100State state =
        Sail(DefaultAuv(), Deep(), {.rudder_rad = DegToRad(rudder_deg), .propeller_rpm = 1200}, 60);
    EXPECT_GT(state.nu[5], last_radps) << rudder_deg;
    EXPECT_LT(state.nu[0], last_mps) << rudder_deg;
    last_radps = state.nu[5];
    last_mps = state.nu[0];
  }
}

TEST(Remus100, DivesWithAPositiveSternPlaneAndTurnsTowardPsiWithAPositiveRudder) {
  const Remus100State dive =
      Sail(DefaultAuv(), Deep(), {.stern_plane_rad = 0.1, .propeller_rpm = 1200}, 10);
  EXPECT_LT(dive.eta[4], -0.05);
  EXPECT_GT(dive.eta[2], 51);
  const Remus100State turn =
      Sail(DefaultAuv(), Deep(), {.rudder_rad = 0.1, .propeller_rpm = 1200}, 10);
  EXPECT_GT(turn.nu[5], 0.05);
  EXPECT_GT(turn.eta[1], 0.5);
}

RC_GTEST_PROP(Remus100, IsCarriedByACurrentExactly, ()) {
  const Eigen::Vector3d current_mps(Between(-1, 1), Between(-1, 1), Between(-0.2, 0.2));
  Remus100State still = AnyMotion();
  Remus100State carried = still;
  carried.nu.head<3>() += CurrentInBody(DefaultAuv(), carried.eta, current_mps);
  Eigen::Vector3d way_m = Eigen::Vector3d::Zero();
  for (int i = 0; i < 20; ++i) {
    const Remus100Actuators command = AnyCommand();
    for (int j = 0; j < 10; ++j) {
      still = Step(DefaultAuv(), still, command, {}, kStep_s);
      carried = Step(DefaultAuv(), carried, command, {.current_mps = current_mps}, kStep_s);
      way_m += kStep_s * current_mps;
    }
  }
  RC_ASSERT((carried.eta.head<3>() - still.eta.head<3>() - way_m).norm() < 1e-9);
  RC_ASSERT((carried.velocity_mps - still.velocity_mps - current_mps).norm() < 1e-9);
}

TEST(Remus100, FeelsACurrentFromAsternAsMuchAsOneFromAhead) {
  const auto surge_mps2 = [](const Remus100& auv, double current_mps) {
    const Remus100Environment environment = {.current_mps = Eigen::Vector3d(current_mps, 0, 0)};
    return Step(auv, Deep(), {}, environment, kStep_s).nu[0] / kStep_s;
  };
  EXPECT_NEAR(surge_mps2(DefaultAuv(), 0.5), -surge_mps2(DefaultAuv(), -0.5), 1e-9);
  const Remus100 fossen = BuildRemus100(FossenRemus100());
  EXPECT_GT(surge_mps2(fossen, 0.5), -10 * surge_mps2(fossen, -0.5));
}

// The integrator is of first order: the error goes with the step.
TEST(Remus100, ConvergesAtTheOrderOfTheIntegrator) {
  const auto end_m = [](double dt_s) -> Eigen::Vector3d {
    const Remus100Actuators command = {0.1, 0.03, 1200};
    return Sail(DefaultAuv(), Deep(), command, 20, dt_s).eta.head<3>();
  };
  const Eigen::Vector3d limit_m = end_m(0.000625);
  const double coarse_m = (end_m(0.02) - limit_m).norm();
  const double fine_m = (end_m(0.005) - limit_m).norm();
  EXPECT_LT(coarse_m, 0.3);
  EXPECT_NEAR(coarse_m / fine_m, (0.02 - 0.000625) / (0.005 - 0.000625), 0.6);
}

RC_GTEST_PROP(Remus100, SailsTheMirroredTrackUnderTheMirroredRudder, ()) {
  const Remus100 auv = AuvWithoutTorque();
  Remus100State state = AnyMotion();
  Vector6d mirror_eta;
  mirror_eta << 1, -1, 1, -1, 1, -1;
  Remus100State mirrored = state;
  mirrored.eta = mirror_eta.cwiseProduct(state.eta);
  mirrored.nu = mirror_eta.cwiseProduct(state.nu);
  const Eigen::Vector3d current_mps(0.3, -0.2, 0);
  for (int i = 0; i < 20; ++i) {
    const Remus100Actuators command = AnyCommand();
    Remus100Actuators other = command;
    other.rudder_rad = -command.rudder_rad;
    state = Step(auv, state, command, {.current_mps = current_mps}, kStep_s);
    mirrored = Step(auv, mirrored, other,
                    {.current_mps = current_mps.cwiseProduct(Eigen::Vector3d(1, -1, 1))}, kStep_s);
  }
  RC_ASSERT((mirrored.eta - mirror_eta.cwiseProduct(state.eta)).norm() < 1e-9);
  RC_ASSERT((mirrored.nu - mirror_eta.cwiseProduct(state.nu)).norm() < 1e-9);
}

TEST(Remus100, FeelsTheSurfaceWithoutAJump) {
  const auto heave_mps2 = [](const Remus100& auv, double z_m) {
    Remus100State state;
    state.eta[2] = z_m;
    return Step(auv, state, {}, {}, kStep_s).nu[2] / kStep_s;
  };
  EXPECT_NEAR(heave_mps2(DefaultAuv(), -1e-6), heave_mps2(DefaultAuv(), 1e-6), 1e-3);
  const Remus100 munet = BuildRemus100(MunetRemus100());
  EXPECT_GT(heave_mps2(munet, -1e-6) - heave_mps2(munet, 1e-6), 5);
  EXPECT_NEAR(heave_mps2(DefaultAuv(), 0.1), 0, 1e-12);
  EXPECT_GT(heave_mps2(DefaultAuv(), -1), 5);
}

TEST(Remus100, FallsBackIntoTheWaterWhenItBreaches) {
  Remus100State state = Deep();
  state.eta[2] = 2;
  state.eta[4] = 0.5;
  state.nu[0] = 2.5;
  double highest_m = state.eta[2];
  for (int i = 0; i < 3000; ++i) {
    state = Step(DefaultAuv(), state, {}, {}, kStep_s);
    highest_m = std::min(highest_m, state.eta[2]);
  }
  EXPECT_LT(highest_m, 0.1);
  EXPECT_GT(highest_m, -1);
  EXPECT_GT(state.eta[2], 0);
}

TEST(Remus100, StaysWhereItTouchesTheGround) {
  Remus100State state = Deep();
  state.eta[4] = -0.5;
  state.nu[0] = 2;
  const Remus100Environment environment = {.current_mps = Eigen::Vector3d(0.5, 0, 0),
                                           .floor_z_m = 51};
  const Remus100Actuators ahead = {.propeller_rpm = 1200};
  state = Sail(DefaultAuv(), state, ahead, 5, kStep_s, environment);
  ASSERT_TRUE(state.immobilized);
  EXPECT_NEAR(state.eta[2], 51, 0.05);
  const Remus100State later = Sail(DefaultAuv(), state, ahead, 5, kStep_s, {});
  EXPECT_TRUE(later.immobilized);
  EXPECT_EQ(later.eta, state.eta);
  EXPECT_EQ(later.nu, Vector6d::Zero());
  EXPECT_EQ(later.velocity_mps, Eigen::Vector3d::Zero());
  EXPECT_EQ(later.actuators, Remus100Actuators());
}

TEST(Remus100, KeepsItsActuatorsWithinTheirLimitsAndLags) {
  const Remus100Actuators hard_over = {10, -10, 1e5};
  Remus100State state = Step(DefaultAuv(), Deep(), hard_over, {}, 0.1);
  EXPECT_NEAR(state.actuators.rudder_rad, DegToRad(15) * (1 - std::exp(-1.0)), 1e-12);
  EXPECT_NEAR(state.actuators.propeller_rpm, 1525 * (1 - std::exp(-0.1)), 1e-9);
  state = Sail(DefaultAuv(), state, hard_over, 20);
  EXPECT_NEAR(state.actuators.rudder_rad, DegToRad(15), 1e-9);
  EXPECT_NEAR(state.actuators.stern_plane_rad, DegToRad(-15), 1e-9);
  EXPECT_NEAR(state.actuators.propeller_rpm, 1525, 1e-3);
}

TEST(Remus100, LoopsThroughTheVertical) {
  Remus100State state = Deep();
  state.nu << 0, 0, 0, 0, 4, 0;
  double steepest_rad = 0;
  for (int i = 0; i < 2000; ++i) {
    state = Step(DefaultAuv(), state, {}, {}, 0.005);
    steepest_rad = std::max(steepest_rad, std::abs(state.eta[4]));
    EXPECT_LE(state.nu.norm(), 6);
  }
  EXPECT_GT(steepest_rad, 1.5);
  EXPECT_LT(std::abs(state.eta[4]), 0.2);
}

RC_GTEST_PROP(Remus100, StaysFiniteWhateverItIsGiven, ()) {
  const auto any = rc::gen::oneOf(
      rc::gen::arbitrary<double>(),
      rc::gen::element(0.0, -0.0, 1e-308, -1e-308, 1e9, -1e9, 1e300, -1e300,
                       std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()));
  const auto hostile =
      rc::gen::oneOf(any, rc::gen::element(std::nan(""), std::numeric_limits<double>::infinity(),
                                           -std::numeric_limits<double>::infinity()));
  const auto finite = [&] {
    const double value = *any;
    return std::isfinite(value) ? value : 0;
  };
  const Remus100 auv =
      BuildRemus100(*rc::gen::element(Remus100Params{}, MunetRemus100(), FossenRemus100()));
  Remus100State state;
  for (double& value : state.eta) value = finite();
  for (double& value : state.nu) value = finite();
  state.actuators = {finite(), finite(), finite()};
  const Remus100Actuators command = {*hostile, *hostile, *hostile};
  const Remus100Environment environment = {
      .current_mps = Eigen::Vector3d(*hostile, *hostile, *hostile), .floor_z_m = *hostile};
  const double dt_s = Between(1e-6, kMaxRemus100Step_s);
  for (int i = 0; i < 20; ++i) {
    state = Step(auv, state, command, environment, dt_s);
    RC_ASSERT(state.eta.allFinite());
    RC_ASSERT(state.nu.allFinite());
    RC_ASSERT(state.velocity_mps.allFinite());
    RC_ASSERT(std::isfinite(state.actuators.rudder_rad));
    RC_ASSERT(std::isfinite(state.actuators.stern_plane_rad));
    RC_ASSERT(std::isfinite(state.actuators.propeller_rpm));
  }
}

TEST(Remus100Params, AreFoundByName) {
  EXPECT_EQ(Remus100ParamsByName("default"), Remus100Params());
  EXPECT_EQ(Remus100ParamsByName("munet"), MunetRemus100());
  EXPECT_EQ(Remus100ParamsByName("fossen"), FossenRemus100());
  EXPECT_EQ(Remus100ParamsByName("Munet"), std::nullopt);
}

}  // namespace shoal::remus100_physics_test
