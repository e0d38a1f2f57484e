#include "lib/vehicle/vehicle/surface_craft.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/vehicle_model.h"

namespace shoal::surface_craft_test {

static_assert(
    VehicleModel<SurfaceCraftParams, SurfaceCraftState, SurfaceCraftCommand, Eigen::Vector2d>);

const Eigen::Vector2d kStillWater = Eigen::Vector2d::Zero();

SurfaceCraftState Sail(const SurfaceCraftParams& params, SurfaceCraftState state,
                       const SurfaceCraftCommand& command, double duration_s, double dt_s = 0.1,
                       const Eigen::Vector2d& current_mps = kStillWater) {
  const int num_steps = static_cast<int>(std::lround(duration_s / dt_s));
  for (int i = 0; i < num_steps; ++i) state = Step(params, state, command, current_mps, dt_s);
  return state;
}

TEST(ThrustMap, IsLinearBetweenItsPointsAndFlatBeyondThem) {
  const SurfaceCraftParams params{.thrust_map = {{20, 1}, {60, 2}, {80, 4}}};
  EXPECT_DOUBLE_EQ(SteadySpeed(params, 0), 0);
  EXPECT_DOUBLE_EQ(SteadySpeed(params, 10), 0.5);
  EXPECT_DOUBLE_EQ(SteadySpeed(params, 20), 1);
  EXPECT_DOUBLE_EQ(SteadySpeed(params, 70), 3);
  EXPECT_DOUBLE_EQ(SteadySpeed(params, 100), 4);
}

TEST(ThrustMap, MirrorsAsternByTheReverseRatioUnlessAsternIsMapped) {
  SurfaceCraftParams params{.thrust_map = {{100, 4}}, .reverse_ratio = 0.25};
  EXPECT_DOUBLE_EQ(SteadySpeed(params, -50), -0.5);
  params.thrust_map = {{-80, -3}, {-40, -1}, {100, 4}};
  EXPECT_DOUBLE_EQ(SteadySpeed(params, -20), -0.5);
  EXPECT_DOUBLE_EQ(SteadySpeed(params, -60), -2);
  EXPECT_DOUBLE_EQ(SteadySpeed(params, -100), -3);
  EXPECT_DOUBLE_EQ(SteadySpeed(params, 50), 2);
}

TEST(ThrustMap, GivesNoSpeedWithoutPoints) {
  const SurfaceCraftParams params{.thrust_map = {}};
  EXPECT_EQ(SteadySpeed(params, 100), 0);
  EXPECT_EQ(ThrustForSpeed(params, 1), 100);
}

TEST(ThrustMap, GivesFullThrustForASpeedThatIsOutOfReachAndNoneForNoSpeed) {
  const SurfaceCraftParams params{.thrust_map = {{50, 2}}};
  EXPECT_EQ(ThrustForSpeed(params, 2.1), 100);
  EXPECT_EQ(ThrustForSpeed(params, 0), 0);
  EXPECT_EQ(ThrustForSpeed(params, -1), 0);
  EXPECT_EQ(ThrustForSpeed(params, std::nan("")), 0);
}

RC_GTEST_PROP(ThrustMap, IsUndoneByThrustForSpeed, ()) {
  const SurfaceCraftParams params{.thrust_map = {{20, 1}, {60, 2}, {100, 4}}};
  const double speed_mps = *rc::gen::inRange(0, 4001) / 1000.0;
  RC_ASSERT(std::abs(SteadySpeed(params, ThrustForSpeed(params, speed_mps)) - speed_mps) < 1e-9);
}

TEST(SurfaceCraft, SpeedsUpAndSlowsDownNoFasterThanItsLimits) {
  const SurfaceCraftParams params{.max_acceleration_mps2 = 0.4, .max_deceleration_mps2 = 0.2};
  SurfaceCraftState state = Sail(params, {}, {.thrust_pct = 100}, 2);
  EXPECT_NEAR(state.speed_mps, 0.8, 1e-12);
  EXPECT_NEAR(state.position_m.y(), 0.5 * 0.4 * 2 * 2, 1e-12);
  state = Sail(params, state, {}, 3);
  EXPECT_NEAR(state.speed_mps, 0.2, 1e-12);
}

TEST(SurfaceCraft, SettlesAtTheSpeedOfItsThrustMap) {
  const SurfaceCraftParams params{.thrust_map = {{40, 1}, {100, 3}}};
  EXPECT_EQ(Sail(params, {}, {.thrust_pct = 70}, 10).speed_mps, 2);
}

TEST(SurfaceCraft, BrakesFirstAndThenGoesAsternWithinOneStep) {
  const SurfaceCraftParams params{.max_acceleration_mps2 = 1, .max_deceleration_mps2 = 2};
  const SurfaceCraftState state =
      Step(params, {.speed_mps = 1}, {.thrust_pct = -100}, kStillWater, 1);
  EXPECT_DOUBLE_EQ(state.speed_mps, -0.5);
}

TEST(SurfaceCraft, TurnsInProportionToItsSpeedUpToFullTurnSpeed) {
  const SurfaceCraftParams params{
      .thrust_map = {{100, 5}}, .max_rudder_rate_degps = 1e6, .turn_speed_loss = 0};
  const auto yaw_rate_degps = [&](double speed_mps) {
    const SurfaceCraftState state{.speed_mps = speed_mps, .rudder_deg = 50};
    const SurfaceCraftCommand hold{.thrust_pct = speed_mps * 20, .rudder_deg = 50};
    return RadToDeg(Step(params, state, hold, kStillWater, 0.1).yaw_rate_radps);
  };
  EXPECT_NEAR(yaw_rate_degps(0), 0, 1e-12);
  EXPECT_NEAR(yaw_rate_degps(0.5), 35 * 0.5 / 3, 1e-9);
  EXPECT_NEAR(yaw_rate_degps(1.5), 35 * 0.5, 1e-9);
  EXPECT_NEAR(yaw_rate_degps(4), 35 * 0.5, 1e-9);
}

TEST(SurfaceCraft, TurnsInProportionToItsThrustWhereThatCounts) {
  SurfaceCraftParams params{
      .thrust_map = {{100, 5}}, .max_rudder_rate_degps = 1e6, .turn_speed_loss = 0};
  params.full_turn_thrust_pct = 50;
  const auto yaw_rate_degps = [&](double thrust_pct) {
    const SurfaceCraftState state{.speed_mps = thrust_pct / 20, .rudder_deg = 50};
    const SurfaceCraftCommand hold{.thrust_pct = thrust_pct, .rudder_deg = 50};
    return RadToDeg(Step(params, state, hold, kStillWater, 0.1).yaw_rate_radps);
  };
  EXPECT_NEAR(yaw_rate_degps(40), 35 * 0.5 * 0.8, 1e-9);
  EXPECT_NEAR(yaw_rate_degps(100), 35 * 0.5 * 2, 1e-9);
  EXPECT_NEAR(yaw_rate_degps(-100), -35 * 0.5 * 2, 1e-9) << "astern the other way round";
}

TEST(SurfaceCraft, TurnsToStarboardWithPositiveRudderAndTheOtherWayAstern) {
  const SurfaceCraftParams params;
  EXPECT_GT(Sail(params, {.heading_rad = 1, .speed_mps = 2}, {40, 30}, 1).heading_rad, 1);
  EXPECT_LT(Sail(params, {.heading_rad = 1, .speed_mps = -2}, {-80, 30}, 1).heading_rad, 1);
}

TEST(SurfaceCraft, LosesSpeedInATurn) {
  const SurfaceCraftParams params{.turn_speed_loss = 0.4};
  EXPECT_NEAR(Sail(params, {}, {.thrust_pct = 60, .rudder_deg = 50}, 20).speed_mps, 3 * 0.8, 1e-9);
}

TEST(SurfaceCraft, MovesItsRudderNoFasterThanItsRate) {
  const SurfaceCraftParams params{.max_rudder_deg = 30, .max_rudder_rate_degps = 20};
  EXPECT_NEAR(Sail(params, {}, {.rudder_deg = -90}, 1).rudder_deg, -20, 1e-9);
  EXPECT_NEAR(Sail(params, {}, {.rudder_deg = -90}, 3).rudder_deg, -30, 1e-9);
}

TEST(SurfaceCraft, DriftsExactlyWithTheCurrent) {
  const SurfaceCraftState state = Sail({}, {.position_m = {10, 20}}, {}, 100, 0.1, {0.5, -0.25});
  EXPECT_NEAR(state.position_m.x(), 60, 1e-9);
  EXPECT_NEAR(state.position_m.y(), -5, 1e-9);
  EXPECT_EQ(state.velocity_over_ground_mps, Eigen::Vector2d(0.5, -0.25));
  EXPECT_EQ(state.speed_mps, 0);
}

TEST(SurfaceCraft, TakesCommandsThatAreNotFiniteAsZero) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const SurfaceCraftState start{.speed_mps = 1, .rudder_deg = 10};
    const SurfaceCraftState state = Step({}, start, {bad, bad}, kStillWater, 0.1);
    const SurfaceCraftState coasting = Step({}, start, {}, kStillWater, 0.1);
    EXPECT_EQ(state.speed_mps, coasting.speed_mps);
    EXPECT_EQ(state.rudder_deg, coasting.rudder_deg);
    EXPECT_EQ(state.position_m, coasting.position_m);
  }
}

