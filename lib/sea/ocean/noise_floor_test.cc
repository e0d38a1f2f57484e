#include "lib/sea/ocean/noise_floor.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shoal::noise_floor_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

NoiseFloorOptions Small(FloorStyle style = FloorStyle::kLinear) {
  NoiseFloorOptions options;
  options.style = style;
  options.z_m = 40;
  options.range_m = 20;
  options.size_m = 100;
  options.scale_m = 30;
  options.south_west_m = {-50, -50};
  return options;
}

double Coordinate() { return *rc::gen::inRange(-70'000, 70'000) / 1000.0; }

TEST(Permutation, IsOne) {
  PerlinPermutation permutation = DrawPermutation(StreamKey(1, "floor"));
  EXPECT_NE(permutation[0] + permutation[1] * 256 + permutation[2] * 65536, 0x020100);
  std::sort(permutation.begin(), permutation.end());
  for (size_t i = 0; i < permutation.size(); ++i) EXPECT_EQ(permutation[i], i);
}

TEST(Permutation, HasEachNumberAnywhereEquallyOften) {
  constexpr int kCount = 2560;
  std::array<int, 256> places_of_7 = {};
  for (uint64_t seed = 0; seed < kCount; ++seed) {
    const PerlinPermutation permutation = DrawPermutation(StreamKey(seed, "floor"));
    ++places_of_7[static_cast<size_t>(std::find(permutation.begin(), permutation.end(), 7) -
                                      permutation.begin())];
  }
  double chi_square = 0;
  for (const int count : places_of_7) chi_square += (count - 10) * (count - 10) / 10.0;
  EXPECT_LT(chi_square, 330.5);  // 99.9 % of chi-square with 255 degrees of freedom.
}

TEST(PerlinNoise, IsZeroAtWholeNumbersAndRepeatsWithoutASeam) {
  const PerlinPermutation permutation = DrawPermutation(StreamKey(1, "floor"));
  EXPECT_EQ(PerlinNoise(permutation, 3, -8), 0);
  for (const double x : {0.3, 7.9, 254.7, 255.2}) {
    EXPECT_NEAR(PerlinNoise(permutation, x, 2.6), PerlinNoise(permutation, x + 256, 2.6), 1e-12);
    EXPECT_NEAR(PerlinNoise(permutation, x - 256, 2.6), PerlinNoise(permutation, x, 2.6), 1e-12);
  }
  EXPECT_NEAR(PerlinNoise(permutation, 256 - 1e-9, 0.5), PerlinNoise(permutation, 256 + 1e-9, 0.5),
              1e-8);
}

RC_GTEST_PROP(PerlinNoise, LiesWithinOneForAnyNumbers, ()) {
  const PerlinPermutation permutation =
      DrawPermutation(StreamKey(*rc::gen::arbitrary<uint64_t>(), "floor"));
  const double x = *rc::gen::arbitrary<double>();
  const double y = *rc::gen::arbitrary<double>();
  RC_ASSERT(std::abs(PerlinNoise(permutation, x, y)) <= 1);
  RC_ASSERT(std::abs(PerlinNoise(permutation, kNan, y)) <= 1);
  RC_ASSERT(std::isfinite(FractalNoise(permutation, {.count = kMaxOctaves}, x, y)));
}

TEST(NoiseFloor, ReachesFromItsLeastDepthToItsGreatest) {
  const NoiseFloor floor(Small(), StreamKey(5, "floor"));
  double least = 1e9;
  double most = 0;
  for (int x = -50; x < 50; ++x) {
    for (int y = -50; y < 50; ++y) {
      least = std::min(least, floor.DepthAt({x, y}));
      most = std::max(most, floor.DepthAt({x, y}));
    }
  }
  EXPECT_NEAR(least, 40, 1e-9);
  EXPECT_NEAR(most, 60, 1e-9);
}

TEST(NoiseFloor, IsTheSameForTheSameSeedOnly) {
  const auto depth = [](uint64_t seed) {
    return NoiseFloor(Small(), StreamKey(seed, "floor")).DepthAt({12, 34});
  };
  EXPECT_EQ(depth(1), depth(1));
  EXPECT_NE(depth(1), depth(2));
}

TEST(NoiseFloor, EndsInItsEdge) {
  const NoiseFloor floor(Small(), StreamKey(5, "floor"));
  EXPECT_EQ(floor.DepthAt({1e308, 7}), floor.DepthAt({50, 7}));
  EXPECT_EQ(floor.DepthAt({-51, 7}), floor.DepthAt({-50, 7}));
  EXPECT_EQ(floor.DepthAt({3, -1e308}), floor.DepthAt({3, -50}));
  EXPECT_EQ(floor.DepthAt({kNan, kNan}), floor.DepthAt({-50, -50}));
}

