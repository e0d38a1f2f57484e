// Physics of all parameter sets that no table gives: balances and decays worked out by hand from
// what the sets are made of.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "lib/vehicle/vehicle/remus100.h"

namespace shoal::remus100_balance_test {

constexpr double kStep_s = 0.02;
constexpr const char* kSets[] = {"default", "munet", "fossen"};

Remus100 AuvOf(const std::string& set) { return BuildRemus100(*Remus100ParamsByName(set)); }

Remus100State Deep() {
  Remus100State state;
  state.eta[2] = 50;
  return state;
}

Remus100State Sail(const Remus100& auv, Remus100State state, const Remus100Actuators& command,
                   double duration_s, double dt_s = kStep_s) {
  const auto num_steps = std::lround(duration_s / dt_s);
  for (int64_t i = 0; i < num_steps; ++i) state = Step(auv, state, command, {}, dt_s);
  return state;
}

/// Returns in how many of many motions `auv` gains energy, relative to the water, without input.
int CountEnergyGains(const Remus100& auv, const Eigen::Vector3d& current_mps) {
  constexpr double kShort_s = 1e-6;
  constexpr double kIntegrator_w = 1e-2;  // What is left of the integrator's second order.
  const Remus100Environment sea = {.current_mps = current_mps};
  int num_gains = 0;
  for (int code = 0; code < 4096; ++code) {  // Four values of each of six velocities.
    Remus100State state = Deep();
    state.eta.tail<3>() << 0.3, -0.4, 1;
    int rest = code;
    for (const auto& [axis, scale] :
         {std::pair{0, 1.0}, {1, 0.5}, {2, 0.5}, {3, 0.5}, {4, 0.5}, {5, 0.5}}) {
      state.nu[axis] = scale * (rest % 4 - 1.5);
      rest /= 4;
    }
    const Remus100State next = Step(auv, state, {}, sea, kShort_s);
    const double gain_j = Energy(auv, next, sea) - Energy(auv, state, sea);
    if (gain_j / kShort_s > kIntegrator_w) ++num_gains;
  }
  return num_gains;
}

// muNet leaves out terms of C without their counterparts, so that its C does work: in these motions
// less than drag takes.
TEST(EnergyWithoutInput, GrowsInNoSetWithAndWithoutACurrent) {
  for (const char* set : kSets) {
    EXPECT_EQ(CountEnergyGains(AuvOf(set), Eigen::Vector3d::Zero()), 0) << set;
    EXPECT_EQ(CountEnergyGains(AuvOf(set), Eigen::Vector3d(0.8, -0.6, 0)), 0) << set;
  }
}

TEST(SteadySpeedOfEverySet, IsWhereThrustAndDragBalance) {
  for (const char* set : kSets) {
    for (const double rpm : {600.0, 1200.0, 1525.0}) {
      const Remus100State state = Sail(AuvOf(set), Deep(), {.propeller_rpm = rpm}, 120);
      const double u = state.nu[0];
      const double n = rpm / 60;
      constexpr double kRho = 1026;
      constexpr double kDiameter_m = 0.14;
      const double advance = 0.944 * u / (n * kDiameter_m);
      const double thrust_n = (1 - 0.1) * kRho * std::pow(kDiameter_m, 4) * n * n *
                              (0.4566 + (0.1798 - 0.4566) / 0.6632 * advance);
      const double drag_n =
          0.5 * kRho * 0.2128 * 0.05596 * u * u + 31.868 / 20 * std::exp(-3 * u) * u;
      EXPECT_NEAR(thrust_n / drag_n, 1, 0.02) << set << " " << rpm << " rpm, " << u << " m/s";
    }
  }
}

TEST(SteadySpeedOfEverySet, IsThatOfTheOriginalForMunets) {
  EXPECT_NEAR(Sail(AuvOf("munet"), Deep(), {.propeller_rpm = 1200}, 120).nu[0], 2.009, 0.001);
  EXPECT_NEAR(Sail(AuvOf("munet"), Deep(), {.propeller_rpm = 1525}, 120).nu[0], 2.554, 0.001);
}

// N_rudder + N_crossflow(v, r) = M66 / T r, and sway likewise. The hull's own turning moment (Munk)
// is one of the terms that the model leaves out.
TEST(TurnRate, IsWhereTheMomentsOfRudderCrossFlowAndYawDampingBalance) {
  Remus100Params params;
  params.propeller.torque_on_hull = 0;
  const Remus100 auv = BuildRemus100(params);
  for (const double rudder_rad : {0.002, 0.05, 0.1, 0.26}) {
    const Remus100State turn =
        Sail(auv, Deep(), {.rudder_rad = rudder_rad, .propeller_rpm = 1200}, 90);
    const double v = turn.nu[1];
    const double r = turn.nu[5];
    const double fin_mps2 = turn.nu[0] * turn.nu[0] + v * v;
    const double rudder_nm = 0.8 * 0.5 * 1026 * fin_mps2 * 0.0133 * 0.5 * rudder_rad;
    double cross_flow_nm = 0;
    constexpr double kStrip_m = 0.001;
    for (double x_m = -0.8 + kStrip_m / 2; x_m < 0.8; x_m += kStrip_m) {
      const double flow_mps = v + x_m * r;
      cross_flow_nm -= x_m * 0.5 * 1026 * 0.19 * 1.19773 * std::abs(flow_mps) * flow_mps * kStrip_m;
    }
    EXPECT_NEAR((rudder_nm + cross_flow_nm) / (7.4526 / 1.0 * r), 1, 0.03)
        << rudder_rad << " rad, " << r << " rad/s, " << v << " m/s";
  }
}

TEST(FreeDecay, OfYawHasTheTimeConstantOfItsDamping) {
  for (const char* set : kSets) {
    const Remus100 auv = AuvOf(set);
    const double time_s = std::string(set) == "munet" ? 5 : 1;
    Remus100State state = Deep();
    state.nu[5] = 0.002;
    state = Sail(auv, state, {}, time_s, 0.001);
    EXPECT_NEAR(state.nu[5] / 0.002, std::exp(-1.0), 0.01) << set;
  }
}

// theta'' + 2 zeta w theta' + w^2 theta = 0 from rest.
TEST(FreeDecay, OfPitchHasItsFrequencyAndDamping) {
  constexpr double kFrequency_radps = 0.9030;
  constexpr double kRatio = 0.8;
  const double damped_radps = kFrequency_radps * std::sqrt(1 - kRatio * kRatio);
  for (const char* set : kSets) {
    const Remus100 auv = AuvOf(set);
    Remus100State state = Deep();
    state.eta[4] = 0.05;
    for (int second = 1; second <= 6; ++second) {
      state = Sail(auv, state, {}, 1, 0.001);
      const double phase = damped_radps * second;
      const double expected =
          std::exp(-kRatio * kFrequency_radps * second) *
          (std::cos(phase) + kRatio / std::sqrt(1 - kRatio * kRatio) * std::sin(phase));
      EXPECT_NEAR(state.eta[4] / 0.05, expected, 0.02) << set << " after " << second << " s";
    }
  }
}

}  // namespace shoal::remus100_balance_test
