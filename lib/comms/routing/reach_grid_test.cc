#include "lib/comms/routing/reach_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "lib/comms/routing/traffic_testing.h"

namespace shoal::reach_grid_test {

constexpr double kLargest = std::numeric_limits<double>::max();

std::vector<int32_t> Near(const ReachGrid& grid, const Eigen::Vector3d& center_m, double reach_m) {
  std::vector<int32_t> indices;
  grid.AppendNear(center_m, reach_m, &indices);
  std::sort(indices.begin(), indices.end());
  return indices;
}

using Indices = std::vector<int32_t>;

/// Vehicles 0 to 9 every kilometre along x, in squares of 100 m.
ReachGrid MakeRow() {
  ReachGrid grid;
  grid.Reset(100);
  for (int32_t i = 0; i < 10; ++i) grid.Put(i, {1000.0 * i, 0, 0});
  return grid;
}

TEST(ReachGrid, FindsTheNearAndNotTheFar) {
  EXPECT_EQ(Near(MakeRow(), {3000, 0, 0}, 100), Indices{3});
  EXPECT_EQ(Near(MakeRow(), {3500, 0, 0}, 100), Indices{});
}

TEST(ReachGrid, FindsVehiclesExactlyInReach) {
  EXPECT_EQ(Near(MakeRow(), {3100, 0, 0}, 100), Indices{3});
  EXPECT_EQ(Near(MakeRow(), {2900, 0, 0}, 100), Indices{3});
  EXPECT_EQ(Near(MakeRow(), {3000, -100, 0}, 100), Indices{3});
}

TEST(ReachGrid, DoesNotAskForTheDepth) {
  EXPECT_EQ(Near(MakeRow(), {3000, 0, 1e9}, 100), Indices{3});
}

TEST(ReachGrid, FollowsVehiclesThatMove) {
  ReachGrid grid = MakeRow();
  grid.Put(3, {3050, 5000, 0});
  EXPECT_EQ(Near(grid, {3000, 0, 0}, 100), Indices{});
  EXPECT_EQ(Near(grid, {3000, 5000, 0}, 100), Indices{3});
}

TEST(ReachGrid, LosesRemovedVehiclesAndAcceptsUnknownOnes) {
  ReachGrid grid = MakeRow();
  grid.Remove(3);
  grid.Remove(3);
  grid.Remove(99);
  EXPECT_EQ(Near(grid, {3000, 0, 0}, 100), Indices{});
  grid.Put(3, {3000, 0, 0});
  EXPECT_EQ(Near(grid, {3000, 0, 0}, 100), Indices{3});
}

TEST(ReachGrid, IsEmptyAfterReset) {
  ReachGrid grid = MakeRow();
  grid.Reset(50);
  EXPECT_EQ(grid.side_m(), 50);
  EXPECT_EQ(Near(grid, {0, 0, 0}, 1e6), Indices{});
}

TEST(ReachGrid, AnswersAtOnceWhereTheReachIsOfAnySize) {
  ReachGrid grid;
  for (const double side_m : {1.0, 250.0, kLargest, std::numeric_limits<double>::infinity()}) {
    grid.Reset(side_m);
    grid.Put(0, {0, 0, 0});
    grid.Put(1, {kLargest, -kLargest, 0});
    grid.Put(2, {-1e17, 1e17, 0});
    for (const double reach_m : {kLargest, std::numeric_limits<double>::infinity()}) {
      EXPECT_EQ(Near(grid, {0, 0, 0}, reach_m), (Indices{0, 1, 2})) << side_m;
    }
  }
}

RC_GTEST_PROP(ReachGrid, NeverMissesAVehicleInReach, (uint64_t seed)) {
  RandomTraffic traffic(seed, {"unused"});
  ReachGrid grid;
  const double side_m = traffic.dice.Pick({1.0, 30.0, 250.0, 1e9});
  grid.Reset(side_m);
  std::map<int32_t, Eigen::Vector3d> places;
  for (int i = 0; i < 100; ++i) {
    const auto index = static_cast<int32_t>(traffic.dice.Below(30));
    const Eigen::Vector3d position_m = traffic.Position();
    if (!position_m.allFinite()) {
      grid.Remove(index);
      places.erase(index);
    } else {
      grid.Put(index, position_m);
      places[index] = position_m;
    }
  }
  for (const auto& [from, center_m] : places) {
    const double reach_m = side_m * traffic.dice.Pick({0.0, 0.5, 1.0, 3.0});
    const std::vector<int32_t> near = Near(grid, center_m, reach_m);
    RC_ASSERT(std::adjacent_find(near.begin(), near.end()) == near.end());
    for (const auto& [to, position_m] : places) {
      const Eigen::Vector2d apart_m = (position_m - center_m).head<2>();
      if (apart_m.cwiseAbs().maxCoeff() > reach_m) continue;
      RC_ASSERT(std::binary_search(near.begin(), near.end(), to));
    }
    for (const int32_t to : near) RC_ASSERT(places.contains(to));
  }
}

}  // namespace shoal::reach_grid_test
