#include "lib/vehicle/guidance/path_parts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/task.h"
#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::path_parts_test {

using Points = std::vector<Eigen::Vector3d>;

const PathStart kStart{.position_m = {10, 20, 3}, .heading_rad = 0};

Points Joined(const std::vector<PathPart>& parts) { return Join(parts, kStart).path.points_m; }

PathPart Given(const Points& points_m) { return {.what = PointsPart{points_m}}; }

TEST(JoinedPath, HasItsPartsInOrderAndEqualPointsAtAJointOnce) {
  EXPECT_EQ(Joined({Given({{0, 0, 5}, {9, 0, 5}}), Given({{9, 0, 5}, {9, 9, 5}})}),
            (Points{{0, 0, 5}, {9, 0, 5}, {9, 9, 5}}));
  EXPECT_EQ(Joined({Given({{0, 0, 5}, {9, 0, 5}}), Given({{9, 0, 6}})}),
            (Points{{0, 0, 5}, {9, 0, 5}, {9, 0, 6}}));
}

TEST(JoinedPath, HasAnInsertedPartBeforeThePointThatItNames) {
  PathPart inserted = Given({{1, 1, 1}, {2, 2, 2}});
  inserted.insert_at = 1;
  EXPECT_EQ(Joined({Given({{0, 0, 5}, {9, 0, 5}}), inserted}),
            (Points{{0, 0, 5}, {1, 1, 1}, {2, 2, 2}, {9, 0, 5}}));
  inserted.insert_at = 0;
  EXPECT_EQ(Joined({Given({{0, 0, 5}}), inserted}), (Points{{1, 1, 1}, {2, 2, 2}, {0, 0, 5}}));
}

TEST(JoinedPath, LetsAPartWithoutAPlaceBeginWhereTheOneBeforeItEnds) {
  const PathPart yoyo{.what = YoyoPart{.to_m = {10, 20}}};
  EXPECT_EQ(Joined({yoyo}), (Points{kStart.position_m}));
  const PathPart random{.what = RandomPart{}};
  EXPECT_EQ(Joined({random}).front(), kStart.position_m);
  EXPECT_EQ(Joined({Given({{0, 0, 5}}), random}).size(), 2U);
  EXPECT_EQ(Joined({Given({{0, 0, 5}}), random}).front(), Eigen::Vector3d(0, 0, 5));
}

TEST(RandomPart, TurnsFromTheCourseOnWhichThePathBeforeItEnds) {
  RandomPart straight{.min_turn_deg = 30, .max_turn_deg = 30};
  const Points points_m = Joined({Given({{0, 0, 5}, {100, 0, 5}}), {.what = straight}});
  ASSERT_EQ(points_m.size(), 3U);
  EXPECT_NEAR(HeadingOf((points_m[2] - points_m[1]).head<2>()), DegToRad(120), 1e-9)
      << "to starboard of East";
  straight.start_heading_deg = 10;
  const Points turned_m = Joined({Given({{0, 0, 5}, {100, 0, 5}}), {.what = straight}});
  EXPECT_NEAR(HeadingOf((turned_m[2] - turned_m[1]).head<2>()), DegToRad(40), 1e-9);
}

RC_GTEST_PROP(RandomPart, StaysWithinAllItsLimits, (uint64_t seed)) {
  RandomPart part{.min_turn_deg = DrawBetween(-90, 0),
                  .max_turn_deg = DrawBetween(0, 90),
                  .start_heading_deg = 90,
                  .seed = seed};
  part.bounds.num_waypoints = 12;
  part.bounds.min_leg_m = DrawBetween(1, 50);
  part.bounds.max_leg_m = DrawBetween(50, 200);
  part.bounds.min_depth_m = DrawBetween(0, 20);
  part.bounds.max_depth_m = DrawBetween(20, 80);
  const Points points_m = Joined({{.what = part}});
  RC_ASSERT(points_m.size() == 13U);
  RC_ASSERT(points_m == Joined({{.what = part}}));
  double heading_rad = DegToRad(90);
  for (size_t i = 1; i < points_m.size(); ++i) {
    const Eigen::Vector2d way_m = (points_m[i] - points_m[i - 1]).head<2>();
    const double turn_deg = RadToDeg(WrapPi(HeadingOf(way_m) - heading_rad));
    RC_ASSERT(turn_deg >= part.min_turn_deg - 1e-6 && turn_deg <= part.max_turn_deg + 1e-6);
    RC_ASSERT(way_m.norm() >= part.bounds.min_leg_m - 1e-6);
    RC_ASSERT(way_m.norm() <= part.bounds.max_leg_m + 1e-6);
    RC_ASSERT(points_m[i].z() >= part.bounds.min_depth_m);
    RC_ASSERT(points_m[i].z() <= part.bounds.max_depth_m);
    heading_rad = HeadingOf(way_m);
  }
}

