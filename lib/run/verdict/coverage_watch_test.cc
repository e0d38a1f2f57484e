#include "lib/run/verdict/coverage_watch.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/vehicle/guidance/survey_lanes.h"

namespace shoal::coverage_watch_test {

using Polygon = CoverageWatch::Polygon;

Polygon Rectangle(double east_m, double north_m) {
  return {{0, 0}, {east_m, 0}, {east_m, north_m}, {0, north_m}};
}

/// Sails straight in short steps, 5 m/s. Returns when it ends.
double Sail(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, double begin_s,
            CoverageWatch* watch) {
  const int steps = std::max(1, static_cast<int>((to_m - from_m).norm() / 0.5));
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    watch->Look(0, from_m + share * (to_m - from_m), begin_s + 0.1 * i);
  }
  return begin_s + 0.1 * steps;
}

TEST(CoverageWatch, CountsWhatLiesWithinHalfTheWidthOfATrack) {
  CoverageWatch watch({Rectangle(400, 100)}, 20, 1);
  EXPECT_NEAR(watch.area_m2(), 40'000, 40);
  EXPECT_EQ(watch.covered_pct(), 0);
  Sail({-50, 50}, {450, 50}, 0, &watch);
  EXPECT_NEAR(watch.covered_pct(), 20, 0.05);
  Sail({450, 50}, {-50, 50}, 1000, &watch);  // The same again.
  EXPECT_NEAR(watch.covered_pct(), 20, 0.05);
}

TEST(CoverageWatch, CountsADiscWhereAVehicleLies) {
  CoverageWatch watch({Rectangle(100, 100)}, 20, 1);
  for (int i = 0; i < 100; ++i) watch.Look(0, {50, 50}, i);
  EXPECT_NEAR(watch.covered_pct(), std::numbers::pi * 1, 0.02);
}

TEST(CoverageWatch, DoesNotCountAJump) {
  CoverageWatch watch({Rectangle(400, 100)}, 20, 2);
  watch.Look(0, {-50, 50}, 0);
  watch.Look(1, {-50, 50}, 0);
  watch.Look(0, {450, 50}, 0.1);
  EXPECT_EQ(watch.covered_pct(), 0);
  watch.Look(1, {450, 50}, 20);  // 25 m/s.
  EXPECT_NEAR(watch.covered_pct(), 20, 0.05);
}

TEST(CoverageWatch, CountsWhatTwoPolygonsShareOnce) {
  const Polygon right = {{50, 0}, {150, 0}, {150, 100}, {50, 100}};
  CoverageWatch watch({Rectangle(100, 100), right}, 20, 1);
  EXPECT_NEAR(watch.area_m2(), 15'000, 30);
  Sail({-50, 50}, {200, 50}, 0, &watch);
  EXPECT_NEAR(watch.covered_pct(), 20, 0.1);
}

TEST(CoverageWatch, KeepsItsCellsWithinBounds) {
  const CoverageWatch wide({Rectangle(100'000, 100'000)}, 1, 1);
  EXPECT_NEAR(wide.area_m2(), 1e10, 1e7);
  const CoverageWatch narrow({Rectangle(1, 1)}, 10'000, 1);
  EXPECT_LE(narrow.cell_m(), 0.005);
  EXPECT_EQ(CoverageWatch({Rectangle(400, 100)}, 20, 1).cell_m(), 1);
}

RC_GTEST_PROP(CoverageWatch, MissesTheShareThatLanesCoverByLessThanAFifthOfAPerCent, ()) {
  // Lanes over the whole length of a rectangle at any angle to the compass, with gaps between.
  const double angle_rad = *rc::gen::inRange(0, 360) * std::numbers::pi / 180;
  const double width_m = *rc::gen::inRange(5, 40);
  const double gap_m = *rc::gen::inRange(0, 40);
  const int lanes = *rc::gen::inRange(1, 8);
  const Eigen::Vector2d along(std::cos(angle_rad), std::sin(angle_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const double side_m = (width_m + gap_m) * lanes;
  const double length_m = 200;
  CoverageWatch watch(
      {{0 * along, length_m * along, length_m * along + side_m * across, side_m * across}}, width_m,
      1);
  double time_s = 0;
  for (int i = 0; i < lanes; ++i) {
    const Eigen::Vector2d middle_m = (width_m + gap_m) * (i + 0.5) * across;
    // Put from the end of one lane to the begin of the next.
    time_s = Sail(middle_m - 50 * along, middle_m + (length_m + 50) * along, time_s, &watch);
  }
  RC_ASSERT(std::abs(watch.covered_pct() - 100 * width_m / (width_m + gap_m)) < 0.2);
}

RC_GTEST_PROP(CoverageWatch, FindsAllCoveredThatThePathOfASurveyPasses, ()) {
  const double spacing_m = *rc::gen::inRange(8, 40);
  const Polygon polygon_m = {{0, 0}, {*rc::gen::inRange(50, 300), 20}, {200, 250}, {-40, 120}};
  const SurveyArea area{.polygon_m = polygon_m, .lane_spacing_m = spacing_m};
  const std::vector<Eigen::Vector2d> path_m = PathAlong(LanesOver(area), {});
  CoverageWatch watch({polygon_m}, spacing_m, 1);
  for (size_t i = 1; i < path_m.size(); ++i) {
    Sail(path_m[i - 1], path_m[i], 1000.0 * static_cast<double>(i), &watch);
  }
  RC_ASSERT(watch.covered_pct() > 99.9);
}

}  // namespace shoal::coverage_watch_test
