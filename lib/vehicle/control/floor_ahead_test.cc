#include "lib/vehicle/control/floor_ahead.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

namespace shoal::floor_ahead_test {

constexpr Clearance kAtTwo = {.clearance_m = 5, .max_slope = 0.25, .speed_mps = 2};

TEST(BoundOver, HasNoneWhereNoFloorIsKnown) {
  EXPECT_TRUE(std::isinf(BoundOver({}, kAtTwo).now_m));
  EXPECT_TRUE(std::isinf(BoundOver({}, kAtTwo).later_m));
}

TEST(BoundOver, KeepsTheClearanceOverALevelFloor) {
  const std::vector<FloorPoint> floor = {{0, 40}, {100, 40}};
  const DepthBound bound = BoundOver(floor, kAtTwo);
  EXPECT_DOUBLE_EQ(bound.now_m, 35);
  EXPECT_DOUBLE_EQ(bound.later_m, 35);
}

TEST(BoundOver, RisesWithASlopeThatCanBeClimbed) {
  const std::vector<FloorPoint> floor = {{0, 40}, {100, 20}};  // 1:5
  const DepthBound bound = BoundOver(floor, kAtTwo);
  EXPECT_DOUBLE_EQ(bound.now_m, 35);
  EXPECT_DOUBLE_EQ(bound.soon_m, 35 - 0.2 * 2 * DepthBound::kLead_s);
  EXPECT_NEAR(bound.soon_m - bound.later_m, 0.2 * 2, 1e-9);
}

TEST(BoundOver, BeginsTheClimbOverACliffAsFarAheadAsItTakes) {
  const std::vector<FloorPoint> floor = {{0, 40}, {60, 40}, {60, 20}, {100, 20}};
  // 20 m of it at 1:4 take 80 m: at 60 m the vehicle must have climbed 5 m already.
  EXPECT_DOUBLE_EQ(BoundOver(floor, kAtTwo).now_m, 20 - 5 + 0.25 * 60);
}

TEST(BoundOver, ReadsSlopesBetweenThePointsAndGoesOnLevelBehindThem) {
  const std::vector<FloorPoint> floor = {{0, 40}, {4, 39}};
  const DepthBound bound = BoundOver(floor, kAtTwo);
  EXPECT_DOUBLE_EQ(bound.soon_m, 40 - 0.75 - 5);
  EXPECT_DOUBLE_EQ(bound.later_m, 34);
}

RC_GTEST_PROP(BoundOver, IsNeverDeeperThanTheFloorLessTheClearanceNorSteeperThanCanBeClimbed, ()) {
  std::vector<FloorPoint> floor = {{0, 50}};
  for (int i = 0; i < 20; ++i) {
    floor.push_back({floor.back().ahead_m + 0.5 * *rc::gen::inRange(0, 10),
                     static_cast<double>(*rc::gen::inRange(10, 90))});
  }
  const DepthBound bound = BoundOver(floor, kAtTwo);
  RC_ASSERT(bound.now_m <= floor.front().z_m - 5);
  RC_ASSERT(bound.soon_m - bound.later_m <= 0.25 * 2 + 1e-9);
  RC_ASSERT(bound.now_m - bound.soon_m <= 0.25 * 3 + 1e-9);
}

TEST(FloorLine, FollowsASlopeWithoutLag) {
  FloorLine line;
  for (int i = 0; i <= 100; ++i) line.Update(60 - 0.025 * i, 0.1);  // 0.25 m/s
  const std::vector<FloorPoint> ahead = line.Ahead(20, 2);
  ASSERT_EQ(ahead.size(), 2U);
  EXPECT_NEAR(ahead[0].z_m, 57.5, 0.01);
  EXPECT_NEAR(ahead[1].z_m, 57.5 - 20 / 8.0, 0.05);
}

TEST(FloorLine, KnowsNoSlopeAtRestAndNothingOnceLost) {
  FloorLine line;
  EXPECT_TRUE(line.Ahead(20, 2).empty());
  line.Update(60, 0.1);
  EXPECT_EQ(line.Ahead(20, 0).size(), 1U);
  line.Lose();
  EXPECT_TRUE(line.Ahead(20, 2).empty());
}

TEST(FloorLine, SmoothsTheNoiseOfAnAltimeter) {
  FloorLine line;
  for (int i = 0; i < 100; ++i) line.Update(60 + (i % 2 == 0 ? 0.2 : -0.2), 0.1);
  const std::vector<FloorPoint> ahead = line.Ahead(20, 2);
  EXPECT_NEAR(ahead[0].z_m, 60, 0.05);
  EXPECT_NEAR(ahead[1].z_m, 60, 0.5);
}

}  // namespace shoal::floor_ahead_test
