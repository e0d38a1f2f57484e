#include "lib/sea/acoustics/ambient_noise.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace shoal::ambient_noise_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Another closed form of the Knudsen and Wenz curves of wind noise: passiveacoustics.org, "Ambient
/// noise" (2025).
double OtherWindNoise(double f, double wind_mps) {
  return 44 + 28 * std::log10(1 + std::pow(wind_mps, 0.75)) + 19 * std::log10(f) -
         18 * std::log10(f * f + 1 / std::pow(2.78 + 0.14 * wind_mps, 2));
}

/// The same page's form of the noise of ships; `traffic` 0 light, 1 medium, 2 heavy.
double OtherShippingNoise(double f, double traffic) {
  return 20 + 12 * traffic + 20 * std::log10(f) - 30 * std::log10(f * f + (15 + 4 * traffic) / 1e4);
}

TEST(TurbulenceNoise, FallsByThirtyDecibelsPerDecadeFromWenzLevelAtOneHertz) {
  EXPECT_NEAR(TurbulenceNoise(0.001), 107, 1e-12);
  EXPECT_NEAR(TurbulenceNoise(0.01), 77, 1e-12);
}

TEST(ThermalNoise, IsThatOfMellen) {
  // Mellen (1952), -15 + 20 log10 of the frequency in kHz; 25 dB at 100 kHz.
  EXPECT_NEAR(ThermalNoise(100), 25, 1e-12);
  EXPECT_NEAR(ThermalNoise(1), -15, 1e-12);
}

TEST(WindNoise, IsNearTheCurvesOfKnudsenAndWenz) {
  for (const double wind_mps : {2.0, 5.0, 8.0, 11.0}) {
    for (const double f : {0.5, 1.0, 2.0, 5.0, 10.0, 20.0}) {
      EXPECT_NEAR(WindNoise(f, wind_mps), OtherWindNoise(f, wind_mps), 4)
          << wind_mps << " m/s, " << f << " kHz";
    }
  }
  EXPECT_NEAR(WindNoise(1, 5), 61, 1);   // Wenz (1962), fig. 13, Beaufort 3.
  EXPECT_NEAR(WindNoise(10, 5), 45, 2);  // The same curve.
}

TEST(WindNoise, IsNearWhatWasMeasuredInTheNorwegianSea) {
  // Griggs, Characterization of Ambient Noise Recorded in the Norwegian Sea, Naval Postgraduate
  // School (2023), abstract: 43 dB at 19 kHz in sea state 2, where Wenz has 45.
  EXPECT_NEAR(WindNoise(19, 5), 43, 3);
}

TEST(ShippingNoise, IsNearTheCurvesOfWenz) {
  for (const double f : {0.02, 0.05, 0.1, 0.2, 0.5}) {
    EXPECT_NEAR(ShippingNoise(f, 0.5), OtherShippingNoise(f, 1), 9) << f;
  }
  EXPECT_NEAR(ShippingNoise(0.1, 0.5), 70, 5);  // Wenz (1962), fig. 13, usual traffic.
  EXPECT_NEAR(ShippingNoise(0.1, 1) - ShippingNoise(0.1, 0), 20, 1e-12);
}

TEST(ShippingNoise, RisesBelowThirtyHertzAndFallsAbove) {
  EXPECT_NEAR(ShippingNoise(100, 0.5) - ShippingNoise(10, 0.5), 26 - 60, 0.1);
  EXPECT_NEAR(ShippingNoise(1e-4, 0.5) - ShippingNoise(1e-5, 0.5), 26, 0.1);
}

TEST(NoiseSpectrumLevel, IsTheSumOfThePowers) {
  const double f = 0.3;
  const double sum = std::pow(10, TurbulenceNoise(f) / 10) +
                     std::pow(10, ShippingNoise(f, 0.2) / 10) + std::pow(10, WindNoise(f, 7) / 10) +
                     std::pow(10, ThermalNoise(f) / 10);
  EXPECT_NEAR(NoiseSpectrumLevel({.shipping = 0.2, .wind_mps = 7}, f), 10 * std::log10(sum), 1e-12);
}

TEST(NoiseSpectrumLevel, HasTheKnownComponentWhereThatRules) {
  const AmbientNoise noise = {.shipping = 0.5, .wind_mps = 5};
  EXPECT_NEAR(NoiseSpectrumLevel(noise, 0.002), TurbulenceNoise(0.002), 0.5);
  EXPECT_NEAR(NoiseSpectrumLevel(noise, 0.06), ShippingNoise(0.06, 0.5), 0.5);
  EXPECT_NEAR(NoiseSpectrumLevel(noise, 10), WindNoise(10, 5), 0.1);
  EXPECT_NEAR(NoiseSpectrumLevel(noise, 500), ThermalNoise(500), 0.5);
}

