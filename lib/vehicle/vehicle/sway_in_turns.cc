#include "lib/vehicle/vehicle/sway_in_turns.h"

#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {

SwayInTurns SwayInTurnsOf(const Remus100& auv) {
  constexpr double kSpeed_mps = 1.5;
  constexpr double kStep_s = 0.05;
  constexpr int kSteps = 1200;  // A minute: half a circle at least.
  const Remus100Actuators command = {.rudder_rad = auv.params.max_fin_rad / 2,
                                     .propeller_rpm = RpmForSpeed(auv, kSpeed_mps)};
  Remus100State state;
  state.eta[2] = 20;
  state.nu[0] = kSpeed_mps;
  state.actuators.propeller_rpm = command.propeller_rpm;
  double sway_m = 0;
  double turn_rad = 0;
  for (int i = 0; i < kSteps; ++i) {
    state = Step(auv, state, command, {}, kStep_s);
    sway_m += state.nu[1] * kStep_s;
    turn_rad += state.nu[5] * kStep_s;
  }
  // From T dv/dt = -(v + lever r), whose integral is T (v - 0).
  const double lever_m = -state.nu[1] / state.nu[5];
  const double time_s = -(sway_m + lever_m * turn_rad) / state.nu[1];
  return {.lever_m = std::max(0.0, lever_m), .length_m = std::max(0.1, time_s * state.nu[0])};
}

}  // namespace shoal
