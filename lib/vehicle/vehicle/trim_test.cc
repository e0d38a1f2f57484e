#include "lib/vehicle/vehicle/trim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal::trim_test {

constexpr double kStep_s = 0.02;

Remus100 WithBuoyancy(double buoyancy_by_weight) {
  Remus100Params params;
  params.buoyancy_by_weight = buoyancy_by_weight;
  return BuildRemus100(params);
}

TEST(FloatingDepth, PutsANeutralHullJustUnderWater) {
  EXPECT_NEAR(FloatingDepth(WithBuoyancy(1)), 0.095, 1e-6);
  EXPECT_NEAR(FloatingDepth(WithBuoyancy(0.97)), 0.095, 1e-6);
}

TEST(FloatingDepth, IsWhereALightHullComesToRest) {
  const Remus100 auv = WithBuoyancy(1.05);
  Remus100State state;
  state.eta[2] = 0.3;
  for (int i = 0; i < 20'000; ++i) state = Step(auv, state, {}, {}, kStep_s);
  EXPECT_NEAR(state.eta[2], FloatingDepth(auv), 0.01);
  EXPECT_LT(FloatingDepth(auv), 0.095);
}

TEST(FloatingDepth, IsZeroWhereTheSetHasAnotherSurface) {
  EXPECT_EQ(FloatingDepth(BuildRemus100(MunetRemus100())), 0);
  EXPECT_EQ(FloatingDepth(BuildRemus100(FossenRemus100())), 0);
}

TEST(SteepestPitch, IsHeldByTheModelWithFullFins) {
  const Remus100 auv = BuildRemus100({});
  for (const double rpm : {500.0, 700.0}) {
    Remus100State state;
    state.eta[2] = 500;
    for (int i = 0; i < 6000; ++i) {
      state = Step(auv, state, {.stern_plane_rad = -auv.params.max_fin_rad, .propeller_rpm = rpm},
                   {}, kStep_s);
    }
    const double speed_mps = state.nu.head<3>().norm();
    EXPECT_NEAR(RadToDeg(state.eta[4]), RadToDeg(SteepestPitch(auv, speed_mps)), 1.5) << rpm;
  }
}

TEST(SteepestPitch, GrowsToTheVertical) {
  const Remus100 auv = BuildRemus100({});
  EXPECT_EQ(SteepestPitch(auv, 0), 0);
  EXPECT_NEAR(RadToDeg(SteepestPitch(auv, 2)), 40, 2);
  EXPECT_EQ(SteepestPitch(auv, 10), kPi / 2);
}

TEST(LevelTrim, IsThePitchAtWhichALightHullKeepsItsDepth) {
  for (const double buoyancy_by_weight : {0.99, 1.005, 1.01}) {
    const Remus100 auv = WithBuoyancy(buoyancy_by_weight);
    const LevelTrim trim = LevelTrimOf(auv);
    for (const double speed_mps : {1.0, 1.5, 2.4}) {
      const double pitch_rad = PitchOf(trim, speed_mps);
      EXPECT_LT(pitch_rad * (buoyancy_by_weight - 1), 0) << "bow down where it is light";
      // Held at that pitch, by a strong law, it goes on a level.
      Remus100State state;
      state.eta[2] = 50;
      state.eta[4] = pitch_rad;
      state.nu[0] = speed_mps;
      const double rpm = RpmForSpeed(auv, speed_mps);
      state.actuators.propeller_rpm = rpm;
      double integral = 0;
      for (int i = 0; i < 3000; ++i) {
        const double error_rad = state.eta[4] - pitch_rad;
        integral += error_rad * kStep_s;
        const double plane_rad = error_rad + 0.5 * integral + 0.3 * state.nu[4];
        state = Step(auv, state, {.stern_plane_rad = plane_rad, .propeller_rpm = rpm}, {}, kStep_s);
      }
      EXPECT_NEAR(state.velocity_mps.z() / speed_mps, 0, 0.15 * std::abs(pitch_rad)) << speed_mps;
    }
  }
}

TEST(LevelTrim, IsNothingForANeutralHull) {
  EXPECT_EQ(PitchOf(LevelTrimOf(WithBuoyancy(1)), 1.5), 0);
}

}  // namespace shoal::trim_test
