#include "lib/vehicle/guidance/survey_lanes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"

namespace shoal::survey_lanes_test {

using Points = std::vector<Eigen::Vector2d>;

Points Rectangle(double east_m, double north_m) {
  return {{0, 0}, {east_m, 0}, {east_m, north_m}, {0, north_m}};
}

/// Like the letter U, open to the North.
Points Horseshoe() {
  return {{0, 0}, {300, 0}, {300, 200}, {200, 200}, {200, 80}, {100, 80}, {100, 200}, {0, 200}};
}

double LengthOf(const Points& points_m) {
  double length_m = 0;
  for (size_t i = 1; i < points_m.size(); ++i) length_m += (points_m[i] - points_m[i - 1]).norm();
  return length_m;
}

double DistanceTo(const Leg& leg, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d way_m = leg.to_m - leg.from_m;
  const double length2 = way_m.squaredNorm();
  const double part =
      length2 > 0 ? std::clamp((point_m - leg.from_m).dot(way_m) / length2, 0.0, 1.0) : 0;
  return (leg.from_m + part * way_m - point_m).norm();
}

double DistanceToLanes(const std::vector<SurveyLane>& lanes, const Eigen::Vector2d& point_m) {
  double least_m = INFINITY;
  for (const SurveyLane& lane : lanes) {
    for (const Leg& part : lane.parts) least_m = std::min(least_m, DistanceTo(part, point_m));
  }
  return least_m;
}

double DistanceToPolygon(const Points& polygon_m, const Eigen::Vector2d& point_m) {
  if (IsInside(polygon_m, point_m)) return 0;
  double least_m = INFINITY;
  for (size_t i = 0; i < polygon_m.size(); ++i) {
    const Leg edge = {polygon_m[i], polygon_m[(i + 1) % polygon_m.size()]};
    least_m = std::min(least_m, DistanceTo(edge, point_m));
  }
  return least_m;
}

/// A polygon around the origin, concave as a rule: one corner at each of some bearings.
Points DrawPolygon() {
  const int size = *rc::gen::inRange(3, 12);
  Points polygon_m;
  for (int i = 0; i < size; ++i) {
    const double bearing_deg = (i + *rc::gen::inRange(0, 80) / 100.0) * 360 / size;
    polygon_m.push_back(*rc::gen::inRange(20, 300) * UnitVector(DegToRad(bearing_deg)));
  }
  if (*rc::gen::arbitrary<bool>()) std::reverse(polygon_m.begin(), polygon_m.end());
  return polygon_m;
}

SurveyArea DrawArea() {
  SurveyArea area{.polygon_m = DrawPolygon(),
                  .lane_spacing_m = static_cast<double>(*rc::gen::inRange(5, 80))};
  if (*rc::gen::arbitrary<bool>()) area.lane_angle_deg = *rc::gen::inRange(-360, 361);
  return area;
}

RC_GTEST_PROP(LanesThatCover, PassEveryPointOfThePolygonWithinHalfASpacing, ()) {
  const SurveyArea area = DrawArea();
  RC_PRE(PolygonProblem(area.polygon_m).empty());
  const std::vector<SurveyLane> lanes = LanesOver(area);
  RC_ASSERT(static_cast<double>(lanes.size()) == CountLanes(area));
  for (const Eigen::Vector2d& corner_m : area.polygon_m) {
    RC_ASSERT(DistanceToLanes(lanes, corner_m) <= area.lane_spacing_m / 2 + 1e-6);
  }
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d point_m(*rc::gen::inRange(-300, 301), *rc::gen::inRange(-300, 301));
    if (!IsInside(area.polygon_m, point_m)) continue;
    RC_ASSERT(DistanceToLanes(lanes, point_m) <= area.lane_spacing_m / 2 + 1e-6);
  }
}

