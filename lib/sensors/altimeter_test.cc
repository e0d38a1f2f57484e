#include "lib/sensors/altimeter.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "lib/ocean/distribution_testing.h"

namespace shoal::altimeter_test {

TEST(Altimeter, ReturnsTheTrueDistanceWithoutNoise) {
  EXPECT_EQ(MeasureAltitude({}, FlatFloor(60), {5, 6, 45}, 0), 15.0);
  EXPECT_EQ(DepthBelow(FlatFloor(60), {5, 6, 45}), 15);
}

TEST(Altimeter, ReturnsZeroOnAndBelowTheFloor) {
  EXPECT_EQ(MeasureAltitude({}, FlatFloor(60), {0, 0, 60}, 0), 0.0);
  EXPECT_EQ(MeasureAltitude({}, FlatFloor(60), {0, 0, 75}, 0), 0.0);
}

TEST(Altimeter, ReturnsNothingBeyondItsRange) {
  const Altimeter altimeter{.max_range_m = 20};
  EXPECT_EQ(MeasureAltitude(altimeter, FlatFloor(60), {0, 0, 40}, 0), 20.0);
  EXPECT_EQ(MeasureAltitude(altimeter, FlatFloor(60), {0, 0, 39.9}, 0), std::nullopt);
}

TEST(Altimeter, HasGaussianNoise) {
  const Altimeter altimeter{.noise = {.sigma = 0.5, .key = StreamKey(3, "altimeter")}};
  std::vector<double> errors_m;
  for (int number = 0; number < 4000; ++number) {
    errors_m.push_back(*MeasureAltitude(altimeter, FlatFloor(60), {0, 0, 40}, number) - 20);
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(KolmogorovSmirnov(errors_m, [](double e) { return NormalCumulative(e / 0.5); }),
            kKolmogorov999);
}

TEST(Altimeter, HasTheSameNoiseForTheSameMeasurementOnly) {
  const auto measure = [](uint64_t seed, int64_t number) {
    const Altimeter altimeter{.noise = {.sigma = 0.5, .key = StreamKey(seed, "altimeter")}};
    return *MeasureAltitude(altimeter, FlatFloor(60), {0, 0, 40}, number);
  };
  EXPECT_EQ(measure(1, 7), measure(1, 7));
  EXPECT_NE(measure(1, 7), measure(1, 8));
  EXPECT_NE(measure(1, 7), measure(2, 7));
}

RC_GTEST_PROP(Altimeter, ReadsWithinItsRange, ()) {
  const Altimeter altimeter{.max_range_m = 50,
                            .noise = {.sigma = 1e6, .key = StreamKey(1, "altimeter")}};
  const Eigen::Vector3d position_m(*rc::gen::arbitrary<double>(), *rc::gen::arbitrary<double>(),
                                   *rc::gen::arbitrary<double>());
  RC_PRE(position_m.allFinite());
  const auto reading =
      MeasureAltitude(altimeter, FlatFloor(40), position_m, *rc::gen::arbitrary<int64_t>());
  if (!reading) return;
  RC_ASSERT(*reading >= 0);
  RC_ASSERT(*reading <= 50);
}

}  // namespace shoal::altimeter_test