TEST(NoiseFloor, MaySlope) {
  NoiseFloorOptions options = Small(FloorStyle::kFlat);
  options.slope = {0.1, -0.02};
  const NoiseFloor floor(options, StreamKey(5, "floor"));
  EXPECT_NEAR(floor.DepthAt({0, 0}), 40, 1e-12);
  EXPECT_NEAR(floor.DepthAt({50, 0}), 45, 1e-12);
  EXPECT_NEAR(floor.DepthAt({0, 50}), 39, 1e-12);
  options.slope = {-10, 0};
  EXPECT_EQ(NoiseFloor(options, StreamKey(5, "floor")).DepthAt({50, 0}), 0);
}

TEST(NoiseFloor, OfAShelfHasACliffOfAQuarterOfItsRange) {
  EXPECT_DOUBLE_EQ(FloorShare(FloorStyle::kShelf, 0.5), 0.5);
  EXPECT_NEAR(FloorShare(FloorStyle::kShelf, 0.5 - 1e-12), 0.25, 1e-11);
  EXPECT_DOUBLE_EQ(FloorShare(FloorStyle::kShelf, 1), 0.75);
}

RC_GTEST_PROP(NoiseFloor, StaysWithinItsRangeEverywhere, ()) {
  const auto style = *rc::gen::element(FloorStyle::kFlat, FloorStyle::kLinear, FloorStyle::kSigmoid,
                                       FloorStyle::kShelf);
  NoiseFloorOptions options = Small(style);
  options.size_m = 20;
  options.octaves = {*rc::gen::inRange(1, kMaxOctaves + 1), *rc::gen::inRange(0, 101) / 100.0};
  const NoiseFloor floor(options, StreamKey(*rc::gen::arbitrary<uint64_t>(), "floor"));
  const double depth_m = floor.DepthAt({*rc::gen::arbitrary<double>(), Coordinate()});
  RC_ASSERT(depth_m >= 40);
  RC_ASSERT(depth_m <= 60);
}

RC_GTEST_PROP(NoiseFloor, HasNoStepsButAShelfsCliff, ()) {
  static const NoiseFloor linear(Small(), StreamKey(5, "floor"));
  static const NoiseFloor sigmoid(Small(FloorStyle::kSigmoid), StreamKey(5, "floor"));
  const Eigen::Vector2d position_m(Coordinate(), Coordinate());
  const Eigen::Vector2d beside_m = position_m + Eigen::Vector2d(1e-6, 1e-6);
  RC_ASSERT(std::abs(linear.DepthAt(beside_m) - linear.DepthAt(position_m)) < 1e-4);
  RC_ASSERT(std::abs(sigmoid.DepthAt(beside_m) - sigmoid.DepthAt(position_m)) < 1e-4);
}

RC_GTEST_PROP(NoiseFloor, IsNowhereAboveItsShallowestDepth, ()) {
  NoiseFloorOptions options = Small(FloorStyle::kSigmoid);
  options.slope = {*rc::gen::inRange(-100, 101) / 100.0, *rc::gen::inRange(-100, 101) / 100.0};
  const NoiseFloor floor(options, StreamKey(*rc::gen::arbitrary<uint64_t>(), "floor"));
  const double shallowest_m = floor.ShallowestDepth();
  RC_ASSERT(shallowest_m >= 0);
  RC_ASSERT(floor.DepthAt({Coordinate(), Coordinate()}) >= shallowest_m - 1e-9);
}

TEST(NoiseFloorOptions, ThatAreInvalidAreFound) {
  EXPECT_TRUE(IsNoiseFloor({}));
  for (const double nonsense : {kNan, std::numeric_limits<double>::infinity(), -1.0, 1e300}) {
    for (double NoiseFloorOptions::*number :
         {&NoiseFloorOptions::z_m, &NoiseFloorOptions::range_m, &NoiseFloorOptions::size_m,
          &NoiseFloorOptions::scale_m}) {
      NoiseFloorOptions options;
      options.*number = nonsense;
      EXPECT_FALSE(IsNoiseFloor(options)) << nonsense;
    }
  }
  NoiseFloorOptions options;
  options.octaves.count = 0;
  EXPECT_FALSE(IsNoiseFloor(options));
  options = {};
  options.slope.x() = kNan;
  EXPECT_FALSE(IsNoiseFloor(options));
}

}  // namespace shoal::noise_floor_test