RC_GTEST_PROP(LanesThatCover, LeaveThePolygonByHalfASpacingAtMost, ()) {
  const SurveyArea area = DrawArea();
  RC_PRE(PolygonProblem(area.polygon_m).empty());
  for (const SurveyLane& lane : LanesOver(area)) {
    for (const Leg& part : lane.parts) {
      for (double share = 0; share <= 1; share += 0.125) {
        const Eigen::Vector2d point_m = part.from_m + share * (part.to_m - part.from_m);
        RC_ASSERT(DistanceToPolygon(area.polygon_m, point_m) <= area.lane_spacing_m / 2 + 1e-6);
      }
    }
  }
}

RC_GTEST_PROP(LanesInside, NeverLeaveThePolygonAndEndAtItsEdges, ()) {
  SurveyArea area = DrawArea();
  area.lane_ends = LaneEnds::kInside;
  RC_PRE(PolygonProblem(area.polygon_m).empty());
  const std::vector<SurveyLane> lanes = LanesOver(area);
  RC_ASSERT(static_cast<double>(lanes.size()) == CountLanes(area));
  for (const SurveyLane& lane : lanes) {
    for (const Leg& part : lane.parts) {
      for (double share = 0; share <= 1; share += 0.125) {
        const Eigen::Vector2d point_m = part.from_m + share * (part.to_m - part.from_m);
        RC_ASSERT(DistanceToPolygon(area.polygon_m, point_m) < 1e-6);
      }
      const Eigen::Vector2d beyond_m = part.to_m + 1e-3 * (part.to_m - part.from_m).normalized();
      // Where the lane leaves through a corner it may touch, not enter, the polygon again.
      RC_ASSERT(Length(part) < 1e-3 || !IsInside(area.polygon_m, beyond_m) ||
                DistanceToLanes(lanes, beyond_m) < 1e-2);
    }
  }
}

RC_GTEST_PROP(Lanes, TurnWithTheirPolygon, ()) {
  SurveyArea area = DrawArea();
  area.lane_angle_deg = *rc::gen::inRange(0, 360);
  area.lane_ends = *rc::gen::element(LaneEnds::kCover, LaneEnds::kInside);
  RC_PRE(PolygonProblem(area.polygon_m).empty());
  const double turn_deg = *rc::gen::inRange(0, 360) + 0.5;
  const auto turned = [&](const Eigen::Vector2d& point_m) -> Eigen::Vector2d {
    return UnitVector(HeadingOf(point_m) + DegToRad(turn_deg)) * point_m.norm() +
           Eigen::Vector2d(1000, -2000);
  };
  SurveyArea other = area;
  *other.lane_angle_deg += turn_deg;
  for (Eigen::Vector2d& corner_m : other.polygon_m) corner_m = turned(corner_m);
  RC_PRE(CountLanes(area) == CountLanes(other));  // A width of whole spacings may round either way.
  const std::vector<SurveyLane> lanes = LanesOver(area);
  const std::vector<SurveyLane> others = LanesOver(other);
  RC_ASSERT(lanes.size() == others.size());
  for (size_t i = 0; i < lanes.size(); ++i) {
    // Rounding may break a lane where it touches a corner: compare where it begins and ends.
    const Leg whole = {lanes[i].parts.front().from_m, lanes[i].parts.back().to_m};
    RC_ASSERT((turned(whole.from_m) - others[i].parts.front().from_m).norm() < 1e-3);
    RC_ASSERT((turned(whole.to_m) - others[i].parts.back().to_m).norm() < 1e-3);
  }
}

