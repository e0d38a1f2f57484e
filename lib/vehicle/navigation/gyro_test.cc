#include "lib/vehicle/navigation/gyro.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/sea/ocean/distribution_testing.h"

namespace shoal::gyro_test {

TEST(Gyro, ReadsTheMeanRateOfTheStepAndItsBias) {
  GyroUnit gyro({.bias_radps = 0.01}, StreamKey(1, "gyro"));
  EXPECT_DOUBLE_EQ(gyro.Read(0.05, 0.1, 100'000), 0.51);
  EXPECT_DOUBLE_EQ(gyro.Read(-0.2, 0.4, 500'000), -0.49);
}

// Whatever the step is, the angle after 10 s has the standard deviation of the walk, 0.02 sqrt(10).
TEST(Gyro, IntegratesToAnAngleRandomWalkThatIsTheSameForEachStep) {
  for (const double dt_s : {0.1, 0.5}) {
    std::vector<double> angles;
    for (uint64_t seed = 0; seed < 400; ++seed) {
      GyroUnit gyro({.noise_rad_per_rts = 0.02}, StreamKey(seed, "gyro"));
      double angle = 0;
      for (int i = 1; i <= static_cast<int>(10 / dt_s + 0.5); ++i) {
        angle += dt_s * gyro.Read(0, dt_s, i);
      }
      angles.push_back(angle / (0.02 * std::sqrt(10)));
    }
    // 99.9 % of good seeds pass.
    EXPECT_LT(KolmogorovSmirnov(angles, NormalCumulative), kKolmogorov999) << dt_s;
  }
}

TEST(Gyro, LetsItsBiasWander) {
  std::vector<double> biases;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    GyroUnit gyro({.bias_radps = 0.3, .bias_walk_radps_per_rts = 0.001}, StreamKey(seed, "gyro"));
    for (int i = 1; i <= 50; ++i) static_cast<void>(gyro.Read(0, 0.5, i));
    biases.push_back((gyro.bias_radps() - 0.3) / (0.001 * 5));
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(KolmogorovSmirnov(biases, NormalCumulative), kKolmogorov999);
}

TEST(Gyro, DrawsItsNoiseWhetherTheBiasWandersOrNot) {
  GyroUnit steady({.noise_rad_per_rts = 0.1}, StreamKey(1, "gyro"));
  GyroUnit wandering({.noise_rad_per_rts = 0.1, .bias_walk_radps_per_rts = 1e-9},
                     StreamKey(1, "gyro"));
  for (int i = 1; i < 20; ++i) EXPECT_NEAR(steady.Read(0, 1, i), wandering.Read(0, 1, i), 1e-7);
}

}  // namespace shoal::gyro_test
