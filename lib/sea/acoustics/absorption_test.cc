#include "lib/sea/acoustics/absorption.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace shoal::absorption_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Ainslie, M. A. and McColm, J. G. (1998), A simplified formula for viscous and chemical
/// absorption in sea water, J. Acoust. Soc. Am. 103(3), 1671-1672: another fit to the same
/// measurements, in dB/km.
double AinslieMcColm(double f, const SeaWater& water) {
  const double t = water.temperature_degc;
  const double s = water.salinity_ppt;
  const double z_km = water.depth_m / 1000;
  const double f1 = 0.78 * std::sqrt(s / 35) * std::exp(t / 26);
  const double f2 = 42 * std::exp(t / 17);
  return 0.106 * f1 * f * f / (f1 * f1 + f * f) * std::exp((water.ph - 8) / 0.56) +
         0.52 * (1 + t / 43) * (s / 35) * f2 * f * f / (f2 * f2 + f * f) * std::exp(-z_km / 6) +
         0.00049 * f * f * std::exp(-(t / 27 + z_km / 17));
}

TEST(ThorpAbsorption, HasTheValuesOfItsFormula) {
  // By hand, term by term: 0.055 + 0.010729 + 0.000275 + 0.003 and so on.
  EXPECT_NEAR(ThorpAbsorption(1), 0.069004, 1e-6);
  EXPECT_NEAR(ThorpAbsorption(10), 1.187030, 1e-6);
  EXPECT_NEAR(ThorpAbsorption(50), 17.467123, 1e-6);
}

TEST(ThorpAbsorption, IsWhatThorpPublishedInKiloyards) {
  // Thorp (1967): 0.1 f^2/(1+f^2) + 40 f^2/(4100+f^2) dB per kiloyard; 1 km is 1.0936 kyd. What
  // the modern form adds is between 1 and 9 % from 1 to 50 kHz.
  for (const double f : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    const double published = 1.0936 * (0.1 * f * f / (1 + f * f) + 40 * f * f / (4100 + f * f));
    EXPECT_NEAR(ThorpAbsorption(f) / published, 1.05, 0.04) << f;
  }
}

TEST(ThorpAbsorption, IsNearJensensForm) {
  // Jensen et al., Computational Ocean Acoustics, 2nd ed. (2011), eq. (1.47); also the one of USML.
  for (const double f : {0.1, 1.0, 5.0, 10.0, 50.0}) {
    const double jensen =
        3.3e-3 + 0.11 * f * f / (1 + f * f) + 44 * f * f / (4100 + f * f) + 3.0e-4 * f * f;
    EXPECT_NEAR(ThorpAbsorption(f) / jensen, 1, 0.08) << f;
  }
}

TEST(FrancoisGarrisonAbsorption, HasLurtonsValuesForTheMediterranean) {
  // Lurton, An Introduction to Underwater Acoustics, 2nd ed. (2010), section 2.3: 100 kHz, 14 degC,
  // 38.5 ppt, at the surface, 2000 m and 6000 m; the tests of UnderwaterAcoustics.jl check the same
  // numbers to 0.5 dB/km.
  SeaWater water = {.temperature_degc = 14, .salinity_ppt = 38.5, .depth_m = 0, .ph = 8.1};
  EXPECT_NEAR(FrancoisGarrisonAbsorption(100, water), 40, 0.5);
  water.depth_m = 2000;
  EXPECT_NEAR(FrancoisGarrisonAbsorption(100, water), 30, 0.5);
  water.depth_m = 6000;
  EXPECT_NEAR(FrancoisGarrisonAbsorption(100, water), 16, 0.5);
}

TEST(FrancoisGarrisonAbsorption, HasTheValueThatTheSonarPackageOfCranDocuments) {
  // 50 kHz, 0 degC, 35 ppt, surface, pH 6: 13.96602 dB/km, with 0 degC at 273.15 K instead of the
  // paper's 273, which is 0.15 % of it.
  EXPECT_NEAR(FrancoisGarrisonAbsorption(
                  50, {.temperature_degc = 0, .salinity_ppt = 35, .depth_m = 0, .ph = 6}),
              13.96602, 0.03);
}

TEST(FrancoisGarrisonAbsorption, IsWithinATenthOfAinslieAndMcColm) {
  // Their paper's claim, 0.1 kHz to 1 MHz; tested inside the oceans' usual range.
  for (const double t : {0.0, 5.0, 10.0, 15.0, 20.0, 25.0}) {
    for (const double d : {0.0, 1000.0, 3000.0}) {
      for (const double f : {1.0, 3.0, 10.0, 25.0, 50.0, 100.0, 300.0}) {
        const SeaWater water = {.temperature_degc = t, .salinity_ppt = 35, .depth_m = d, .ph = 8};
        EXPECT_NEAR(FrancoisGarrisonAbsorption(f, water) / AinslieMcColm(f, water), 1, 0.1)
            << f << " kHz, " << t << " degC, " << d << " m";
      }
    }
  }
}