TEST(LawnmowerPart, PassesTheLanesOfASurvey) {
  const SurveyArea area{.polygon_m = {{0, 0}, {300, 0}, {300, 140}, {0, 200}},
                        .lane_spacing_m = 30};
  const SurveyRoute route{.start_m = kStart.position_m.head<2>(), .turn_radius_m = 12};
  SurveyTask survey;
  survey.area = area;
  survey.route = route;
  const std::vector<Eigen::Vector2d> lanes_m = PointsOf(survey);
  const Points points_m =
      Joined({{.what = LawnmowerPart{.area = area, .route = {.turn_radius_m = 12}, .depth_m = 8}}});
  ASSERT_EQ(points_m.size(), lanes_m.size());
  ASSERT_GT(lanes_m.size(), 10U);
  for (size_t i = 0; i < lanes_m.size(); ++i) {
    EXPECT_EQ(points_m[i].head<2>(), lanes_m[i]);
    EXPECT_EQ(points_m[i].z(), 8);
  }
}

TEST(HelixPart, LiesOnItsCircleAndDescendsEvenly) {
  for (const bool clockwise : {true, false}) {
    const HelixPart part{.center_m = {100, 50},
                         .radius_m = 40,
                         .turns = 2.25,
                         .start_depth_m = 30,
                         .end_depth_m = 10,
                         .start_bearing_deg = 90,
                         .clockwise = clockwise};
    const Points points_m = Joined({{.what = part}});
    EXPECT_EQ(static_cast<double>(points_m.size()), CountPoints(part));
    EXPECT_LT((points_m.front() - Eigen::Vector3d(140, 50, 30)).norm(), 1e-9);
    const double end_y_m = clockwise ? 10 : 90;  // A quarter on from East.
    EXPECT_LT((points_m.back() - Eigen::Vector3d(100, end_y_m, 10)).norm(), 1e-9);
    for (size_t i = 1; i < points_m.size(); ++i) {
      EXPECT_NEAR((points_m[i].head<2>() - part.center_m).norm(), 40, 1e-9);
      EXPECT_NEAR(points_m[i].z() - points_m[i - 1].z(), points_m[1].z() - points_m[0].z(), 1e-9);
    }
  }
}

TEST(YoyoPart, TurnsAtItsDepthsAndGlidesAtItsSlope) {
  const YoyoPart part{.start_m = {{0, 0, 5}},
                      .to_m = {0, 400},
                      .top_m = 5,
                      .bottom_m = 40,
                      .glide_deg = RadToDeg(std::atan(0.25))};
  const Points points_m = Joined({{.what = part}});
  const Points expected_m = {{0, 0, 5}, {0, 140, 40}, {0, 280, 5}, {0, 400, 35}};
  ASSERT_EQ(points_m.size(), expected_m.size());
  for (size_t i = 0; i < expected_m.size(); ++i) {
    EXPECT_LT((points_m[i] - expected_m[i]).norm(), 1e-9);
  }
}

