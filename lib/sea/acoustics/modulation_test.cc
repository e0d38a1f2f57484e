#include "lib/sea/acoustics/modulation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace shoal::modulation_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Still(Modulation modulation, double eb_over_n0_db) {
  return BitErrorRate(modulation, Fading::kNone, eb_over_n0_db);
}

double Fades(Modulation modulation, double eb_over_n0_db) {
  return BitErrorRate(modulation, Fading::kRayleigh, eb_over_n0_db);
}

/// The mean of the bit error rate over exponentially distributed Eb/N0, by the trapezoidal rule in
/// u = exp(-x): what Rayleigh fading is.
double FadesByIntegration(Modulation modulation, double eb_over_n0_db) {
  constexpr int kSteps = 2'000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double u = (i + 0.5) / kSteps;
    sum += Still(modulation, eb_over_n0_db + 10 * std::log10(-std::log(u)));
  }
  return sum / kSteps;
}

// Eb/N0 for 1e-5: Proakis, Digital Communications, figs. 5.2-4, 5.2-12 and 5.4-4; Sklar, Digital
// Communications, 2nd ed., fig. 4.29, to the tenth of a decibel that the curves can be read to.
TEST(BitErrorRate, IsOneInAHundredThousandWhereTheTextbooksHaveIt) {
  EXPECT_NEAR(std::log10(Still(Modulation::kCoherentPsk, 9.588)), -5, 0.005);
  EXPECT_NEAR(std::log10(Still(Modulation::kDifferentialPsk, 10.342)), -5, 0.005);
  EXPECT_NEAR(std::log10(Still(Modulation::kCoherentFsk, 12.598)), -5, 0.005);
  EXPECT_NEAR(std::log10(Still(Modulation::kNoncoherentFsk, 13.352)), -5, 0.005);
}

TEST(BitErrorRate, OfCoherentPskHasTheWellKnownValues) {
  // Q(sqrt(2 Eb/N0)) at 0, 4, 6.8 and 8.4 dB (Proakis, table of Q).
  EXPECT_NEAR(Still(Modulation::kCoherentPsk, 0), 0.0786496, 1e-7);
  EXPECT_NEAR(Still(Modulation::kCoherentPsk, 4), 0.0125009, 1e-7);
  EXPECT_NEAR(Still(Modulation::kCoherentPsk, 6.79), 1e-3, 2e-5);
  EXPECT_NEAR(Still(Modulation::kCoherentPsk, 8.40), 1e-4, 2e-6);
}

TEST(BitErrorRate, OfFskIsThreeDecibelsBehindPsk) {
  for (const double ratio_db : {0.0, 5.0, 10.0}) {
    const double three_db = 10 * std::log10(2);
    EXPECT_NEAR(Still(Modulation::kCoherentFsk, ratio_db + three_db) /
                    Still(Modulation::kCoherentPsk, ratio_db),
                1, 1e-9);
    EXPECT_NEAR(Still(Modulation::kNoncoherentFsk, ratio_db + three_db) /
                    Still(Modulation::kDifferentialPsk, ratio_db),
                1, 1e-9);
  }
}

// Proakis, fig. 14.3-1: one error in a thousand needs 24 dB of PSK, 27 of DPSK and coherent FSK, 30
// of non-coherent FSK.
TEST(BitErrorRate, InRayleighFadingIsOneInAThousandWhereProakisHasIt) {
  EXPECT_NEAR(Fades(Modulation::kCoherentPsk, 24.0), 1e-3, 1e-5);
  EXPECT_NEAR(Fades(Modulation::kDifferentialPsk, 27.0), 1e-3, 1e-5);
  EXPECT_NEAR(Fades(Modulation::kCoherentFsk, 27.0), 1e-3, 1e-5);
  EXPECT_NEAR(Fades(Modulation::kNoncoherentFsk, 30.0), 1e-3, 1e-5);
}

TEST(BitErrorRate, InRayleighFadingIsTheMeanOverFadedStrengths) {
  for (const auto& [word, modulation] : kModulations) {
    for (const double ratio_db : {-5.0, 0.0, 5.0, 10.0, 15.0}) {
      EXPECT_NEAR(Fades(modulation, ratio_db) / FadesByIntegration(modulation, ratio_db), 1, 0.01)
          << word << " " << ratio_db;
    }
  }
}

TEST(BitErrorRate, InRayleighFadingKeepsItsPrecisionAtHighRatios) {
  // 1 / (4 Eb/N0) (Proakis eq. 14-3-13), where 1 - sqrt() would cancel.
  EXPECT_NEAR(Fades(Modulation::kCoherentPsk, 120) * 4e12, 1, 1e-9);
  EXPECT_NEAR(Fades(Modulation::kCoherentFsk, 120) * 2e12, 1, 1e-9);
}

TEST(BitErrorRate, IsHalfWithoutSignalAndNoneWithoutNoise) {
  for (const auto& [word, modulation] : kModulations) {
    for (const Fading fading : {Fading::kNone, Fading::kRayleigh}) {
      EXPECT_EQ(BitErrorRate(modulation, fading, -kInfinity), 0.5) << word;
      EXPECT_EQ(BitErrorRate(modulation, fading, kNaN), 0.5) << word;
      EXPECT_EQ(BitErrorRate(modulation, fading, kInfinity), 0) << word;
      EXPECT_EQ(BitErrorRate(modulation, fading, 1e300), 0) << word;
      EXPECT_EQ(BitErrorRate(modulation, fading, -1e300), 0.5) << word;
    }
  }
}

RC_GTEST_PROP(BitErrorRate, NeverRisesWithTheRatioNorExceedsHalf, ()) {
  const double ratio_db = *rc::gen::inRange(-600, 600) / 10.0;
  for (const auto& [word, modulation] : kModulations) {
    for (const Fading fading : {Fading::kNone, Fading::kRayleigh}) {
      const double here = BitErrorRate(modulation, fading, ratio_db);
      RC_ASSERT(here >= 0);
      RC_ASSERT(here <= 0.5);
      RC_ASSERT(BitErrorRate(modulation, fading, ratio_db + 0.1) <= here);
    }
    RC_ASSERT(Fades(modulation, ratio_db) >= Still(modulation, ratio_db));
  }
}

TEST(EnergyPerBitToNoise, GainsWhatTheBandIsWiderThanTheRate) {
  EXPECT_NEAR(EnergyPerBitToNoise(3, 4, 4000), 3, 1e-12);
  EXPECT_NEAR(EnergyPerBitToNoise(3, 4, 40), 23, 1e-12);
  EXPECT_NEAR(EnergyPerBitToNoise(3, 1, 2000), 3 - 3.0103, 1e-5);
}

TEST(EnergyPerBitToNoise, IsNoneWhereItIsNotANumber) {
  for (const double nonsense : {0.0, -1.0, kNaN}) {
    EXPECT_EQ(EnergyPerBitToNoise(3, nonsense, 100), -kInfinity);
    EXPECT_EQ(EnergyPerBitToNoise(3, 4, nonsense), -kInfinity);
  }
  EXPECT_EQ(EnergyPerBitToNoise(kNaN, 4, 100), -kInfinity);
  EXPECT_EQ(EnergyPerBitToNoise(-kInfinity, kInfinity, 100), -kInfinity);
}

}  // namespace shoal::modulation_test