TEST(FrancoisGarrisonAbsorption, IsThatOfAnotherProgramWithThePapersCoefficients) {
  // Computed in Python from the paper's coefficients: kHz, degC, ppt, m, pH, dB/km.
  struct Row {
    double frequency_khz, temperature_degc, salinity_ppt, depth_m, ph, absorption_dbpkm;
  };
  const std::vector<Row> rows = {
      {0.5, 4, 35, 1000, 7.7, 0.0152409441412}, {1, 10, 35, 0, 8, 0.0601260633914},
      {25, 15, 10, 5, 8.2, 1.39292536702},      {100, 4, 35, 5000, 8, 13.8102338397},
      {500, 28, 33, 100, 8, 176.668001331},
  };
  for (const Row& row : rows) {
    const SeaWater water = {row.temperature_degc, row.salinity_ppt, row.depth_m, row.ph};
    EXPECT_NEAR(FrancoisGarrisonAbsorption(row.frequency_khz, water) / row.absorption_dbpkm, 1,
                1e-9)
        << row.frequency_khz;
  }
}

TEST(FrancoisGarrisonAbsorption, OfFreshWaterIsThatOfPureWater) {
  // Pinkerton (1949) measured 25.3e-15 neper s^2/m at 20 degC; 8.686e9 times that in dB/km/kHz^2.
  const SeaWater lake = {.temperature_degc = 20, .salinity_ppt = 0, .depth_m = 0, .ph = 7};
  EXPECT_NEAR(FrancoisGarrisonAbsorption(100, lake), 25.3e-15 * 8.686e9 * 1e4, 0.02);
  EXPECT_NEAR(FrancoisGarrisonAbsorption(200, lake) / FrancoisGarrisonAbsorption(100, lake), 4,
              1e-12);
}

TEST(FrancoisGarrisonAbsorption, DoesNotJumpAtTwentyDegrees) {
  const double below = FrancoisGarrisonAbsorption(1000, {.temperature_degc = 20});
  const double above =
      FrancoisGarrisonAbsorption(1000, {.temperature_degc = std::nextafter(20, 21)});
  EXPECT_NEAR(above / below, 1, 0.002);
}

TEST(Absorption, IsThatOfTheModelAskedFor) {
  const SeaWater water = {.temperature_degc = 20};
  EXPECT_EQ(Absorption(AbsorptionModel::kThorp, 25, water), ThorpAbsorption(25));
  EXPECT_EQ(Absorption(AbsorptionModel::kFrancoisGarrison, 25, water),
            FrancoisGarrisonAbsorption(25, water));
  EXPECT_NE(ThorpAbsorption(25), FrancoisGarrisonAbsorption(25, water));
}

TEST(Absorption, IsInfiniteWhereNoSoundCanBe) {
  for (const AbsorptionModel model :
       {AbsorptionModel::kThorp, AbsorptionModel::kFrancoisGarrison}) {
    for (const double nonsense : {0.0, -1.0, 1000.1, kNaN, kInfinity, -kInfinity}) {
      EXPECT_EQ(Absorption(model, nonsense, {}), kInfinity) << nonsense;
    }
  }
  for (const double nonsense : {kNaN, kInfinity, -273.0}) {
    EXPECT_EQ(FrancoisGarrisonAbsorption(25, {.temperature_degc = nonsense}), kInfinity);
    EXPECT_EQ(FrancoisGarrisonAbsorption(25, {.salinity_ppt = nonsense}), kInfinity);
    EXPECT_EQ(FrancoisGarrisonAbsorption(25, {.depth_m = nonsense}), kInfinity);
    EXPECT_EQ(FrancoisGarrisonAbsorption(25, {.ph = nonsense}), kInfinity);
  }
}

RC_GTEST_PROP(Absorption, RisesWithFrequencyAndIsPositive, ()) {
  const SeaWater water = {.temperature_degc = *rc::gen::inRange(-20, 301) / 10.0,
                          .salinity_ppt = *rc::gen::inRange(0, 401) / 10.0,
                          .depth_m = static_cast<double>(*rc::gen::inRange(0, 8001)),
                          .ph = *rc::gen::inRange(60, 91) / 10.0};
  const double f = *rc::gen::inRange(1, 9900) / 10.0;
  for (const AbsorptionModel model :
       {AbsorptionModel::kThorp, AbsorptionModel::kFrancoisGarrison}) {
    RC_ASSERT(Absorption(model, f, water) > 0);
    RC_ASSERT(Absorption(model, f * 1.01, water) > Absorption(model, f, water));
  }
}

}  // namespace shoal::absorption_test
