#include "lib/sea/ocean/current.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/sea/ocean/distribution_testing.h"
#include "tests/golden/read_golden.h"

namespace shoal::current_test {

CurrentParams Swinging(double deviation_mps, double half_period_s) {
  return {.speed_mps = {1, deviation_mps, half_period_s}, .direction_rad = {0.5, 0.2, 7}};
}

TEST(CurrentShape, IsThatOfMunet) {
  int compared = 0;
  const nlohmann::json golden = ReadGoldenJson("munet/current_shape.json");
  for (const auto& scenario : golden.at("cases")) {
    CurrentParams params;
    params.speed_mps.mean = scenario.at("mean_speed");
    params.direction_rad.mean = scenario.at("mean_angle");
    const auto offsets = scenario.at("normal_minus_mean").get<std::vector<double>>();
    const int samples =
        static_cast<int>(scenario.at("half_period").get<double>() / scenario.at("h").get<double>());
    const bool starts_above = scenario.at("start_sign") == 1;
    const auto indices = scenario.at("index").get<std::vector<int>>();
    for (size_t row = 0; row < indices.size(); ++row) {
      const auto node = static_cast<size_t>(indices[row] / samples);
      const double deviation =
          DeviationAt({.start_amplitude = std::abs(offsets.at(node)),
                       .end_amplitude = std::abs(offsets.at(node + 1)),
                       .above_mean = starts_above == (node % 2 == 0)},
                      static_cast<double>(indices[row] % samples) / (samples - 1));
      const Flow flow = FlowAt(params, deviation, deviation);
      EXPECT_NEAR(flow.speed_mps, scenario.at("speed")[row], 1e-12) << "index " << indices[row];
      EXPECT_NEAR(flow.direction_rad, scenario.at("angle")[row], 1e-12) << "index " << indices[row];
      ++compared;
    }
  }
  EXPECT_EQ(compared, 299);
}

TEST(Current, WithoutDeviationsIsConstant) {
  const Current current({.speed_mps = {0.4}, .direction_rad = {kPi / 2}}, StreamKey(1, "current"));
  for (const double time_s : {0.0, 17.0, 1e6, -5.0}) {
    EXPECT_TRUE(Velocity(current.At(time_s)).isApprox(Eigen::Vector2d(0, 0.4))) << time_s;
  }
}

TEST(Current, IsStillByDefault) { EXPECT_EQ(Velocity(Current().At(5)), Eigen::Vector2d(0, 0)); }

TEST(Current, KeepsASteadySpeedAboveTheUsualLimitWhereTheLimitIsRaised) {
  CurrentParams params;
  params.speed_mps.mean = 3;
  EXPECT_FALSE(IsCurrent(params));
  params.max_speed_mps = 3;
  EXPECT_EQ(Current(params, StreamKey(1, "current")).At(9).speed_mps, 3);
}

TEST(Current, CrossesItsMeanAtEveryHalfPeriod) {
  const Current current(Swinging(0.5, 30), StreamKey(3, "current"));
  for (int node = -3; node < 10; ++node) {
    EXPECT_NEAR(current.At(30 * node).speed_mps, 1, 1e-15);
    const double before = current.At(30 * node - 10).speed_mps - 1;
    const double after = current.At(30 * node + 10).speed_mps - 1;
    EXPECT_LT(before * after, 0) << "node " << node;
  }
}

TEST(Current, NeedsNoHistory) {
  const Current asked_in_order(Swinging(0.5, 3), StreamKey(3, "current"));
  for (double time_s = 0; time_s < 100; time_s += 0.7) (void)asked_in_order.At(time_s);
  const Current asked_once(Swinging(0.5, 3), StreamKey(3, "current"));
  EXPECT_EQ(asked_in_order.At(100).speed_mps, asked_once.At(100).speed_mps);
}

TEST(Current, DiffersBetweenSeedsAndBetweenSpeedAndDirection) {
  CurrentParams params = Swinging(0.5, 10);
  params.direction_rad = {.mean = 1, .deviation = 0.5, .half_period_s = 10};
  const Flow one = Current(params, StreamKey(1, "current")).At(5);
  const Flow other = Current(params, StreamKey(2, "current")).At(5);
  EXPECT_NE(one.speed_mps, other.speed_mps);
  EXPECT_NE(one.direction_rad, other.direction_rad);
  EXPECT_NE(std::abs(one.speed_mps - 1), std::abs(one.direction_rad - 1));
}

TEST(Current, SwingsNoFurtherThanItCanInBothDirections) {
  const auto deviation = [](double mean_mps, double deviation_mps) {
    const CurrentParams params{.speed_mps = {mean_mps, deviation_mps}};
    return Current(params, StreamKey(1, "current")).params().speed_mps.deviation;
  };
  EXPECT_EQ(deviation(0.1, 5), 0.1);
  EXPECT_EQ(deviation(2.25, 5), 0.25);
  EXPECT_EQ(deviation(0, 5), 0);
  EXPECT_EQ(deviation(1, 0.5), 0.5);
}

// Amplitudes are read off just after a node, where the deviation is a sin(pi f) to 1e-6.
TEST(CurrentAmplitudes, AreHalfNormalWithAThirdOfTheDeviation) {
  const Current current(Swinging(0.9, 1), StreamKey(11, "current"));
  constexpr double kFraction = 1e-6;
  std::vector<double> amplitudes;
  for (int node = 0; node < 4000; ++node) {
    amplitudes.push_back(std::abs(current.At(node + kFraction).speed_mps - 1) /
                         std::sin(kPi * kFraction));
  }
  // 99.9 % of good seeds pass.
  EXPECT_LT(
      KolmogorovSmirnov(amplitudes, [](double a) { return 2 * NormalCumulative(a / 0.3) - 1; }),
      kKolmogorov999);
}

TEST(CurrentAmplitudes, OfNeighboursAreIndependent) {
  const Current current(Swinging(0.9, 1), StreamKey(12, "current"));
  constexpr int kCount = 4000;
  const double mean = 0.3 * std::sqrt(2 / kPi);
  const double variance = 0.09 * (1 - 2 / kPi);
  const auto amplitude = [&](int node) {
    return std::abs(current.At(node + 1e-6).speed_mps - 1) / std::sin(kPi * 1e-6);
  };
  double covariance = 0;
  for (int node = 0; node < kCount; ++node) {
    covariance += (amplitude(node) - mean) * (amplitude(node + 1) - mean) / kCount;
  }
  // The correlation of independent ones has the deviation 1 / sqrt(n); 3.29 of them: 99.9 %.
  EXPECT_LT(std::abs(covariance / variance), 3.29 / std::sqrt(kCount));
}

TEST(CurrentStart, IsAboveTheMeanForHalfOfTheSeeds) {
  int above = 0;
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    if (Current(Swinging(0.5, 10), StreamKey(seed, "current")).At(5).speed_mps > 1) ++above;
  }
  EXPECT_NEAR(above, 500, 3.29 * std::sqrt(250.0));  // 99.9 %.
}