RC_GTEST_PROP(YoyoPart, StaysBetweenItsDepthsAndEndsWhereItLeads, ()) {
  const YoyoPart part{.start_m = VectorWithin(100) + Eigen::Vector3d(0, 0, 100),
                      .to_m = VectorWithin(1000).head<2>(),
                      .top_m = DrawBetween(0, 50),
                      .bottom_m = DrawBetween(51, 200),
                      .glide_deg = DrawBetween(1, 60)};
  const Points points_m = Joined({{.what = part}});
  RC_ASSERT(static_cast<double>(points_m.size()) <= CountPoints(part, *part.start_m) + 1);
  RC_ASSERT((points_m.back().head<2>() - part.to_m).norm() < 1e-6);
  const double slope = std::tan(DegToRad(part.glide_deg));
  for (size_t i = 1; i < points_m.size(); ++i) {
    const Eigen::Vector3d way_m = points_m[i] - points_m[i - 1];
    RC_ASSERT(std::abs(std::abs(way_m.z()) - slope * way_m.head<2>().norm()) < 1e-6);
    RC_ASSERT(points_m[i].z() >= std::min(part.top_m, part.start_m->z()) - 1e-9);
    RC_ASSERT(points_m[i].z() <= std::max(part.bottom_m, part.start_m->z()) + 1e-9);
  }
}

TEST(RoundedCorners, AreArcsThatTouchBothLegs) {
  const JoinedPath corner{.path = {{{0, 0, 10}, {100, 0, 20}, {100, 100, 30}}}};
  const Points points_m = RoundCorners(corner, 25).path.points_m;
  ASSERT_GT(points_m.size(), 5U);
  EXPECT_TRUE(RoundCorners(corner, 25).has_curves);
  EXPECT_LT((points_m[1] - Eigen::Vector3d(75, 0, 20)).norm(), 1e-9);
  EXPECT_LT((points_m[points_m.size() - 2] - Eigen::Vector3d(100, 25, 20)).norm(), 1e-9);
  double nearest_m = 1e9;
  for (size_t i = 1; i + 1 < points_m.size(); ++i) {
    EXPECT_NEAR((points_m[i].head<2>() - Eigen::Vector2d(75, 25)).norm(), 25, 1e-9);
    nearest_m = std::min(nearest_m, (points_m[i].head<2>() - Eigen::Vector2d(100, 0)).norm());
  }
  EXPECT_NEAR(nearest_m, 25 * (std::sqrt(2) - 1), 0.2) << "R (1 / cos(turn / 2) - 1)";
}

TEST(RoundedCorners, AreAsWideAsHalfALegAllows) {
  const JoinedPath corner{.path = {{{0, 0, 10}, {20, 0, 10}, {20, -100, 10}}}};
  const Points points_m = RoundCorners(corner, 25).path.points_m;
  EXPECT_LT((points_m[1] - Eigen::Vector3d(10, 0, 10)).norm(), 1e-9);
  for (size_t i = 1; i + 1 < points_m.size(); ++i) {
    EXPECT_NEAR((points_m[i].head<2>() - Eigen::Vector2d(10, -10)).norm(), 10, 1e-9);
  }
}

TEST(RoundedCorners, LeaveSlightTurnsAndTurnsRightRoundAsTheyAre) {
  const JoinedPath path{
      .path = {{{0, 0, 5}, {100, 0, 9}, {200, 20, 5}, {100, 0, 9}, {100, 0, 20}}}};
  EXPECT_EQ(RoundCorners(path, 25), path);
}

RC_GTEST_PROP(RoundedCorners, MakeAFlatPathShorter, ()) {
  JoinedPath path;
  for (int i = 0; i < 5; ++i) {
    path.path.points_m.emplace_back(DrawBetween(-300, 300), DrawBetween(-300, 300), 10);
  }
  const double radius_m = DrawBetween(1, 80);
  const Points points_m = RoundCorners(path, radius_m).path.points_m;
  RC_ASSERT(points_m.front() == path.path.points_m.front());
  RC_ASSERT(points_m.back() == path.path.points_m.back());
  RC_ASSERT(TotalLength_m({points_m}) <= TotalLength_m(path.path) + 1e-6);
  for (const Eigen::Vector3d& point_m : points_m) RC_ASSERT(point_m.allFinite());
}

}  // namespace shoal::path_parts_test
