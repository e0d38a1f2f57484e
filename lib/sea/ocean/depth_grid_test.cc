#include "lib/sea/ocean/depth_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "lib/sea/ocean/sea_floor.h"

namespace shoal::depth_grid_test {

// 30 40 50     in the North
// 10 20 60     in the South
DepthGrid SixPoints() {
  return DepthGrid({.columns = 3, .rows = 2, .south_west_m = {100, 200}, .cell_m = {10, 20}},
                   {10, 20, 60, 30, 40, 50});
}

TEST(DepthGrid, IsExactAtItsPoints) {
  EXPECT_EQ(SixPoints().DepthAt({100, 200}), 10);
  EXPECT_EQ(SixPoints().DepthAt({110, 200}), 20);
  EXPECT_EQ(SixPoints().DepthAt({120, 200}), 60);
  EXPECT_EQ(SixPoints().DepthAt({100, 220}), 30);
  EXPECT_EQ(SixPoints().DepthAt({120, 220}), 50);
}

TEST(DepthGrid, IsLinearBetweenTwoPointsAndTheMeanInTheMiddleOfFour) {
  EXPECT_DOUBLE_EQ(SixPoints().DepthAt({102.5, 200}), 12.5);
  EXPECT_DOUBLE_EQ(SixPoints().DepthAt({100, 205}), 15);
  EXPECT_DOUBLE_EQ(SixPoints().DepthAt({105, 210}), 25);
}

TEST(DepthGrid, EndsInItsEdge) {
  EXPECT_EQ(SixPoints().DepthAt({-1e9, -1e9}), 10);
  EXPECT_EQ(SixPoints().DepthAt({1e308, 1e308}), 50);
  EXPECT_EQ(SixPoints().DepthAt({110, -1e308}), 20);
  EXPECT_DOUBLE_EQ(SixPoints().DepthAt({-5, 210}), 20);
}

TEST(DepthGrid, IsNowhereAboveItsShallowestDepth) {
  EXPECT_EQ(SixPoints().ShallowestDepth(), 10);
  EXPECT_EQ(SeaFloor(std::make_shared<const DepthGrid>(SixPoints())).ShallowestDepth(), 10);
}

TEST(DepthGrid, TakesNaNForTheWesternOrSouthernEdge) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(SixPoints().DepthAt({kNan, kNan}), 10);
  EXPECT_EQ(SixPoints().DepthAt({120, kNan}), 60);
}

TEST(DepthGrid, OfOnePointIsFlat) {
  const DepthGrid grid({}, {42});
  EXPECT_EQ(grid.DepthAt({0, 0}), 42);
  EXPECT_EQ(grid.DepthAt({-3, 9}), 42);
}

RC_GTEST_PROP(DepthGrid, NeverLeavesTheDepthsAroundAndHasNoSteps, ()) {
  std::vector<float> depths_m;
  for (int i = 0; i < 20; ++i) {
    depths_m.push_back(static_cast<float>(*rc::gen::inRange(0, 1000)) / 7);
  }
  const auto [least, most] = std::minmax_element(depths_m.begin(), depths_m.end());
  const DepthGrid grid({.columns = 5, .rows = 4, .south_west_m = {-20, 3}, .cell_m = {10, 7}},
                       depths_m);
  const Eigen::Vector2d position_m(*rc::gen::inRange(-4000, 4000) / 100.0,
                                   *rc::gen::inRange(-1000, 4000) / 100.0);
  const double depth_m = grid.DepthAt(position_m);
  RC_ASSERT(depth_m >= *least);
  RC_ASSERT(depth_m <= *most);
  const double steepest = (*most - *least) / 7 * 2;
  RC_ASSERT(std::abs(grid.DepthAt(position_m + Eigen::Vector2d(1e-3, -1e-3)) - depth_m) <=
            steepest * 2e-3);
}

TEST(SeaFloor, IsDeepByDefaultAndSharesItsGrid) {
  EXPECT_EQ(SeaFloor().DepthAt({1e5, -1e5}), kDeepSea_m);
  EXPECT_EQ(FlatFloor(0).DepthAt({3, 4}), 0);
  const auto grid = std::make_shared<const DepthGrid>(SixPoints());
  const SeaFloor floor(grid);
  const SeaFloor copy = floor;
  EXPECT_EQ(copy.DepthAt({120, 200}), 60);
  EXPECT_EQ(grid.use_count(), 3);
}

}  // namespace shoal::depth_grid_test
