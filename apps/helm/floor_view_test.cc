#include "apps/helm/floor_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace shoal::floor_view_test {

constexpr double kTick_s = 0.1;
constexpr double kClimb_mps = 0.5;

/// A vehicle that swims East at 2 m/s.
nav_t NavAt(double x_m, double z_m, double altitude_m) {
  nav_t nav{};
  nav.x_m = x_m;
  nav.z_m = z_m;
  nav.altitude_m = altitude_m;
  nav.heading_deg = nav.course_over_ground_deg = 90;
  nav.speed_mps = nav.speed_over_ground_mps = 2;
  return nav;
}

/// 60 m deep; from x = 100 m on 40 m, but only south of y = 50 m.
SeaFloor Step() {
  std::vector<float> depths_m;
  for (int row = 0; row < 100; ++row) {
    for (int column = 0; column < 300; ++column) {
      depths_m.push_back(column >= 100 && row < 50 ? 40 : 60);
    }
  }
  return SeaFloor(std::make_shared<const DepthGrid>(
      GridFrame{.columns = 300, .rows = 100, .south_west_m = {0, 0}, .cell_m = {1, 1}}, depths_m));
}

TEST(FloorView, KnowsByItsAltimeterWhatIsBelowAndItsSlope) {
  FloorView view({}, {}, {});
  DepthBound bound;
  for (int i = 0; i < 100; ++i) {
    bound = view.Look(NavAt(0.2 * i, 20, 30 - 0.025 * i), 0, kTick_s, kClimb_mps);
  }
  EXPECT_NEAR(bound.now_m, 50 - 0.025 * 99 - 5, 0.01);
  EXPECT_NEAR(bound.soon_m - bound.later_m, 0.25, 0.01);
  bound = view.Look(NavAt(20, 20, -1), 0, kTick_s, kClimb_mps);
  EXPECT_TRUE(std::isinf(bound.now_m));
}

TEST(FloorView, KnowsByItsChartTheCliffAhead) {
  FloorView view({.floor_from = "chart"}, {}, Step());
  nav_t nav = NavAt(60, 30, 30);
  nav.y_m = 20;
  // 40 m ahead, at a slope of 1:4.
  EXPECT_NEAR(view.Look(nav, 0, kTick_s, kClimb_mps).now_m, 40 - 5 + 0.25 * 40, 0.6);
}

TEST(FloorView, ReadsItsChartAlongTheTurnThatItMakes) {
  FloorView view({.floor_from = "chart"}, {}, Step());
  nav_t nav = NavAt(60, 30, 30);
  nav.y_m = 45;
  nav.yaw_rate_degps = -6;  // To port, to North: round the cliff.
  EXPECT_NEAR(view.Look(nav, -1.57, kTick_s, kClimb_mps).now_m, 55, 1e-9);
  EXPECT_LT(view.Look(nav, 0, kTick_s, kClimb_mps).now_m, 50);
}

TEST(FloorView, KnowsByItsSonarWhatStandsAhead) {
  const SonarOptions sonar = {.is_fitted = true, .max_range_m = 100, .range_steps = 100};
  FloorView view({.floor_from = "sonar"}, sonar, {});
  const nav_t nav = NavAt(0, 30, 25);
  EXPECT_NEAR(view.Look(nav, 0, kTick_s, kClimb_mps).now_m, 50, 1e-9);
  sonar_t ping{};
  ping.beams = {{.azimuth_deg = 0, .elevation_deg = -2, .range_m = 21},
                {.azimuth_deg = 60, .elevation_deg = -2, .range_m = 10},  // Beside the way.
                {.azimuth_deg = 0, .elevation_deg = 0, .range_m = -1}};   // Above the top.
  view.OnSonar(ping);
  // The range is rounded up to whole metres, the top is below the next beam: 20 m ahead, 30 m deep.
  EXPECT_NEAR(view.Look(nav, 0, kTick_s, kClimb_mps).now_m, 30 - 5 + 0.25 * 20, 1e-9);
  ping.beams.pop_back();  // Now the top may be anywhere.
  view.OnSonar(ping);
  EXPECT_LT(view.Look(nav, 0, kTick_s, kClimb_mps).now_m, 10);
  view.OnSonar({});
  // Once it is out of sight it counts as far as 1:10 of the way since.
  nav_t later = nav;
  later.utime = 2'000'000;
  const double held_m = 30 - 5 + 0.25 * 20;
  EXPECT_NEAR(view.Look(later, 0, 20, kClimb_mps).now_m, held_m + 0.1 * 2 * 20.0, 0.1);
  EXPECT_NEAR(view.Look(later, 0, 500, kClimb_mps).now_m, 50, 1e-9);
}

}  // namespace shoal::floor_view_test
