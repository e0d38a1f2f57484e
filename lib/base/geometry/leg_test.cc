#include "lib/base/geometry/leg.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal::leg_test {

Eigen::Vector2d AnyPoint() {
  const auto coordinate = rc::gen::inRange(-100'000, 100'001);
  return {*coordinate / 100.0, *coordinate / 100.0};
}

TEST(Leg, SeesAPointToTheEastOfANorthboundLegToStarboard) {
  const Leg north{.from_m = {0, 0}, .to_m = {0, 100}};
  const TrackPosition track = Project(north, {7, 30});
  EXPECT_DOUBLE_EQ(track.along_m, 30);
  EXPECT_DOUBLE_EQ(track.cross_track_m, 7);
  EXPECT_EQ(Course(north), 0);
}

TEST(Leg, SeesAPointToTheNorthOfAnEastboundLegToPort) {
  const TrackPosition track = Project({.from_m = {10, 10}, .to_m = {60, 10}}, {0, 14});
  EXPECT_DOUBLE_EQ(track.along_m, -10);
  EXPECT_DOUBLE_EQ(track.cross_track_m, -4);
}

TEST(Leg, CountsAsPointingNorthWithoutLength) {
  const TrackPosition track = Project({.from_m = {5, 5}, .to_m = {5, 5}}, {6, 8});
  EXPECT_DOUBLE_EQ(track.along_m, 3);
  EXPECT_DOUBLE_EQ(track.cross_track_m, 1);
}

TEST(Leg, IsBehindAVesselPastTheLineThroughItsEndHoweverFarAbeam) {
  const Leg leg{.from_m = {0, 0}, .to_m = {0, 10}};
  EXPECT_FALSE(IsBeyond(leg, {500, 9.9}));
  EXPECT_TRUE(IsBeyond(leg, {500, 10.1}));
  EXPECT_FALSE(IsBeyond(leg, {500, 12.9}, 3));
  EXPECT_TRUE(IsBeyond(leg, {500, 13.1}, 3));
}

RC_GTEST_PROP(Leg, PutsAPointBackWhereItWasByCourseAndTrackPosition, ()) {
  const Leg leg{.from_m = AnyPoint(), .to_m = AnyPoint()};
  const Eigen::Vector2d point_m = AnyPoint();
  const TrackPosition track = Project(leg, point_m);
  const double course_rad = Course(leg);
  const Eigen::Vector2d rebuilt_m = leg.from_m + track.along_m * UnitVector(course_rad) +
                                    track.cross_track_m * UnitVector(course_rad + kPi / 2);
  RC_ASSERT((rebuilt_m - point_m).norm() < 1e-8);
}

RC_GTEST_PROP(Leg, HasTheOppositeCrossTrackErrorWhenReversed, ()) {
  const Leg leg{.from_m = AnyPoint(), .to_m = AnyPoint()};
  RC_PRE(Length(leg) > 0.01);
  const Eigen::Vector2d point_m = AnyPoint();
  const TrackPosition there = Project(leg, point_m);
  const TrackPosition back = Project({.from_m = leg.to_m, .to_m = leg.from_m}, point_m);
  RC_ASSERT(std::abs(there.cross_track_m + back.cross_track_m) < 1e-8);
  RC_ASSERT(std::abs(there.along_m + back.along_m - Length(leg)) < 1e-8);
}

}  // namespace shoal::leg_test
