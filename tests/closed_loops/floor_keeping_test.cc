// How near a Remus 100 comes to the sea floor, 2 m/s fast, its clearance 5 m: by the chart, by its
// altimeter alone, by its sonar; as it follows a path and as it follows another vehicle. The
// figures are those of docs/missions/ocean.md.
#include <gtest/gtest.h>

#include <string>

#include "tests/closed_loops/swimming_auv.h"

namespace shoal::floor_keeping_test {

constexpr double kClearance_m = 5;
constexpr double kOnset_m = 100;
constexpr double kDeep_m = 60;

/// What asks for more depth than there is.
const std::vector<std::pair<std::string, Guidance>> kDives = {{"path", ToDepth(100)},
                                                              {"track", WithPitch(-10)}};

Extremes SwimOver(const std::string& floor_from, const SeaFloor& floor, const Guidance& dive,
                  double start_z_m, double duration_s) {
  SwimmingAuv auv({.max_depth_m = 200, .floor_from = floor_from}, floor);
  auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = start_z_m});
  return auv.Swim(dive, duration_s);
}

/// Level to kOnset_m, then up.
SeaFloor Rising(double slope) {
  return FloorAlong([=](double x_m) { return kDeep_m - slope * std::max(0.0, x_m - kOnset_m); });
}

TEST(FloorByChart, IsClearedWithinHalfAMetreWhereASlopeBegins) {
  for (const auto& [kind, dive] : kDives) {
    for (const double slope : {0.05, 0.1, 0.2}) {
      const double duration_s = (kOnset_m + 40 / slope) / 2;
      const Extremes seen =
          SwimOver("chart", Rising(slope), dive, kDeep_m - kClearance_m, duration_s);
      EXPECT_GT(seen.least_altitude_m, kClearance_m - 0.5) << kind << " " << slope;
      EXPECT_LT(seen.greatest_altitude_m, kClearance_m + 1) << kind << " " << slope;
    }
  }
}

TEST(FloorByChart, IsClearedWithinHalfAMetreWhereALevelOrSinkingVehicleMeetsASlope) {
  for (const auto& [kind, dive] :
       {std::pair<std::string, Guidance>{"path", ToDepth(40)}, {"track", WithPitch(-10)}}) {
    for (const double slope : {0.05, 0.1, 0.2}) {
      const SeaFloor floor = FloorAlong([=](double x_m) { return 68 - slope * x_m; });
      const Extremes seen = SwimOver("chart", floor, dive, 40, 30 / slope / 2);
      EXPECT_GT(seen.least_altitude_m, kClearance_m - 0.5) << kind << " " << slope;
    }
  }
}

TEST(FloorByAltimeter, IsClearedWithinHalfAMetreOnSlopesToOneInEight) {
  for (const auto& [kind, dive] :
       {std::pair<std::string, Guidance>{"path", ToDepth(40)}, {"track", WithPitch(-10)}}) {
    for (const double slope : {0.05, 0.1, 0.125}) {
      const SeaFloor floor = FloorAlong([=](double x_m) { return 68 - slope * x_m; });
      const Extremes seen = SwimOver("altimeter", floor, dive, 40, 45 / slope / 2);
      EXPECT_GT(seen.least_altitude_m, kClearance_m - 0.5) << kind << " " << slope;
    }
  }
}

// What is not seen before it is there costs the way of the first seconds.
TEST(FloorByAltimeter, IsClearedWithinAMetreWhereASlopeOfOneInEightBegins) {
  for (const auto& [kind, dive] : kDives) {
    const Extremes seen = SwimOver("altimeter", Rising(0.125), dive, kDeep_m - kClearance_m, 200);
    EXPECT_GT(seen.least_altitude_m, kClearance_m - 1) << kind;
    EXPECT_LT(seen.greatest_altitude_m, kClearance_m + 0.5) << kind;
  }
}

TEST(FloorGoingDown, IsFollowedWithoutSwinging) {
  for (const char* source : {"chart", "altimeter"}) {
    for (const auto& [kind, dive] : kDives) {
      for (const double slope : {0.05, 0.125}) {
        const SeaFloor floor =
            FloorAlong([=](double x_m) { return 30 + slope * std::max(0.0, x_m - kOnset_m); });
        const std::string where = std::string(source) + " " + kind + " " + std::to_string(slope);
        SwimmingAuv auv({.max_depth_m = 200, .floor_from = source}, floor);
        auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = 25});
        const Extremes onset = auv.Swim(dive, 120);
        EXPECT_GT(onset.least_altitude_m, kClearance_m - 0.5) << where;
        EXPECT_LT(onset.greatest_altitude_m, kClearance_m + 1.5) << where;
        const Extremes later = auv.Swim(dive, 80);
        EXPECT_GT(later.least_altitude_m, kClearance_m - 0.2) << where;
        EXPECT_LT(later.greatest_altitude_m, later.least_altitude_m + 0.2) << where;
      }
    }
  }
}

TEST(Ridge, IsCrossedByTheChartWithinHalfAMetre) {
  for (const auto& [kind, dive] : kDives) {
    const SeaFloor ridge = FloorAlong(
        [](double x_m) { return kDeep_m - std::max(0.0, 20 - 0.2 * std::abs(x_m - 250)); });
    const Extremes seen = SwimOver("chart", ridge, dive, kDeep_m - kClearance_m, 220);
    EXPECT_GT(seen.least_altitude_m, kClearance_m - 0.5) << kind;
    EXPECT_LT(seen.greatest_altitude_m, kClearance_m + 4) << kind;
  }
}

/// A wall of 20 m, steeper than any vehicle climbs.
SeaFloor Wall() {
  return FloorAlong([](double x_m) { return x_m < 250 ? kDeep_m : kDeep_m - 20; });
}

TEST(Wall, IsClimbedInTimeByTheChart) {
  for (const auto& [kind, dive] : kDives) {
    const Extremes seen = SwimOver("chart", Wall(), dive, kDeep_m - kClearance_m, 220);
    EXPECT_GT(seen.least_altitude_m, kClearance_m - 1) << kind;
  }
}

TEST(Wall, IsPassedAboveByTheSonar) {
  const SonarOptions sonar = {.is_fitted = true, .rate_hz = 5};
  for (const auto& [kind, dive] : kDives) {
    SwimmingAuv auv({.max_depth_m = 200, .floor_from = "sonar"}, Wall(), sonar);
    auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = kDeep_m - kClearance_m});
    EXPECT_GT(auv.Swim(dive, 220).least_altitude_m, 0.5) << kind;
    EXPECT_GT(auv.x_m(), 350) << kind;
  }
}

TEST(Wall, IsHitByAVehicleThatLooksDownOnly) {
  EXPECT_LT(
      SwimOver("altimeter", Wall(), ToDepth(100), kDeep_m - kClearance_m, 220).least_altitude_m, 0);
}

TEST(GreatestDepth, IsKeptByAVehicleThatFollowsAnother) {
  for (const double pitch_deg : {-5.0, -20.0, -45.0}) {
    SwimmingAuv auv({.max_depth_m = 30}, FlatFloor(200));
    auv.Start({.heading_deg = 90, .speed_mps = 2, .depth_m = 10});
    EXPECT_LT(auv.Swim(WithPitch(pitch_deg), 180).greatest_z_m, 30.3) << pitch_deg;
    EXPECT_NEAR(auv.z_m(), 30, 0.2) << pitch_deg;
  }
}

}  // namespace shoal::floor_keeping_test
