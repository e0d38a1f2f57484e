// muNet's gains of heading in the loop of a mission, in which a command takes effect a step after
// the NAV that it was decided from. docs/vehicles/vehicles.md has the numbers for every tick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "apps/helm/remus100_testing.h"
#include "apps/helm/underwater_pilot.h"

namespace shoal::munet_gains_test {

/// Returns by how much the commanded rudder swings, in degrees to either side, from the 100th to
/// the 120th second after a turn.
double RudderSwing_deg(const Remus100Options& options, double rpm, double tick_s) {
  const Remus100 auv = BuildRemus100(*Remus100ParamsByName(options.parameters));
  UnderwaterPilot pilot(options);
  Remus100State state;
  state.eta[2] = 30;
  state.nu[0] = 2;
  Guidance guidance;
  guidance.speed_mps = 2;
  guidance.propeller_rpm = rpm;
  guidance.z_m = 30;
  actuators_t before{};
  double least_deg = 90;
  double most_deg = -90;
  const auto num_ticks = static_cast<int>(120 / tick_s);
  for (int i = 0; i < num_ticks; ++i) {
    guidance.heading_rad = DegToRad(i * tick_s < 5 ? 90 : 30);
    actuators_t command{};
    desired_t desired{};
    pilot.Steer(guidance, NavOf(state), tick_s, &desired, &command);
    const double plane_sign = options.parameters == "munet" ? 1 : -1;
    const Remus100Actuators executed = {-DegToRad(before.rudder_deg),
                                        plane_sign * DegToRad(before.stern_plane_deg),
                                        before.propeller_rpm};
    const double num_steps = std::ceil(tick_s / options.model_step_s - 1e-9);
    for (int k = 0; k < static_cast<int>(num_steps); ++k) {
      state = Step(auv, state, executed, {}, tick_s / num_steps);
    }
    before = command;
    if (i * tick_s < 100) continue;
    least_deg = std::min(least_deg, command.rudder_deg);
    most_deg = std::max(most_deg, command.rudder_deg);
  }
  return (most_deg - least_deg) / 2;
}

TEST(MunetsGains, HoldTheRudderStillAtMunetsStepInSpiteOfTheDelayBetweenProcesses) {
  const Remus100Options munet = {.parameters = "munet"};
  EXPECT_LT(RudderSwing_deg(munet, 1200, 0.02), 0.1);
  EXPECT_LT(RudderSwing_deg(munet, 1525, 0.02), 0.5);
  EXPECT_LT(RudderSwing_deg(munet, 1200, 0.05), 2);
}

TEST(MunetsGains, SwingTheRudderFromStopToStopAtLongerTicksWhereWeakerOnesDoNot) {
  Remus100Options munet = {.parameters = "munet"};
  EXPECT_GT(RudderSwing_deg(munet, 1200, 0.1), 29);
  munet.autopilot = Remus100GainsNamed("munet");
  munet.autopilot->heading_kp = 2;
  munet.autopilot->heading_ki = 0.1;
  munet.autopilot->heading_kd = 4;
  EXPECT_LT(RudderSwing_deg(munet, 1200, 0.1), 0.1);
  EXPECT_LT(RudderSwing_deg(munet, 1525, 0.1), 0.1);
}

}  // namespace shoal::munet_gains_test
