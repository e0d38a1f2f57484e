#include "lib/vehicle/navigation/compass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/sea/ocean/distribution_testing.h"

namespace shoal::compass_test {

Stream Draws(int64_t number = 0) { return Stream(StreamKey(5, "compass").With(number)); }

double Read(const Compass& compass, double heading_rad) {
  Stream draws = Draws();
  return ReadCompass(compass, heading_rad, &draws);
}

TEST(Compass, ShowsTheTrueHeadingWithoutErrors) {
  EXPECT_DOUBLE_EQ(Read({}, 0), 0);
  EXPECT_DOUBLE_EQ(Read({}, 4), 4);
}

TEST(Compass, AddsItsBiasClockwiseAndStaysWithinATurn) {
  EXPECT_NEAR(Read({.bias_rad = DegToRad(5)}, DegToRad(358)), DegToRad(3), 1e-12);
  EXPECT_NEAR(Read({.bias_rad = DegToRad(-5)}, DegToRad(2)), DegToRad(357), 1e-12);
}

// Each coefficient alone, on the headings where compass-adjusters read it off: A the mean of all,
// B on East and West, C on North and South, D on the intercardinal, E on the cardinal headings.
TEST(Compass, HasTheDeviationOfACompassAdjuster) {
  const double one = DegToRad(1);
  const auto at = [](const DeviationCoefficients& deviation, double heading_deg) {
    return RadToDeg(DeviationAt(deviation, DegToRad(heading_deg)));
  };
  for (const double heading_deg : {0.0, 45.0, 200.0})
    EXPECT_NEAR(at({.a = one}, heading_deg), 1, 1e-12);
  EXPECT_NEAR(at({.b = one}, 90), 1, 1e-12);
  EXPECT_NEAR(at({.b = one}, 270), -1, 1e-12);
  EXPECT_NEAR(at({.b = one}, 0), 0, 1e-12);
  EXPECT_NEAR(at({.c = one}, 0), 1, 1e-12);
  EXPECT_NEAR(at({.c = one}, 180), -1, 1e-12);
  EXPECT_NEAR(at({.d = one}, 45), 1, 1e-12);
  EXPECT_NEAR(at({.d = one}, 135), -1, 1e-12);
  EXPECT_NEAR(at({.e = one}, 0), 1, 1e-12);
  EXPECT_NEAR(at({.e = one}, 90), -1, 1e-12);
}

TEST(Compass, ShowsLessThanTheHeadingWhereDeviationIsEast) {
  EXPECT_NEAR(Read({.deviation = {.a = DegToRad(4)}}, DegToRad(90)), DegToRad(86), 1e-12);
}

TEST(Compass, HasTheDeviationOfTheHeadingThatItShows) {
  const Compass compass = {.deviation = {.a = 0.02, .b = -0.1, .c = 0.08, .d = 0.05, .e = -0.03}};
  for (double heading_rad = 0; heading_rad < 2 * kPi; heading_rad += 0.1) {
    const double shown_rad = Read(compass, heading_rad);
    EXPECT_NEAR(WrapPi(shown_rad + DeviationAt(compass.deviation, shown_rad) - heading_rad), 0,
                1e-12)
        << heading_rad;
  }
}

TEST(Compass, KnowsTheRootMeanSquareOfItsDeviation) {
  const DeviationCoefficients deviation = {.a = 0.02, .b = -0.1, .c = 0.08, .d = 0.05, .e = -0.03};
  double sum = 0;
  constexpr int kCount = 360;
  for (int i = 0; i < kCount; ++i) {
    sum += std::pow(DeviationAt(deviation, 2 * kPi * i / kCount), 2) / kCount;
  }
  EXPECT_NEAR(DeviationRms(deviation), std::sqrt(sum), 1e-12);
}

TEST(Compass, HasGaussianNoise) {
  std::vector<double> errors;
  for (int64_t number = 0; number < 4000; ++number) {
    Stream draws = Draws(number);
    errors.push_back((ReadCompass({.noise_rad = 0.02}, 3, &draws) - 3) / 0.02);
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(KolmogorovSmirnov(errors, NormalCumulative), kKolmogorov999);
}

}  // namespace shoal::compass_test