// Halving the step must bring the end point closer to the limit, about four times (second order).
TEST(SurfaceCraft, ConvergesWithTheStep) {
  const SurfaceCraftState start{.speed_mps = 2, .rudder_deg = 20};
  const SurfaceCraftCommand command{.thrust_pct = 40 / 0.92, .rudder_deg = 20};
  const auto end = [&](double dt_s) { return Sail({}, start, command, 32, dt_s).position_m; };
  const Eigen::Vector2d limit_m = end(0.001);
  const double coarse_m = (end(0.4) - limit_m).norm();
  const double fine_m = (end(0.2) - limit_m).norm();
  EXPECT_LT(coarse_m, 0.5);
  EXPECT_NEAR(coarse_m / fine_m, 4, 0.5);
}

RC_GTEST_PROP(SurfaceCraft, SailsTheMirroredTrackUnderTheMirroredRudder, ()) {
  const auto percent = rc::gen::inRange(-100, 101);
  SurfaceCraftState one{.speed_mps = *percent / 50.0};
  SurfaceCraftState other = one;
  for (int i = 0; i < 100; ++i) {
    const SurfaceCraftCommand command{.thrust_pct = *percent * 1.0, .rudder_deg = *percent * 1.0};
    one = Step({}, one, command, {0.25, 0.5}, 0.1);
    other = Step({}, other, {command.thrust_pct, -command.rudder_deg}, {-0.25, 0.5}, 0.1);
  }
  RC_ASSERT(std::abs(one.position_m.x() + other.position_m.x()) < 1e-9);
  RC_ASSERT(std::abs(one.position_m.y() - other.position_m.y()) < 1e-9);
  RC_ASSERT(std::abs(WrapPi(one.heading_rad + other.heading_rad)) < 1e-9);
  RC_ASSERT(one.speed_mps == other.speed_mps);
}

RC_GTEST_PROP(SurfaceCraft, StaysFiniteAndWithinItsLimitsUnderAnyCommand,
              (double thrust_pct, double rudder_deg)) {
  const SurfaceCraftParams params;
  SurfaceCraftState state{.speed_mps = *rc::gen::inRange(-5, 6) * 1.0};
  for (int i = 0; i < 20; ++i) {
    const SurfaceCraftState next =
        Step(params, state, {thrust_pct, rudder_deg}, {1, -1}, *rc::gen::element(0.01, 0.1, 1.0));
    RC_ASSERT(next.position_m.allFinite());
    RC_ASSERT(std::isfinite(next.speed_mps));
    RC_ASSERT(std::abs(next.speed_mps) <= std::max(std::abs(state.speed_mps), 5.0));
    RC_ASSERT(std::abs(next.rudder_deg) <= params.max_rudder_deg);
    RC_ASSERT(next.heading_rad >= 0);
    RC_ASSERT(next.heading_rad < 2 * kPi);
    state = next;
  }
}

}  // namespace shoal::surface_craft_test
