#include "lib/vehicle/navigation/ranging.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/sea/ocean/distribution_testing.h"

namespace shoal::ranging_test {

constexpr double kSound_mps = 1500;

Stream Draws(int64_t number = 0) { return Stream(StreamKey(5, "range").With(number)); }

double OneWay(double range_m, const OwnClock& clock = {}, double time_s = 0,
              const RangeErrors& errors = {}, int64_t number = 0) {
  Stream draws = Draws(number);
  return OneWayRange(range_m, kSound_mps, clock, time_s, errors, &draws);
}

double TwoWay(double range_m, double turnaround_s, const OwnClock& clock = {}) {
  Stream draws = Draws();
  return TwoWayRange(range_m, kSound_mps, turnaround_s, clock, {}, &draws);
}

RC_GTEST_PROP(OneWayRange, IsTrueToOneMicrosecondTimesTheSpeedOfSound, ()) {
  const double range_m = *rc::gen::inRange(0, 10'000'000) / 1000.0;
  RC_ASSERT(std::abs(OneWay(range_m) - range_m) <= 1e-6 * kSound_mps);
}

RC_GTEST_PROP(TwoWayRange, IsTrueToOneMicrosecondTimesTheSpeedOfSound, ()) {
  const double range_m = *rc::gen::inRange(0, 10'000'000) / 1000.0;
  const double turnaround_s = *rc::gen::inRange(0, 1000) / 1000.0;
  RC_ASSERT(std::abs(TwoWay(range_m, turnaround_s) - range_m) <= 1e-6 * kSound_mps);
}

TEST(OneWayRange, CountsWholeMicroseconds) {
  for (const double range_m : {12.3456789, 777.7777, 1499.99999}) {
    const double microseconds = OneWay(range_m) / kSound_mps * 1e6;
    EXPECT_NEAR(microseconds, std::round(microseconds), 1e-6) << range_m;
  }
}

TEST(OneWayRange, IsTooLongByTheOffsetOfTheOwnClock) {
  const OwnClock clock = {.phase_s = 0.002, .drift_ppm = 1};
  EXPECT_NEAR(ClockOffset_s(clock, 3600), 0.0056, 1e-12);
  EXPECT_NEAR(OneWay(900, clock, 3600), 900 + 0.0056 * kSound_mps, 1e-6 * kSound_mps);
}

TEST(TwoWayRange, DoesNotDependOnTheOffsetOfTheOwnClock) {
  EXPECT_EQ(TwoWay(900, 0.1, {.phase_s = 7}), TwoWay(900, 0.1));
}

TEST(TwoWayRange, IsTooLongByTheDriftOverQuestionAndAnswer) {
  // 1.2 s of travel and 0.3 s of turnaround, at 100 ppm: 150 us, half of it times 1500 m/s.
  EXPECT_NEAR(TwoWay(900, 0.3, {.drift_ppm = 100}), 900.1125, 1e-6 * kSound_mps);
}

TEST(RangeErrors, AreGaussian) {
  std::vector<double> errors;
  for (int64_t number = 0; number < 4000; ++number) {
    errors.push_back((OneWay(900, {}, 0, {.noise_m = 2}, number) - 900) / 2);
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(KolmogorovSmirnov(errors, NormalCumulative), kKolmogorov999);
}

TEST(RangeErrors, HaveTheStatedShareOfLongerWays) {
  std::vector<double> longer_m;
  constexpr int kCount = 10'000;
  for (int64_t number = 0; number < kCount; ++number) {
    const double error_m =
        OneWay(900, {}, 0, {.outlier_ratio = 0.2, .outlier_m = 50}, number) - 900;
    if (error_m > 0.001) longer_m.push_back(error_m);
  }
  // Within 3.29 standard deviations: 99.9 % of good seeds pass, here and of the uniform lengths.
  EXPECT_NEAR(static_cast<double>(longer_m.size()), 0.2 * kCount, 3.29 * std::sqrt(0.16 * kCount));
  EXPECT_LT(KolmogorovSmirnov(longer_m, [](double error_m) { return error_m / 50; }),
            kKolmogorov999);
}

TEST(Usbl, MeasuresFromTheBowClockwiseAndDownward) {
  const UsblReading reading = TrueUsbl({10, 20, 5}, DegToRad(90), {10, -10, 45});
  EXPECT_DOUBLE_EQ(reading.range_m, 50);
  EXPECT_NEAR(reading.bearing_rad, DegToRad(90), 1e-12);
  EXPECT_NEAR(reading.depression_rad, std::atan2(4, 3), 1e-12);
}

TEST(Usbl, SeesATransponderToPortOnANegativeBearing) {
  EXPECT_NEAR(TrueUsbl({0, 0, 0}, DegToRad(10), {-5, 0, 0}).bearing_rad, DegToRad(-100), 1e-12);
}

TEST(Usbl, HasIndependentGaussianNoiseInItsAngles) {
  std::vector<double> bearings;
  std::vector<double> depressions;
  for (int64_t number = 0; number < 4000; ++number) {
    Stream draws = Draws(number);
    const UsblReading reading =
        WithNoise({.range_m = 100, .bearing_rad = 1, .depression_rad = 0.5},
                  {.bearing_noise_rad = 0.02, .depression_noise_rad = 0.01}, &draws);
    EXPECT_EQ(reading.range_m, 100);
    bearings.push_back((reading.bearing_rad - 1) / 0.02);
    depressions.push_back((reading.depression_rad - 0.5) / 0.01);
  }
  // Each holds for 99.9 % of good seeds.
  EXPECT_LT(KolmogorovSmirnov(bearings, NormalCumulative), kKolmogorov999);
  EXPECT_LT(KolmogorovSmirnov(depressions, NormalCumulative), kKolmogorov999);
}

}  // namespace shoal::ranging_test
