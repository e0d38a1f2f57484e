#include "lib/helm/behaviors/behavior_outline.h"

#include <gtest/gtest.h>

namespace shoal::behavior_outline_test {

using Points = std::vector<Eigen::Vector2d>;

TEST(BehaviorOutline, OfAWaypointBehaviorIsItsPointsInTheOrderInWhichTheyAreSteeredFor) {
  WaypointOptions options{.points = {{0, 0}, {10, 0}}};
  auto outlines = OutlinesOf(options);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].points_m, (Points{{0, 0}, {10, 0}}));
  EXPECT_FALSE(outlines[0].closed);
  options.order = "reverse";
  options.repeat = -1;
  outlines = OutlinesOf(options);
  EXPECT_EQ(outlines[0].points_m, (Points{{10, 0}, {0, 0}}));
  EXPECT_TRUE(outlines[0].closed) << "a leg leads back to the first";
}

TEST(BehaviorOutline, OfALoiterAndOfAStationIsWhereTheMissionPutsThem) {
  LoiterOptions loiter{.polygon = {{0, 0}, {10, 0}, {10, 10}}};
  EXPECT_TRUE(OutlinesOf(loiter).at(0).closed);
  loiter.center_activate = true;
  EXPECT_TRUE(OutlinesOf(loiter).empty()) << "it moves to where the vehicle is";
  StationKeepOptions station{.station_pt = Eigen::Vector2d(3, 4), .outer_radius = 20};
  EXPECT_EQ(OutlinesOf(station).at(0).points_m, (Points{{3, 4}}));
  EXPECT_EQ(OutlinesOf(station).at(0).radius_m, 20);
  EXPECT_TRUE(OutlinesOf(StationKeepOptions{.center_activate = true}).empty());
  EXPECT_EQ(OutlinesOf(RubberBandOptions{.point = Eigen::Vector2d(1, 2)}).size(), 1u);
  EXPECT_TRUE(OutlinesOf(RubberBandOptions{}).empty());
}

TEST(BehaviorOutline, OfALegRunIsItsLeg) {
  const LegRunOptions options{.p1 = Eigen::Vector2d(0, 0), .p2 = Eigen::Vector2d(50, 0)};
  EXPECT_EQ(OutlinesOf(options).at(0).points_m, (Points{{0, 0}, {50, 0}}));
  EXPECT_TRUE(OutlinesOf(LegRunOptions{}).empty());
}

TEST(BehaviorOutline, OfARegionIsEachOfItsZones) {
  OpRegionOptions options{.core_poly = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  EXPECT_EQ(OutlinesOf(options).size(), 1u);
  options.save_dist = 5;
  options.halt_poly = {{-20, -20}, {30, -20}, {30, 30}, {-20, 30}};
  const auto zones = OutlinesOf(options);
  ASSERT_EQ(zones.size(), 3u);
  EXPECT_EQ(zones[0].area_m, options.core_poly);
  EXPECT_GT(zones[1].area_m.size(), 4u) << "grown, its corners made round";
  EXPECT_EQ(zones[2].area_m, options.halt_poly);
}

TEST(BehaviorOutline, IsThereForEachKindWithItsDefaults) {
  size_t num = 0;
  for (const AnyBehavior& what : OneBehaviorOfEachKind()) num += OutlinesOf(what).size();
  EXPECT_LT(num, OneBehaviorOfEachKind().size());
}

}  // namespace shoal::behavior_outline_test
