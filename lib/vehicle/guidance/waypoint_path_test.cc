#include "lib/vehicle/guidance/waypoint_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::waypoint_path_test {

const WaypointPath kPath{{{0, 500, 20}, {500, 500, 20}, {1000, 500, 20}}};

WaypointPath AnyPath() {
  WaypointPath path;
  for (int i = *rc::gen::inRange(0, 8); i > 0; --i) path.points_m.push_back(VectorWithin(1000));
  return path;
}

TEST(WaypointPath, TakesAPointBeforeAnIndexAndAtItsEnd) {
  const WaypointPath path = Insert(kPath, 1, {250, 400, 25});
  ASSERT_EQ(path.points_m.size(), 4U);
  EXPECT_EQ(path.points_m[1], Eigen::Vector3d(250, 400, 25));
  EXPECT_EQ(path.points_m[2], kPath.points_m[1]);
  EXPECT_EQ(Insert(kPath, 3, {1, 2, 3}).points_m.back(), Eigen::Vector3d(1, 2, 3));
  EXPECT_DEATH((void)Insert(kPath, 4, {1, 2, 3}), "inserted within the path");
}

// The numbers of the specification's example.
TEST(WaypointPath, HasTheLengthsAndHeadingsOfItsLegs) {
  const WaypointPath path = Insert(kPath, 1, {250, 400, 25});
  const std::vector<double> lengths_m = LegLengths_m(path);
  ASSERT_EQ(lengths_m.size(), 3U);
  EXPECT_NEAR(lengths_m[0], 269.30466019, 1e-8);
  EXPECT_NEAR(lengths_m[2], 500, 1e-12);
  EXPECT_NEAR(TotalLength_m(path), 1038.6, 0.05);
  EXPECT_NEAR(EstimateTime_s(path, 2.0), 623.2, 0.05);
  const std::vector<double> psis_rad = LegPsis_rad(path);
  EXPECT_NEAR(psis_rad[0], -0.38050638, 1e-8);
  EXPECT_NEAR(psis_rad[1], 0.38050638, 1e-8);
  EXPECT_EQ(psis_rad[2], 0);
}

TEST(WaypointPath, OfOnePointOrNoneHasNoLegs) {
  for (const WaypointPath& path : {WaypointPath{}, WaypointPath{{{1, 2, 3}}}}) {
    EXPECT_TRUE(LegLengths_m(path).empty());
    EXPECT_TRUE(LegPsis_rad(path).empty());
    EXPECT_EQ(TotalLength_m(path), 0);
    EXPECT_EQ(EstimateTime_s(path), 0);
    EXPECT_EQ(EstimateArea(path, 100).side_m, 200);
  }
}

TEST(WaypointPath, LendsALegWithoutHorizontalLengthTheHeadingOfItsNeighbour) {
  const double north_rad = kPi / 2;
  const WaypointPath dive{{{0, 0, 0}, {0, 0, 20}, {0, 50, 20}, {0, 50, 40}, {-10, 50, 40}}};
  EXPECT_EQ(LegPsis_rad(dive), (std::vector<double>{north_rad, north_rad, north_rad, kPi}));
  EXPECT_EQ(LegPsis_rad({{{5, 5, 0}, {5, 5, 9}}}), std::vector<double>{0});
}

TEST(WaypointPath, LiesInASquareWhosePaddingIsKeptOnAllSides) {
  const BoundingSquare area = EstimateArea({{{100, 200, 0}, {350.5, 300, 0}}}, 50);
  EXPECT_EQ(area.side_m, 351);
  EXPECT_EQ(area.origin_m, Eigen::Vector2d(-50, -150));
}

RC_GTEST_PROP(WaypointPath, HasFiniteEstimatesForAnyFinitePoints, ()) {
  WaypointPath path;
  for (int i = *rc::gen::inRange(0, 5); i > 0; --i) path.points_m.push_back(AnyFiniteVector());
  for (const double length_m : LegLengths_m(path)) RC_ASSERT(std::isfinite(length_m));
  for (const double psi_rad : LegPsis_rad(path)) RC_ASSERT(std::abs(psi_rad) <= kPi);
  const double speed_mps = std::abs(AnyFinite());
  if (speed_mps > 0) RC_ASSERT(std::isfinite(EstimateTime_s(path, speed_mps)));
  const BoundingSquare area = EstimateArea(path, std::abs(AnyFinite()));
  RC_ASSERT(std::isfinite(area.side_m));
  RC_ASSERT(area.origin_m.allFinite());
}

RC_GTEST_PROP(RandomPath, StaysWithinItsBounds, (uint64_t seed)) {
  const RandomPathParams params{.num_waypoints = 10,
                                .start_m = {5, -3, 7},
                                .start_psi_rad = 2,
                                .min_turn_rad = -0.5,
                                .max_turn_rad = 1,
                                .min_depth_m = 20,
                                .max_depth_m = 30};
  Stream stream(seed, "path");
  const WaypointPath path = RandomPath(params, stream);
  RC_ASSERT(path.points_m.size() == 11U);
  RC_ASSERT(path.points_m.front() == params.start_m);
  double last_rad = params.start_psi_rad;
  for (size_t i = 1; i < path.points_m.size(); ++i) {
    const Eigen::Vector3d way_m = path.points_m[i] - path.points_m[i - 1];
    const double length_m = way_m.head<2>().norm();
    RC_ASSERT(length_m > 100 - 1e-6 && length_m < 200 + 1e-6);
    RC_ASSERT(path.points_m[i].z() >= 20 && path.points_m[i].z() <= 30);
    const double psi_rad = std::atan2(way_m.y(), way_m.x());
    const double turn_rad = WrapPi(psi_rad - last_rad);
    RC_ASSERT(turn_rad > -0.5 - 1e-6 && turn_rad < 1 + 1e-6);
    last_rad = psi_rad;
  }
}

TEST(RandomPath, DependsOnTheSeedAndOnNothingElse) {
  const auto path = [](uint64_t seed) {
    Stream stream(seed, "path");
    return RandomPath({.num_waypoints = 5}, stream);
  };
  EXPECT_EQ(path(1), path(1));
  EXPECT_NE(path(1), path(2));
}

}  // namespace shoal::waypoint_path_test
