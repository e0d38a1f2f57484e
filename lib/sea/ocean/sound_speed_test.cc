#include "lib/sea/ocean/sound_speed.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace shoal::sound_speed_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double SpeedAt(double temperature_degc, double salinity_ppt, double depth_m) {
  return SoundSpeed({.temperature_degc = temperature_degc,
                     .salinity_ppt = salinity_ppt,
                     .depth_m = depth_m})
      .value_or(0);
}

TEST(SoundSpeed, HasMackenziesCheckValue) {
  // The check value that goes with the equation, for example in Wikipedia's article on the speed of
  // sound: 25 degC, 35 ppt, 1000 m.
  EXPECT_NEAR(SpeedAt(25, 35, 1000), 1550.744, 0.0005);
}

TEST(SoundSpeed, HasPublishedTableValues) {
  // SonarDocs, "Sound speed in sea. Mackenzie equation", table for 30 ppt, two decimals.
  EXPECT_NEAR(SpeedAt(0, 30, 10), 1442.42, 0.005);
  EXPECT_NEAR(SpeedAt(10, 30, 10), 1483.78, 0.005);
  EXPECT_NEAR(SpeedAt(20, 30, 10), 1515.95, 0.005);
  EXPECT_NEAR(SpeedAt(30, 30, 10), 1540.36, 0.005);
  EXPECT_NEAR(SpeedAt(0, 30, 1000), 1458.73, 0.005);
  EXPECT_NEAR(SpeedAt(20, 30, 2000), 1548.94, 0.005);
  EXPECT_NEAR(SpeedAt(0, 30, 5000), 1527.95, 0.005);
  EXPECT_NEAR(SpeedAt(30, 30, 5000), 1623.21, 0.005);
}

TEST(SoundSpeed, IsThereOnTheLimitsOfValidity) {
  EXPECT_GT(SpeedAt(-2, 25, 0), 1400);
  EXPECT_GT(SpeedAt(30, 40, 8000), 1600);
}

TEST(SoundSpeed, IsNotThereOutsideItsValidity) {
  EXPECT_FALSE(SoundSpeed({.temperature_degc = -2.01}).has_value());
  EXPECT_FALSE(SoundSpeed({.temperature_degc = 30.01}).has_value());
  EXPECT_FALSE(SoundSpeed({.salinity_ppt = 24.99}).has_value());
  EXPECT_FALSE(SoundSpeed({.salinity_ppt = 40.01}).has_value());
  EXPECT_FALSE(SoundSpeed({.depth_m = -0.01}).has_value());
  EXPECT_FALSE(SoundSpeed({.depth_m = 8000.01}).has_value());
  for (const double nonsense : {kNaN, kInfinity, -kInfinity}) {
    EXPECT_FALSE(SoundSpeed({.temperature_degc = nonsense}).has_value());
    EXPECT_FALSE(SoundSpeed({.salinity_ppt = nonsense}).has_value());
    EXPECT_FALSE(SoundSpeed({.depth_m = nonsense}).has_value());
    EXPECT_FALSE(SoundSpeed({.ph = nonsense}).has_value());
  }
}

TEST(SeaWater, MayBeFresh) { EXPECT_TRUE(IsSeaWater({.salinity_ppt = 0})); }

RC_GTEST_PROP(SoundSpeed, RisesWithTemperatureSalinityAndDepth, ()) {
  const double t = *rc::gen::inRange(-20, 280) / 10.0;
  const double s = *rc::gen::inRange(250, 390) / 10.0;
  const double d = *rc::gen::inRange(0, 6000);
  RC_ASSERT(SpeedAt(t + 1, s, d) > SpeedAt(t, s, d));
  RC_ASSERT(SpeedAt(t, s + 1, d) > SpeedAt(t, s, d));
  RC_ASSERT(SpeedAt(t, s, d + 100) > SpeedAt(t, s, d));
}

}  // namespace shoal::sound_speed_test
