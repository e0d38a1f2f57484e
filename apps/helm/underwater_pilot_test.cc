#include "apps/helm/underwater_pilot.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal::underwater_pilot_test {

constexpr double kTick_s = 0.1;

nav_t NavAt(double heading_deg, double z_m) {
  nav_t nav{};
  nav.heading_deg = heading_deg;
  nav.z_m = z_m;
  nav.altitude_m = -1;
  nav.speed_mps = 2;
  return nav;
}

Guidance ToHeadingAndDepth(double heading_deg, double z_m) {
  Guidance guidance;
  guidance.heading_rad = DegToRad(heading_deg);
  guidance.speed_mps = 2;
  guidance.z_m = z_m;
  return guidance;
}

/// A pilot and what it published last.
class Steered {
 public:
  explicit Steered(const Remus100Options& options) : pilot_(options) {}

  void Steer(const Guidance& guidance, const nav_t& nav, double dt_s = kTick_s) {
    pilot_.Steer(guidance, nav, dt_s, &desired, &actuators);
  }
  void Steer(const Guidance& guidance, const nav_t& nav, int num_ticks) {
    for (int i = 0; i < num_ticks; ++i) Steer(guidance, nav);
  }
  void Rest(const nav_t& nav) { pilot_.Rest(nav, &desired, &actuators); }
  std::string Gains() const { return pilot_.GainsText(); }

  desired_t desired{};
  actuators_t actuators{};

 private:
  UnderwaterPilot pilot_;
};

class EveryPilot : public testing::TestWithParam<const char*> {
 protected:
  EveryPilot() : steered_({.parameters = GetParam()}) {}
  Steered steered_;
};

