// The sway of a turning Remus 100, as a filter predicts it from the gyro alone.
#include "lib/vehicle/vehicle/sway_in_turns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal::sway_in_turns_test {

/// Turns one way and the other for two minutes. Returns the largest sway, and the largest that is
/// not predicted.
std::pair<double, double> MostSway(const Remus100& auv, double speed_mps) {
  const SwayInTurns hull = SwayInTurnsOf(auv);
  const double rpm = RpmForSpeed(auv, speed_mps);
  Remus100State state;
  state.eta[2] = 20;
  state.nu[0] = speed_mps;
  state.actuators.propeller_rpm = rpm;
  double predicted_mps = 0;
  std::pair<double, double> most{0, 0};
  for (int i = 0; i < 1200; ++i) {
    const double rudder_rad = (i / 300 % 2 == 0 ? 0.8 : -0.4) * auv.params.max_fin_rad;
    state = Step(auv, state, {.rudder_rad = rudder_rad, .propeller_rpm = rpm}, {}, 0.1);
    predicted_mps = NextSway(hull, predicted_mps, state.nu[0], state.nu[5], 0.1);
    most.first = std::max(most.first, std::abs(state.nu[1]));
    most.second = std::max(most.second, std::abs(state.nu[1] - predicted_mps));
  }
  return most;
}

TEST(SwayInTurns, IsForetoldToAThirdOfItAtEverySpeedOfEverySet) {
  for (const char* parameters : {"default", "munet", "fossen"}) {
    const Remus100 auv = BuildRemus100(*Remus100ParamsByName(parameters));
    for (const double speed_mps : {1.0, 1.5, 2.0, 2.4}) {
      const auto [most_mps, missed_mps] = MostSway(auv, speed_mps);
      EXPECT_GT(most_mps, 0.08) << parameters;
      EXPECT_LT(missed_mps, most_mps / 3) << parameters << " at " << speed_mps << " m/s";
    }
  }
}

TEST(SwayInTurns, IsNothingForAHullThatDoesNotSlide) {
  EXPECT_EQ(NextSway({}, 0.2, 1.5, 0.1, 0.1), 0);
}

TEST(SwayInTurns, GoesOutwardAndSettles) {
  const SwayInTurns hull = {.lever_m = 2, .length_m = 3};
  double sway_mps = 0;
  for (int i = 0; i < 300; ++i) sway_mps = NextSway(hull, sway_mps, 1.5, 0.1, 0.1);
  EXPECT_NEAR(sway_mps, -0.2, 1e-6) << "it turns to starboard and slides to port";
}

}  // namespace shoal::sway_in_turns_test
