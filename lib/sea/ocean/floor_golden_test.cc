// Compares synthetic floors with MuNet's, with MuNet's permutations: the random numbers differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "lib/sea/ocean/noise_floor.h"
#include "tests/golden/read_golden.h"

namespace shoal::floor_golden_test {

struct GoldenFloor {
  NoiseFloorOptions options;
  PerlinPermutation permutation = {};
  NoiseBounds bounds;
};

std::optional<FloorStyle> StyleNamed(const std::string& name) {
  if (name == "linear") return FloorStyle::kLinear;
  if (name == "sigmoid") return FloorStyle::kSigmoid;
  if (name == "shelf") return FloorStyle::kShelf;
  if (name == "flat") return FloorStyle::kFlat;
  return std::nullopt;
}

GoldenFloor ReadFloor(const nlohmann::json& golden) {
  GoldenFloor floor;
  floor.options = {.style = StyleNamed(golden.at("style")).value(),
                   .z_m = golden.at("z"),
                   .range_m = golden.at("z_range"),
                   .size_m = golden.at("size"),
                   .scale_m = golden.at("scale"),
                   .octaves = {golden.at("octaves"), golden.at("persistence")},
                   .south_west_m = {-golden.at("origin")[0].get<double>(),
                                    -golden.at("origin")[1].get<double>()}};
  if (golden.contains("permutation256")) {
    const auto values = golden.at("permutation256").get<std::vector<uint8_t>>();
    std::copy_n(values.begin(), 256, floor.permutation.begin());
    floor.bounds = {golden.at("norm_min"), golden.at("norm_diff")};
  }
  return floor;
}

TEST(GoldenFloor, HasMunetsNoise) {
  int compared = 0;
  for (const auto& golden : ReadGoldenJson("munet/floor_perlin.json")) {
    if (!golden.contains("raw_noise_i_j_value")) continue;
    const GoldenFloor floor = ReadFloor(golden);
    for (const auto& row : golden.at("raw_noise_i_j_value")) {
      const double scale_m = floor.options.scale_m;
      const double noise =
          (FractalNoise(floor.permutation, floor.options.octaves, row[0].get<double>() / scale_m,
                        row[1].get<double>() / scale_m) -
           floor.bounds.min) /
          floor.bounds.span;
      EXPECT_NEAR(noise, row[2], 1e-12) << row;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 60);
}

// MuNet has one depth per square metre; shoal is compared at the corners of these squares.
TEST(GoldenFloor, HasMunetsDepthsInAllStyles) {
  int compared = 0;
  for (const auto& golden : ReadGoldenJson("munet/floor_perlin.json")) {
    const GoldenFloor given = ReadFloor(golden);
    const NoiseFloor floor(given.options, given.permutation, given.bounds);
    for (const auto& row : golden.at("points_x_y_col_row_depth")) {
      const Eigen::Vector2d corner_m =
          given.options.south_west_m + Eigen::Vector2d(row[2].get<double>(), row[3].get<double>());
      EXPECT_NEAR(floor.DepthAt(corner_m), row[4], 1e-12 * row[4].get<double>())
          << golden.at("style") << row;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 300);
}

// MuNet looks for them on 1000 x 1000 m, whatever the size of the map; shoal on the map.
TEST(GoldenFloor, FindsMunetsBoundsOnAMapOf1000Metres) {
  const nlohmann::json all = ReadGoldenJson("munet/floor_perlin.json");
  GoldenFloor given = ReadFloor(all.at(0));
  given.options.size_m = 1000;
  const NoiseFloor floor(given.options, given.permutation);
  EXPECT_NEAR(floor.bounds().min, given.bounds.min, 1e-12);
  EXPECT_NEAR(floor.bounds().span, given.bounds.span, 1e-12);
}

}  // namespace shoal::floor_golden_test