TEST(NoiseBandLevel, OfANarrowBandIsItsSpectrumTimesItsWidth) {
  const AmbientNoise noise;
  EXPECT_NEAR(NoiseBandLevel(noise, 24.9, 25.1),
              NoiseSpectrumLevel(noise, 25) + 10 * std::log10(200), 1e-3);
}

TEST(NoiseBandLevel, IsTheSumOfItsParts) {
  const AmbientNoise noise;
  const double parts = std::pow(10, NoiseBandLevel(noise, 10, 20) / 10) +
                       std::pow(10, NoiseBandLevel(noise, 20, 62) / 10);
  EXPECT_NEAR(NoiseBandLevel(noise, 10, 62), 10 * std::log10(parts), 1e-6);
}

TEST(NoiseBandLevel, OfThreeDecadesIsThatOfAFineSum) {
  const AmbientNoise noise;
  double sum = 0;
  constexpr int kParts = 3200;
  for (int i = 0; i < kParts; ++i) {
    const double low = std::pow(10, 3.0 * i / kParts);
    const double high = std::pow(10, 3.0 * (i + 1) / kParts);
    sum += std::pow(10, NoiseSpectrumLevel(noise, std::sqrt(low * high)) / 10) * (high - low) * 1e3;
  }
  EXPECT_NEAR(NoiseBandLevel(noise, 1, 1000), 10 * std::log10(sum), 1e-3);
}

TEST(NoiseBandLevel, OfAnOctaveDiffersFromCentreTimesWidthByHalfADecibel) {
  const AmbientNoise noise;
  const double centre = NoiseSpectrumLevel(noise, 37.5) + 10 * std::log10(25e3);
  EXPECT_NEAR(NoiseBandLevel(noise, 25, 50) - centre, 0.4, 0.2);
}

TEST(NoiseBandLevel, OfNoWidthIsNone) { EXPECT_EQ(NoiseBandLevel({}, 25, 25), -kInfinity); }

TEST(Noise, IsInfiniteWhereItsArgumentsAreInvalid) {
  for (const double nonsense : {0.0, -1.0, 1000.1, kNaN, kInfinity, -kInfinity}) {
    EXPECT_EQ(TurbulenceNoise(nonsense), kInfinity);
    EXPECT_EQ(ThermalNoise(nonsense), kInfinity);
    EXPECT_EQ(WindNoise(nonsense, 5), kInfinity);
    EXPECT_EQ(ShippingNoise(nonsense, 0.5), kInfinity);
    EXPECT_EQ(NoiseSpectrumLevel({}, nonsense), kInfinity);
    EXPECT_EQ(NoiseBandLevel({}, nonsense, 50), kInfinity);
    EXPECT_EQ(NoiseBandLevel({}, 10, nonsense), kInfinity);
  }
  for (const double nonsense : {-0.1, 41.0, kNaN, kInfinity}) {
    EXPECT_EQ(NoiseBandLevel({.shipping = nonsense}, 10, 20), kInfinity);
    EXPECT_EQ(NoiseBandLevel({.wind_mps = nonsense}, 10, 20), kInfinity);
  }
  EXPECT_EQ(NoiseBandLevel({}, 20, 10), kInfinity);
}

RC_GTEST_PROP(Noise, RisesWithWindAndShippingAndWithTheWidthOfTheBand, ()) {
  const double f = *rc::gen::inRange(1, 500'000) / 1000.0;
  const AmbientNoise noise = {.shipping = *rc::gen::inRange(0, 90) / 100.0,
                              .wind_mps = *rc::gen::inRange(0, 39) + 0.0};
  const AmbientNoise windier = {.shipping = noise.shipping, .wind_mps = noise.wind_mps + 1};
  const AmbientNoise busier = {.shipping = noise.shipping + 0.1, .wind_mps = noise.wind_mps};
  RC_ASSERT(WindNoise(f, windier.wind_mps) > WindNoise(f, noise.wind_mps));
  RC_ASSERT(NoiseSpectrumLevel(windier, f) >= NoiseSpectrumLevel(noise, f));
  RC_ASSERT(NoiseSpectrumLevel(busier, f) >= NoiseSpectrumLevel(noise, f));
  RC_ASSERT(NoiseBandLevel(noise, f, 2 * f) > NoiseBandLevel(noise, f, 1.9 * f));
}

}  // namespace shoal::ambient_noise_test