TEST(Lanes, OfARectangleRunAlongItsLongestEdgeAndAreSpreadEvenly) {
  const std::vector<SurveyLane> lanes =
      LanesOver({.polygon_m = Rectangle(300, 100), .lane_spacing_m = 30});
  ASSERT_EQ(lanes.size(), 4U);  // 25 m apart: three lanes would be 33 m apart.
  for (size_t i = 0; i < lanes.size(); ++i) {
    ASSERT_EQ(lanes[i].parts.size(), 1U);
    EXPECT_NEAR(lanes[i].parts[0].from_m.y(), 100 - 12.5 - 25.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(lanes[i].parts[0].from_m.x(), 0, 1e-9);
    EXPECT_NEAR(lanes[i].parts[0].to_m.x(), 300, 1e-9);
  }
}

TEST(Lanes, OfAWidthOfWholeSpacingsAreNoMoreThanNeeded) {
  EXPECT_EQ(CountLanes({.polygon_m = Rectangle(300, 100), .lane_spacing_m = 20}), 5);
  EXPECT_EQ(CountLanes({.polygon_m = Rectangle(300, 100), .lane_spacing_m = 0.1}), 1000);
  EXPECT_EQ(CountLanes({.polygon_m = Rectangle(300, 100), .lane_spacing_m = 500}), 1);
}

TEST(Lanes, AreBrokenWhereAConcavePolygonIs) {
  const std::vector<SurveyLane> lanes =
      LanesOver({.polygon_m = Horseshoe(), .lane_spacing_m = 40, .lane_angle_deg = 90});
  ASSERT_EQ(lanes.size(), 5U);  // At y = 180, 140, 100, 60, 20.
  for (const size_t i : {0U, 1U, 2U}) {
    ASSERT_EQ(lanes[i].parts.size(), 2U) << i;
    EXPECT_NEAR(lanes[i].parts[0].to_m.x(), 100, 1e-9);
    EXPECT_NEAR(lanes[i].parts[1].from_m.x(), 200, 1e-9);
  }
  EXPECT_EQ(lanes[3].parts.size(), 1U);
  // The gap between the parts is crossed in a straight line.
  const Points path_m = PathAlong(lanes, {.turn_radius_m = 5});
  EXPECT_NEAR(LengthOf(path_m), 5 * 300 + 4 * (kPi * 5 + 30), 1);
}

RC_GTEST_PROP(PathOfARectangle, IsAsLongAsItsLanesAndTheStepsBetweenThem, ()) {
  const double length_m = *rc::gen::inRange(50, 500);
  const double width_m = *rc::gen::inRange(10, 50);
  const double spacing_m = *rc::gen::inRange(2, 60);
  const double overrun_m = *rc::gen::inRange(0, 20);
  const std::vector<SurveyLane> lanes =
      LanesOver({.polygon_m = Rectangle(length_m, width_m), .lane_spacing_m = spacing_m});
  const double n = std::ceil(width_m / spacing_m);
  const Points path_m = PathAlong(lanes, {.overrun_m = overrun_m});
  const double expected_m = n * (length_m + 2 * overrun_m) + (n - 1) * width_m / n;
  RC_ASSERT(std::abs(LengthOf(path_m) - expected_m) < 1e-6);

  const double radius_m = *rc::gen::inRange(1, 30);
  const double step_m = width_m / n;
  const double swing_rad = std::acos(std::min(1.0, (2 * radius_m + step_m) / (4 * radius_m)));
  const double turn_m = radius_m * (kPi + 4 * swing_rad) + std::max(0.0, step_m - 2 * radius_m);
  const Points round_m = PathAlong(lanes, {.turn_radius_m = radius_m, .overrun_m = overrun_m});
  const double round_expected_m = n * (length_m + 2 * overrun_m) + (n - 1) * turn_m;
  // Chords of 22.5 deg are shorter than their arcs by 0.65 %.
  RC_ASSERT(LengthOf(round_m) <= round_expected_m + 1e-6);
  RC_ASSERT(LengthOf(round_m) >= round_expected_m - 0.0065 * (n - 1) * turn_m - 1e-6);
}

TEST(Path, BeginsAtTheSideThatIsAskedFor) {
  const std::vector<SurveyLane> lanes =
      LanesOver({.polygon_m = Rectangle(300, 100), .lane_spacing_m = 20});
  const auto entry_of = [&](const SurveyRoute& route) { return PathAlong(lanes, route).front(); };
  EXPECT_NEAR((entry_of({.entry = SurveyEntry::kNorthWest}) - Eigen::Vector2d(0, 90)).norm(), 0,
              1e-9);
  EXPECT_NEAR((entry_of({.entry = SurveyEntry::kNorthEast}) - Eigen::Vector2d(300, 90)).norm(), 0,
              1e-9);
  EXPECT_NEAR((entry_of({.entry = SurveyEntry::kSouthEast}) - Eigen::Vector2d(300, 10)).norm(), 0,
              1e-9);
  EXPECT_NEAR((entry_of({.entry = SurveyEntry::kSouthWest}) - Eigen::Vector2d(0, 10)).norm(), 0,
              1e-9);
  EXPECT_NEAR((entry_of({.start_m = {280, -50}}) - Eigen::Vector2d(300, 10)).norm(), 0, 1e-9);
}

RC_GTEST_PROP(Shares, AreNeighbouringLanesEachOfOneMemberAndOfAboutEqualLength, ()) {
  const SurveyArea area = DrawArea();
  RC_PRE(PolygonProblem(area.polygon_m).empty());
  const std::vector<SurveyLane> lanes = LanesOver(area);
  const auto members = static_cast<size_t>(*rc::gen::inRange(1, 8));
  double longest_m = 0;
  double total_m = 0;
  const auto length_of = [](const SurveyLane& lane) {
    return (lane.parts.back().to_m - lane.parts.front().from_m).norm();
  };
  for (const SurveyLane& lane : lanes) {
    longest_m = std::max(longest_m, length_of(lane));
    total_m += length_of(lane);
  }
  const SurveyLane* next = lanes.data();
  for (size_t place = 0; place < members; ++place) {
    const std::span<const SurveyLane> share = ShareOf(lanes, {.place = place, .members = members});
    RC_ASSERT(share.empty() || share.data() == next);
    next += share.size();
    if (lanes.size() < members) continue;
    RC_ASSERT(!share.empty());
    double share_m = 0;
    for (const SurveyLane& lane : share) share_m += length_of(lane);
    // Either end of a share is rounded to a lane; that each has one may move it by a lane more.
    RC_ASSERT(std::abs(share_m - total_m / static_cast<double>(members)) <= 2 * longest_m + 1e-6);
  }
  RC_ASSERT(next == lanes.data() + lanes.size());
}

TEST(Shares, OfARectangleAreEqual) {
  const std::vector<SurveyLane> lanes =
      LanesOver({.polygon_m = Rectangle(300, 120), .lane_spacing_m = 10});
  for (const size_t place : {0U, 1U, 2U}) {
    EXPECT_EQ(ShareOf(lanes, {.place = place, .members = 3}).size(), 4U);
  }
}

TEST(PolygonProblem, FindsWhatIsNoPolygon) {
  EXPECT_EQ(PolygonProblem(Rectangle(10, 20)), "");
  EXPECT_EQ(PolygonProblem(Horseshoe()), "");
  EXPECT_NE(PolygonProblem(Points{{0, 0}, {1, 0}}).find("three corners"), std::string::npos);
  EXPECT_NE(PolygonProblem(Points{{0, 0}, {9, 0}, {9, 9}, {0, 0}}).find("leave it out"),
            std::string::npos);
  EXPECT_NE(PolygonProblem(Points{{0, 0}, {9, 0}, {9, 0}, {0, 9}}).find("2 and 3 are the same"),
            std::string::npos);
  EXPECT_NE(PolygonProblem(Points{{0, 0}, {9, 9}, {9, 0}, {0, 9}}).find("after corners 1 and 3"),
            std::string::npos);
  EXPECT_NE(PolygonProblem(Points{{0, 0}, {9, 0}, {4, 0}, {2, 5}}).find("at corner 2"),
            std::string::npos);
}

TEST(AreaOf, IsTheSameInBothSenses) {
  Points horseshoe = Horseshoe();
  EXPECT_NEAR(AreaOf_m2(horseshoe), 300 * 200 - 100 * 120, 1e-6);
  std::reverse(horseshoe.begin(), horseshoe.end());
  EXPECT_NEAR(AreaOf_m2(horseshoe), 300 * 200 - 100 * 120, 1e-6);
}

}  // namespace shoal::survey_lanes_test
