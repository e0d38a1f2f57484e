#include "lib/vehicle/navigation/velocity_sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/sea/ocean/distribution_testing.h"

namespace shoal::velocity_sensors_test {

const Eigen::Vector2d kVelocity_mps(1.5, -0.2);

Stream Draws(int64_t number = 0) { return Stream(StreamKey(5, "dvl").With(number)); }

std::optional<Eigen::Vector2d> Ping(const Dvl& dvl, std::optional<double> altitude_m,
                                    int64_t number = 0) {
  Stream draws = Draws(number);
  return ReadDvl(dvl, kVelocity_mps, altitude_m, &draws);
}

TEST(Dvl, MeasuresTheVelocityOverGround) { EXPECT_EQ(Ping({}, 20), kVelocity_mps); }

TEST(Dvl, MeasuresTooMuchByItsScaleError) {
  EXPECT_TRUE(Ping({.scale_error = 0.02}, 20)->isApprox(1.02 * kVelocity_mps, 1e-15));
}

TEST(Dvl, HasBottomLockAtAndInsideItsAltitudesAndNotOutside) {
  const Dvl dvl = {.min_altitude_m = 0.5, .max_altitude_m = 80};
  for (const double altitude_m : {0.5, 0.501, 20.0, 79.99, 80.0}) {
    EXPECT_TRUE(HasBottomLock(dvl, altitude_m)) << altitude_m;
    EXPECT_TRUE(Ping(dvl, altitude_m)) << altitude_m;
  }
  for (const double altitude_m : {0.0, 0.499, 80.01, 5000.0}) {
    EXPECT_FALSE(HasBottomLock(dvl, altitude_m)) << altitude_m;
    EXPECT_FALSE(Ping(dvl, altitude_m)) << altitude_m;
  }
}

TEST(Dvl, HasNoBottomLockWhereTheAltitudeIsNotKnown) {
  EXPECT_FALSE(HasBottomLock({}, std::nullopt));
  EXPECT_FALSE(Ping({}, std::nullopt));
}

TEST(Dvl, LosesTheStatedShareOfPings) {
  int lost = 0;
  constexpr int kCount = 10'000;
  for (int64_t number = 0; number < kCount; ++number) {
    if (!Ping({.dropout = 0.1}, 20, number)) ++lost;
  }
  // Within 3.29 standard deviations: 99.9 % of good seeds pass.
  EXPECT_NEAR(lost, 0.1 * kCount, 3.29 * std::sqrt(0.09 * kCount));
}

TEST(Dvl, HasGaussianNoiseInBothComponents) {
  std::vector<double> forward;
  std::vector<double> starboard;
  double correlation = 0;
  constexpr int kCount = 4000;
  for (int64_t number = 0; number < kCount; ++number) {
    const Eigen::Vector2d error = (*Ping({.noise_mps = 0.01}, 20, number) - kVelocity_mps) / 0.01;
    forward.push_back(error.x());
    starboard.push_back(error.y());
    correlation += error.x() * error.y() / kCount;
  }
  // Each holds for 99.9 % of good seeds.
  EXPECT_LT(KolmogorovSmirnov(forward, NormalCumulative), kKolmogorov999);
  EXPECT_LT(KolmogorovSmirnov(starboard, NormalCumulative), kKolmogorov999);
  EXPECT_LT(std::abs(correlation), 3.29 / std::sqrt(kCount));
}

TEST(Dvl, HasTheSameNoiseWhateverTheShareOfLostPings) {
  for (int64_t number = 0; number < 50; ++number) {
    const auto lossy = Ping({.noise_mps = 0.01, .dropout = 0.5}, 20, number);
    if (!lossy) continue;
    EXPECT_EQ(*lossy, *Ping({.noise_mps = 0.01}, 20, number));
  }
}

TEST(SpeedLog, HasGaussianNoise) {
  std::vector<double> errors;
  for (int64_t number = 0; number < 4000; ++number) {
    Stream draws = Draws(number);
    errors.push_back((ReadSpeedLog({.noise_mps = 0.05}, 1.5, &draws) - 1.5) / 0.05);
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(KolmogorovSmirnov(errors, NormalCumulative), kKolmogorov999);
}

TEST(DepthSensor, HasABiasAndGaussianNoise) {
  std::vector<double> errors;
  for (int64_t number = 0; number < 4000; ++number) {
    Stream draws = Draws(number);
    errors.push_back((ReadDepth({.bias_m = 0.3, .noise_m = 0.1}, 20, &draws) - 20.3) / 0.1);
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(KolmogorovSmirnov(errors, NormalCumulative), kKolmogorov999);
}

}  // namespace shoal::velocity_sensors_test