RC_GTEST_PROP(Current, IsFiniteAndWithinItsLimitsAtEveryTime, ()) {
  const auto between = [](double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
  };
  const CurrentParams params{
      .speed_mps = {between(0, 2.5), between(0, 5), std::pow(10, between(-3, 9))},
      .direction_rad = {between(-10, 10), between(0, kPi), std::pow(10, between(-3, 9))}};
  RC_ASSERT(IsCurrent(params));
  const Current current(params, StreamKey(*rc::gen::arbitrary<uint64_t>(), "current"));
  const double time_s = between(-1, 1) * std::pow(10, between(-300, 308));
  const Flow flow = current.At(time_s);
  RC_ASSERT(flow.speed_mps >= 0);
  RC_ASSERT(flow.speed_mps <= 2.5);
  RC_ASSERT(std::abs(flow.direction_rad) <= kPi);
}

RC_GTEST_PROP(Current, IsContinuous, ()) {
  const Current current(Swinging(0.9, 2), StreamKey(*rc::gen::arbitrary<uint64_t>(), "current"));
  const double time_s = *rc::gen::inRange(-100'000, 100'000) / 1000.0;
  // Steepest: amplitude (0.3 times at most 8.6, what a normal draw can reach) pi / 2 s.
  RC_ASSERT(std::abs(current.At(time_s + 1e-9).speed_mps - current.At(time_s - 1e-9).speed_mps) <
            1e-7);
}

TEST(CurrentParameters, ThatAreInvalidAreFound) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(IsCurrent({}));
  for (const double nonsense : {kNan, kInf, -kInf, -1.0}) {
    CurrentParams params;
    params.speed_mps.mean = nonsense;
    EXPECT_FALSE(IsCurrent(params)) << nonsense;
    params = {};
    params.speed_mps.deviation = nonsense;
    EXPECT_FALSE(IsCurrent(params)) << nonsense;
    params = {};
    params.direction_rad.half_period_s = nonsense;
    EXPECT_FALSE(IsCurrent(params)) << nonsense;
    params = {};
    params.max_speed_mps = nonsense;
    EXPECT_FALSE(IsCurrent(params)) << nonsense;
  }
  CurrentParams params;
  params.direction_rad.mean = kNan;
  EXPECT_FALSE(IsCurrent(params));
}

}  // namespace shoal::current_test
