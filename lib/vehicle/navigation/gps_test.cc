#include "lib/vehicle/navigation/gps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/sea/ocean/distribution_testing.h"

namespace shoal::gps_test {

const Gps kGps = {.antenna_depth_m = 0.3, .cold_fix_s = 30, .hot_fix_s = 5, .hot_for_s = 100};
const StreamKey kKey(1, "gps");

constexpr int64_t Us(double time_s) { return static_cast<int64_t>(time_s * 1e6); }

/// Returns how long a receiver that comes up at 10 s, after a start under water, takes for its fix.
double TimeToFix(const Gps& gps) {
  GpsUnit unit(gps, kKey);
  for (double time_s = 0;; time_s += 0.5) {
    unit.Watch(time_s < 10 ? 5 : 0, Us(time_s));
    if (unit.has_fix()) return time_s - 10;
  }
}

TEST(Gps, TakesTheTimeOfAHotOrAColdStart) {
  EXPECT_EQ(TimeToFix(kGps), 5);
  Gps cold = kGps;
  cold.starts_hot = false;
  EXPECT_EQ(TimeToFix(cold), 30);
}

TEST(Gps, StartsHotUntilTheLastFixIsTooOld) {
  Gps gps = kGps;
  gps.hot_for_s = 10;
  EXPECT_EQ(TimeToFix(gps), 5);
  gps.hot_for_s = 9.99;
  EXPECT_EQ(TimeToFix(gps), 30);
}

TEST(Gps, WorksDownToTheDepthOfItsAntennaAndNoDeeper) {
  Gps gps = kGps;
  gps.hot_fix_s = 0;
  GpsUnit unit(gps, kKey);
  for (const double depth_m : {0.0, 0.299, 0.3}) {
    unit.Watch(depth_m, 0);
    EXPECT_TRUE(unit.has_fix()) << depth_m;
    EXPECT_TRUE(unit.Read({1, 2}, 0)) << depth_m;
  }
  unit.Watch(0.301, 0);
  EXPECT_FALSE(unit.has_fix());
  EXPECT_FALSE(unit.Read({1, 2}, 0));
}

TEST(Gps, BeginsItsSearchAgainAfterAWaveAboveTheAntenna) {
  GpsUnit unit(kGps, kKey);
  unit.Watch(0, 0);
  unit.Watch(1, Us(4));
  unit.Watch(0, Us(4.5));
  unit.Watch(0, Us(9.4));
  EXPECT_FALSE(unit.has_fix());
  unit.Watch(0, Us(9.5));
  EXPECT_TRUE(unit.has_fix());
}

TEST(Gps, RemembersItsLastFixUnderWater) {
  Gps gps = kGps;
  gps.starts_hot = false;
  GpsUnit unit(gps, kKey);
  unit.Watch(0, 0);
  unit.Watch(0, Us(30));
  ASSERT_TRUE(unit.has_fix());
  unit.Watch(5, Us(31));
  unit.Watch(0, Us(130));
  unit.Watch(0, Us(135));
  EXPECT_TRUE(unit.has_fix());
}

TEST(Gps, HasIndependentGaussianNoiseInBothComponents) {
  Gps gps = kGps;
  gps.hot_fix_s = 0;
  gps.noise_m = 3;
  GpsUnit unit(gps, kKey);
  unit.Watch(0, 0);
  std::vector<double> east;
  std::vector<double> north;
  double correlation = 0;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {
    const Eigen::Vector2d error = (*unit.Read({100, 200}, i) - Eigen::Vector2d(100, 200)) / 3;
    east.push_back(error.x());
    north.push_back(error.y());
    correlation += error.x() * error.y() / kCount;
  }
  // Each holds for 99.9 % of good seeds.
  EXPECT_LT(KolmogorovSmirnov(east, NormalCumulative), kKolmogorov999);
  EXPECT_LT(KolmogorovSmirnov(north, NormalCumulative), kKolmogorov999);
  EXPECT_LT(std::abs(correlation), 3.29 / std::sqrt(kCount));
}

}  // namespace shoal::gps_test