INSTANTIATE_TEST_SUITE_P(Remus100, EveryPilot, testing::Values("default", "munet", "fossen"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(EveryPilot, GivesRudderTowardTheHeadingAskedForByTheShorterWay) {
  steered_.Steer(ToHeadingAndDepth(20, 30), NavAt(350, 30), 20);
  EXPECT_GT(steered_.actuators.rudder_deg, 1);
  EXPECT_NEAR(steered_.desired.heading_deg, 20, 1e-9);
  steered_.Rest(NavAt(350, 30));
  steered_.Steer(ToHeadingAndDepth(320, 30), NavAt(350, 30), 20);
  EXPECT_LT(steered_.actuators.rudder_deg, -1);
}

TEST_P(EveryPilot, LowersItsBowToGoDeeperAndRaisesItToComeUp) {
  steered_.Steer(ToHeadingAndDepth(0, 60), NavAt(0, 30), 50);
  EXPECT_LT(steered_.actuators.stern_plane_deg, -0.1);
  EXPECT_GT(steered_.desired.depth_m, 30);
  steered_.Rest(NavAt(0, 30));
  steered_.Steer(ToHeadingAndDepth(0, 10), NavAt(0, 30), 50);
  EXPECT_GT(steered_.actuators.stern_plane_deg, 0.1);
  EXPECT_LT(steered_.desired.depth_m, 30);
}

TEST_P(EveryPilot, RaisesItsBowToTheDesiredPitchAtAnyDepth) {
  Guidance guidance = ToHeadingAndDepth(0, 90);
  guidance.pitch_rad = DegToRad(10);
  steered_.Steer(guidance, NavAt(0, 30), 5);
  EXPECT_GT(steered_.actuators.stern_plane_deg, 0.1);
  EXPECT_LT(steered_.desired.depth_m, 30) << "it is to rise";
  guidance.pitch_rad = DegToRad(-10);
  steered_.Steer(guidance, NavAt(0, 30), 50);
  EXPECT_LT(steered_.actuators.stern_plane_deg, -0.1);
}

TEST_P(EveryPilot, BrakesATurnThatIsFastEnough) {
  nav_t nav = NavAt(0, 30);
  steered_.Steer(ToHeadingAndDepth(0, 30), nav, 5);
  EXPECT_NEAR(steered_.actuators.rudder_deg, 0, 0.01) << "muNet's looks a step ahead";
  nav.yaw_rate_degps = 5;
  steered_.Steer(ToHeadingAndDepth(0, 30), nav);
  EXPECT_LT(steered_.actuators.rudder_deg, -0.1);
  nav.yaw_rate_degps = 0;
  nav.pitch_rate_degps = 5;
  steered_.Steer(ToHeadingAndDepth(0, 30), nav);
  EXPECT_LT(steered_.actuators.stern_plane_deg, -0.1);
}

TEST_P(EveryPilot, NamesItsVehicle) {
  EXPECT_EQ(steered_.Gains(), std::string("Autopilot of the ") + GetParam() +
                                  " Remus 100; at most 100 m deep, 5 m above the floor");
}

TEST(UnderwaterPilot, SteersByTheGainsOfTheMission) {
  Remus100Gains gains = Remus100GainsNamed("default");
  gains.heading_kp = 2;
  gains.heading_ki = 0;
  gains.heading_kd = 0.5;
  gains.pitch_kp = 3;
  gains.pitch_ki = 0;
  gains.pitch_kd = 0.2;
  gains.heave_kd = 0.4;
  for (const char* parameters : {"default", "fossen"}) {
    Steered steered({.parameters = parameters, .buoyancy_by_weight = 1, .autopilot = gains});
    nav_t nav = NavAt(0, 30);
    nav.yaw_rate_degps = 2;
    nav.pitch_rate_degps = 1;
    nav.heave_mps = 0.01;
    Guidance guidance = ToHeadingAndDepth(3, 30);
    guidance.pitch_rad = DegToRad(2);
    steered.Steer(guidance, nav);
    EXPECT_NEAR(steered.actuators.rudder_deg, 2 * 3 - 0.5 * 2, 1e-9) << parameters;
    EXPECT_NEAR(steered.actuators.stern_plane_deg, 3 * 2 - 0.2 * 1 - RadToDeg(0.4 * 0.01), 1e-9)
        << parameters;
  }
}

TEST(UnderwaterPilot, TakesTheSetOfGainsThatSuitsItsParametersOrTheOneThatIsNamed) {
  const auto rudder_deg = [](const Remus100Options& options) {
    Steered steered(options);
    steered.Steer(ToHeadingAndDepth(1, 30), NavAt(0, 30), 1);
    return steered.actuators.rudder_deg;
  };
  const double by_default = rudder_deg({});
  EXPECT_EQ(rudder_deg({.autopilot = Remus100GainsNamed("default")}), by_default);
  EXPECT_EQ(rudder_deg({.parameters = "fossen"}), by_default);
  EXPECT_NEAR(rudder_deg({.autopilot = Remus100GainsNamed("fossen")}), 1.64 * by_default, 1e-9);
  EXPECT_NEAR(rudder_deg({.parameters = "munet"}), 7.5 * by_default, 1e-3);
  EXPECT_EQ(rudder_deg({.parameters = "munet", .autopilot = Remus100GainsNamed("default")}),
            by_default);
}

TEST(UnderwaterPilot, TurnsThePropellerAsTheSpeedTakes) {
  Steered steered({});
  steered.Steer(ToHeadingAndDepth(0, 30), NavAt(0, 30));
  EXPECT_DOUBLE_EQ(steered.actuators.propeller_rpm, RpmForSpeed(BuildRemus100({}), 2));
  EXPECT_DOUBLE_EQ(steered.actuators.thrust_pct, 100 * steered.actuators.propeller_rpm / 1525);
  EXPECT_EQ(steered.desired.speed_mps, 2);
  Steered munet({.parameters = "munet"});
  munet.Steer(ToHeadingAndDepth(0, 30), NavAt(0, 30));
  EXPECT_DOUBLE_EQ(munet.actuators.propeller_rpm, MunetRpmFromSpeed(2));
}

TEST(UnderwaterPilot, TurnsThePropellerAsCommandedAtAnySpeed) {
  Steered steered({});
  Guidance guidance = ToHeadingAndDepth(0, 30);
  guidance.propeller_rpm = 900;
  steered.Steer(guidance, NavAt(0, 30));
  EXPECT_EQ(steered.actuators.propeller_rpm, 900);
}

TEST(UnderwaterPilot, CommandsThePropellerWithinItsLimits) {
  Steered steered({});
  Guidance guidance = ToHeadingAndDepth(0, 30);
  guidance.speed_mps = 50;
  steered.Steer(guidance, NavAt(0, 30));
  EXPECT_EQ(steered.actuators.propeller_rpm, 1525);
  EXPECT_EQ(steered.actuators.thrust_pct, 100);
}

TEST(UnderwaterPilot, StopsThePropellerAtSpeedZero) {
  Steered steered({});
  Guidance guidance = ToHeadingAndDepth(0, 30);
  steered.Steer(guidance, NavAt(0, 30));
  guidance.speed_mps = 0;
  steered.Steer(guidance, NavAt(0, 30));
  EXPECT_EQ(steered.actuators.propeller_rpm, 0);
}

TEST(UnderwaterPilot, RampsThePropellerWhereARateIsSetAndFromZeroAfterARest) {
  Steered steered({.max_propeller_rate_rpmps = 100});
  const Guidance guidance = ToHeadingAndDepth(0, 30);
  steered.Steer(guidance, NavAt(0, 30), 3);
  EXPECT_NEAR(steered.actuators.propeller_rpm, 30, 1e-9);
  steered.Rest(NavAt(0, 30));
  EXPECT_EQ(steered.actuators.propeller_rpm, 0);
  steered.Steer(guidance, NavAt(0, 30));
  EXPECT_NEAR(steered.actuators.propeller_rpm, 10, 1e-9);
}

TEST(UnderwaterPilot, StaysAboveItsGreatestDepthAndClearOfTheFloor) {
  Steered steered({.max_depth_m = 40, .seabed_clearance_m = 6, .depth_filter_s = 0});
  steered.Steer(ToHeadingAndDepth(0, 90), NavAt(0, 30), 40);
  EXPECT_NEAR(steered.desired.depth_m, 40, 1e-9);
  nav_t nav = NavAt(0, 30);
  nav.altitude_m = 10;
  steered.Steer(ToHeadingAndDepth(0, 90), nav, 40);
  EXPECT_NEAR(steered.desired.depth_m, 34, 1e-9);
  nav.altitude_m = 2;
  steered.Steer(ToHeadingAndDepth(0, 90), nav, 300);
  EXPECT_NEAR(steered.desired.depth_m, 26, 1e-6);
}

TEST(UnderwaterPilot, GoesToItsCruiseDepthWhereATaskHasNone) {
  Steered steered({.cruise_depth_m = 15, .depth_filter_s = 0});
  Guidance guidance = ToHeadingAndDepth(0, 30);
  guidance.z_m.reset();
  steered.Steer(guidance, NavAt(0, 30), 40);
  EXPECT_NEAR(steered.desired.depth_m, 15, 1e-9);
}

TEST(UnderwaterPilot, TakesTheTimeOfItsFilterToAskForANewDepth) {
  Steered steered({.depth_filter_s = 2});
  steered.Steer(ToHeadingAndDepth(0, 40), NavAt(0, 30), 20);
  EXPECT_NEAR(steered.desired.depth_m, 40 - 10 * std::exp(-1), 1e-9);
}

TEST(UnderwaterPilot, HoldsALightHullDownAtOnce) {
  Steered steered({});
  steered.Steer(ToHeadingAndDepth(0, 30), NavAt(0, 30));
  EXPECT_LT(steered.actuators.stern_plane_deg, -0.1) << "the bow goes down";
}

TEST(UnderwaterPilot, BeginsAgainWhereTheVehicleIsAfterARest) {
  Steered steered({.buoyancy_by_weight = 1});
  steered.Steer(ToHeadingAndDepth(90, 60), NavAt(0, 30), 100);
  steered.Rest(NavAt(200, 5));
  EXPECT_EQ(steered.actuators.rudder_deg, 0);
  EXPECT_EQ(steered.actuators.stern_plane_deg, 0);
  EXPECT_EQ(steered.actuators.thrust_pct, 0);
  EXPECT_EQ(steered.desired.heading_deg, 200);
  EXPECT_EQ(steered.desired.depth_m, 5);
  EXPECT_EQ(steered.desired.speed_mps, 0);
  steered.Steer(ToHeadingAndDepth(200, 5), NavAt(200, 5));
  EXPECT_NEAR(steered.desired.depth_m, 5, 1e-9);
  EXPECT_NEAR(steered.actuators.rudder_deg, 0, 1e-9);
  EXPECT_NEAR(steered.actuators.stern_plane_deg, 0, 1e-9);
}

TEST(UnderwaterPilot, CentresItsFinsWithoutWaterAndBeginsAnewOnceThereIsSome) {
  Steered steered({});
  nav_t nav = NavAt(0, 30);
  nav.speed_mps = 0.2;
  steered.Steer(ToHeadingAndDepth(90, 60), nav, 1000);
  EXPECT_EQ(steered.actuators.rudder_deg, 0);
  EXPECT_EQ(steered.actuators.stern_plane_deg, 0);
  EXPECT_GT(steered.actuators.propeller_rpm, 0);
  EXPECT_EQ(steered.desired.depth_m, 30);
  nav.speed_mps = 2;
  Steered fresh({});
  steered.Steer(ToHeadingAndDepth(90, 60), nav, 10);
  fresh.Steer(ToHeadingAndDepth(90, 60), nav, 10);
  EXPECT_EQ(steered.actuators.rudder_deg, fresh.actuators.rudder_deg);
  EXPECT_EQ(steered.actuators.stern_plane_deg, fresh.actuators.stern_plane_deg);
}

TEST(UnderwaterPilot, HoldsItsIntegralsWhileThePropellerStandsStill) {
  Steered steered({.depth_filter_s = 0});
  Guidance glide = ToHeadingAndDepth(0, 31);
  glide.speed_mps = 0;
  steered.Steer(glide, NavAt(5, 30), 400);
  const double rudder_deg = steered.actuators.rudder_deg;
  const double stern_plane_deg = steered.actuators.stern_plane_deg;
  EXPECT_LT(rudder_deg, 0);
  EXPECT_LT(stern_plane_deg, 0);
  steered.Steer(glide, NavAt(5, 30), 1000);
  EXPECT_NEAR(steered.actuators.rudder_deg, rudder_deg, 1e-6);
  EXPECT_NEAR(steered.actuators.stern_plane_deg, stern_plane_deg, 1e-6);
}

TEST(UnderwaterPilot, SteersAsMunetAtAnySpeedWithItsParameters) {
  Steered steered({.parameters = "munet"});
  nav_t nav = NavAt(0, 30);
  nav.speed_mps = 0;
  steered.Steer(ToHeadingAndDepth(90, 60), nav, 20);
  EXPECT_GT(steered.actuators.rudder_deg, 1);
}

TEST(UnderwaterPilot, SteersNoHigherThanItsHullFloats) {
  Steered steered({.depth_filter_s = 0, .buoyancy_by_weight = 1});
  steered.Steer(ToHeadingAndDepth(0, 0), NavAt(0, 1), 40);
  EXPECT_NEAR(steered.desired.depth_m, 0.095 + 0.19 / 4, 1e-6);
  Steered fossen({.parameters = "fossen", .depth_filter_s = 0});
  fossen.Steer(ToHeadingAndDepth(0, 0), NavAt(0, 1), 40);
  EXPECT_NEAR(fossen.desired.depth_m, 0, 1e-6);
}

TEST(UnderwaterPilot, GivesNothingInItsFirstStepButPublishesWhatIsDesired) {
  Steered steered({});
  steered.Steer(ToHeadingAndDepth(45, 60), NavAt(0, 30), 0.0);
  EXPECT_EQ(steered.actuators.propeller_rpm, 0);
  EXPECT_EQ(steered.actuators.rudder_deg, 0);
  EXPECT_NEAR(steered.desired.heading_deg, 45, 1e-9);
}

TEST(UnderwaterPilot, BeginsADepthWhereItIsAfterAPitch) {
  Steered steered({});
  Guidance pitch = ToHeadingAndDepth(90, 0);
  pitch.pitch_rad = DegToRad(10);
  steered.Steer(ToHeadingAndDepth(0, 30), NavAt(0, 30), 5);
  steered.Steer(pitch, NavAt(90, 10), 50);
  steered.Steer(ToHeadingAndDepth(90, 10), NavAt(90, 10));
  EXPECT_NEAR(steered.desired.depth_m, 10, 0.3);
  EXPECT_NEAR(steered.actuators.rudder_deg, 0, 0.5);
}

RC_GTEST_PROP(UnderwaterPilot, PublishesFiniteNumbersWithinTheFinLimitsForAnyInput, ()) {
  Steered steered({.parameters = *rc::gen::element<std::string>("default", "munet", "fossen"),
                   .depth_filter_s = *rc::gen::element(0.0, 20.0),
                   .max_propeller_rate_rpmps = *rc::gen::element(0.0, 50.0)});
  const double max_fin_deg = 30.001;
  for (int i = 0; i < 20; ++i) {
    nav_t nav =
        NavAt(*rc::gen::element(0.0, -1e300, 720.0, 1e9), *rc::gen::element(0.0, -1e6, 1e6));
    nav.pitch_deg = *rc::gen::element(0.0, 90.0, -1e300, 1e300);
    nav.speed_mps = *rc::gen::element(0.0, -0.1, 2.0, 1e300);
    nav.speed_over_ground_mps =
        *rc::gen::element(0.0, 2.0, 1e300, std::numeric_limits<double>::infinity());
    nav.yaw_rate_degps = *rc::gen::element(0.0, 1e300, -1e300, 3.0);
    nav.pitch_rate_degps = *rc::gen::element(0.0, 1e300, -1e300, 3.0);
    nav.altitude_m = *rc::gen::element(0.0, -1.0, 1e300, std::numeric_limits<double>::infinity());
    Guidance guidance = ToHeadingAndDepth(*rc::gen::element(0.0, 359.0), 1e4);
    guidance.speed_mps = *rc::gen::element(0.0, 1.0, 1000.0);
    if (*rc::gen::arbitrary<bool>()) guidance.pitch_rad = *rc::gen::element(-1.57, 0.0, 1.57);
    steered.Steer(guidance, nav, *rc::gen::element(0.0, 1e-6, 0.1, 1.0));
    const actuators_t& published = steered.actuators;
    RC_ASSERT(std::abs(published.rudder_deg) <= max_fin_deg);
    RC_ASSERT(std::abs(published.stern_plane_deg) <= max_fin_deg);
    RC_ASSERT(std::abs(published.propeller_rpm) <= 1525);
    RC_ASSERT(std::isfinite(published.thrust_pct));
    RC_ASSERT(std::isfinite(steered.desired.depth_m));
    RC_ASSERT(std::isfinite(steered.desired.heading_deg));
  }
}

TEST(UnderwaterPilot, WantsTheDepthToWhichACommandedPitchLeadsWithinTenSeconds) {
  Steered steered({});
  Guidance guidance = ToHeadingAndDepth(0, 0);
  guidance.z_m.reset();
  guidance.pitch_rad = DegToRad(-10);
  steered.Steer(guidance, NavAt(0, 20));
  EXPECT_NEAR(steered.desired.depth_m, 20 + 10 * 2 * std::sin(DegToRad(10)), 1e-9);
  guidance.pitch_rad = DegToRad(45);
  steered.Steer(guidance, NavAt(0, 5));
  EXPECT_EQ(steered.desired.depth_m, 0) << "not above the surface";
}

}  // namespace shoal::underwater_pilot_test
