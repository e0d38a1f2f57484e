#include "lib/sensors/current_meter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/ocean/distribution_testing.h"

namespace shoal::current_meter_test {

const Current kEastward({.speed_mps = {0.4}}, StreamKey(1, "current"));

TEST(CurrentMeter, ReturnsTheTruthWithoutNoise) {
  EXPECT_EQ(MeasureCurrent({}, kEastward, 12, 0), Eigen::Vector2d(0.4, 0));
}

TEST(CurrentMeter, HasIndependentGaussianNoiseInBothComponents) {
  const CurrentMeter meter{.noise = {.sigma = 0.05, .key = StreamKey(2, "current_meter")}};
  constexpr int kCount = 4000;
  std::vector<double> east;
  std::vector<double> north;
  double correlation = 0;
  for (int number = 0; number < kCount; ++number) {
    const Eigen::Vector2d error =
        (MeasureCurrent(meter, kEastward, 12, number) - Eigen::Vector2d(0.4, 0)) / 0.05;
    east.push_back(error.x());
    north.push_back(error.y());
    correlation += error.x() * error.y() / kCount;
  }
  // Each holds for 99.9 % of good seeds.
  EXPECT_LT(KolmogorovSmirnov(east, NormalCumulative), kKolmogorov999);
  EXPECT_LT(KolmogorovSmirnov(north, NormalCumulative), kKolmogorov999);
  EXPECT_LT(std::abs(correlation), 3.29 / std::sqrt(kCount));
}

TEST(CurrentMeter, HasTheSameNoiseForTheSameMeasurementOnly) {
  const CurrentMeter meter{.noise = {.sigma = 0.05, .key = StreamKey(2, "current_meter")}};
  EXPECT_EQ(MeasureCurrent(meter, kEastward, 12, 5), MeasureCurrent(meter, kEastward, 99, 5));
  EXPECT_NE(MeasureCurrent(meter, kEastward, 12, 5), MeasureCurrent(meter, kEastward, 12, 6));
}

}  // namespace shoal::current_meter_test
