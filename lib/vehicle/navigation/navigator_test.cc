#include "lib/vehicle/navigation/navigator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"

namespace shoal::navigator_test {

const StreamKey kKey(3, "navigation");
const StartKnowledge kKnown = {.position_m = 0, .heading_rad = 0, .current_mps = 0};

/// An AUV at 20 m depth over a floor at 40 m.
InstrumentOptions Perfect() {
  InstrumentOptions options;
  options.dvl.emplace();
  options.log.emplace();
  options.gps.emplace();
  options.compass.noise_rad = 1e-6;
  options.dvl->noise_mps = 1e-6;
  options.log->noise_mps = 1e-3;
  options.gyro.noise_rad_per_rts = 1e-3;
  return options;
}

/// Runs straight along `heading_deg` at 1.5 m/s for `time_s`; returns estimate less truth.
Eigen::Vector2d ErrorAfter(double time_s, double heading_deg, const InstrumentOptions& actual) {
  InstrumentOptions assumed = actual;
  assumed.compass.bias_sigma_rad = 0;
  Instruments instruments(actual, {}, kKey);
  Navigator navigator(assumed, {}, kKnown, {}, kKey);
  navigator.Start({0, 0}, DegToRad(heading_deg) + actual.compass.bias_rad);
  TrueMotion truth = {.position_m = {0, 0, 20},
                      .heading_rad = DegToRad(heading_deg),
                      .over_ground_mps = {1.5, 0},
                      .in_water_mps = {1.5, 0},
                      .altitude_m = 20};
  for (int i = 0; i <= static_cast<int>(time_s * 2); ++i) {
    truth.position_m.head<2>() = 1.5 * i / 2 * UnitVector(truth.heading_rad);
    navigator.Take(instruments.Read(truth, i * 500'000, 0), i == 0 ? 0 : 0.5);
  }
  return navigator.filter().solution().position_m - truth.position_m.head<2>();
}

TEST(Navigator, StaysOnTheTruthWithoutErrors) {
  EXPECT_LT(ErrorAfter(100, 70, Perfect()).norm(), 0.05);
}

// A heading that is wrong by b: after the distance d the error is d (sin(h + b) - sin h) and the
// same of the cosine, so d sin b across the track and d (1 - cos b) along it.
TEST(Navigator, DriftsAcrossTheTrackByTheSineOfACompassBias) {
  InstrumentOptions options = Perfect();
  options.compass.bias_rad = DegToRad(2);
  const double distance_m = 1.5 * 100;
  for (const double heading_deg : {0.0, 70.0, 250.0}) {
    const Eigen::Vector2d error_m = ErrorAfter(100, heading_deg, options);
    const Eigen::Vector2d along = UnitVector(DegToRad(heading_deg));
    const Eigen::Vector2d starboard(along.y(), -along.x());
    EXPECT_NEAR(error_m.dot(starboard), distance_m * std::sin(DegToRad(2)), 0.1) << heading_deg;
    EXPECT_NEAR(-error_m.dot(along), distance_m * (1 - std::cos(DegToRad(2))), 0.1) << heading_deg;
  }
}

TEST(Navigator, RunsTooFarByTheScaleErrorOfTheDvl) {
  InstrumentOptions options = Perfect();
  options.dvl->scale_error = 0.01;
  options.log.reset();
  EXPECT_NEAR(ErrorAfter(100, 0, options).y(), 0.01 * 150, 0.03);
}

/// Takes `count` steps of 0.5 s at rest at this depth, `first` the number of the first.
void Rest(double depth_m, int first, int count, Instruments* instruments, Navigator* navigator) {
  for (int i = first; i < first + count; ++i) {
    const TrueMotion truth = {.position_m = {50, 60, depth_m}, .altitude_m = 20};
    navigator->Take(instruments->Read(truth, i * 500'000, 0), 0.5);
  }
}

TEST(Navigator, GrowsUncertainUnderWaterAndComesBackWithAFix) {
  InstrumentOptions options = Perfect();
  options.dvl.reset();
  options.gps->noise_m = 2;
  options.gps->hot_fix_s = 5;
  Instruments instruments(options, {}, kKey);
  Navigator navigator(options, {}, {.position_m = 0, .heading_rad = 0, .current_mps = 0.3}, {},
                      kKey);
  navigator.Start({50, 60}, 0);
  Rest(20, 0, 300, &instruments, &navigator);
  const double before_m = navigator.ellipse().major_m;
  EXPECT_GT(before_m, 50);
  EXPECT_FALSE(navigator.used().gps);
  Rest(0, 300, 60, &instruments, &navigator);
  // Each fix has a 95 % ellipse of 2.45 x 2 m; some dozens of them less than one.
  EXPECT_LT(navigator.ellipse().major_m, 4.9);
  EXPECT_LT((navigator.filter().solution().position_m - Eigen::Vector2d(50, 60)).norm(), 4.9);
}

TEST(Navigator, ReportsTheRangesThatItTookAndRejected) {
  InstrumentOptions options = Perfect();
  options.ranging.emplace();
  options.ranging->errors.noise_m = 1;
  const std::vector<Beacon> beacons = {{.name = "near", .position_m = {100, 0, 20}},
                                       {.name = "moved", .position_m = {0, 100, 20}}};
  std::vector<Beacon> actual = beacons;
  actual[1].position_m.y() = 400;
  Instruments instruments(options, actual, kKey);
  Navigator navigator(options, {}, kKnown, beacons, kKey);
  navigator.Start({0, 0}, 0);
  int taken = 0;
  int rejected = 0;
  for (int i = 0; i < 60; ++i) {
    const TrueMotion truth = {.position_m = {0, 0, 20}, .altitude_m = 20};
    navigator.Take(instruments.Read(truth, i * 500'000, 0), 0.5);
    for (const RangeUsed& range : navigator.ranges()) {
      EXPECT_EQ(range.result.is_accepted, range.beacon == 0);
      ++(range.result.is_accepted ? taken : rejected);
    }
  }
  EXPECT_EQ(taken, 3);
  EXPECT_EQ(rejected, 3);
}

TEST(Navigator, DrawsTheSameErrorsForTheSameSeed) {
  InstrumentOptions options = Perfect();
  options.compass = {.bias_sigma_rad = 0.05, .noise_rad = 0.01};
  options.gyro = {.bias_sigma_radps = 1e-4, .noise_rad_per_rts = 1e-3};
  options.dvl->noise_mps = 0.01;
  const auto once = [&](uint64_t seed) {
    return ErrorAfter(60, 40, Drawn(options, StreamKey(seed, "instruments")));
  };
  EXPECT_EQ(once(1), once(1));
  EXPECT_NE(once(1), once(2));
}

TEST(Navigator, DrawsEachErrorFromAStreamOfItsOwn) {
  InstrumentOptions options = Perfect();
  options.compass.bias_sigma_rad = 0.05;
  options.clock.drift_sigma_ppm = 1;
  const InstrumentOptions with = Drawn(options, kKey);
  options.dvl->scale_sigma = 0.01;
  options.gyro.bias_sigma_radps = 0.001;
  const InstrumentOptions more = Drawn(options, kKey);
  EXPECT_NE(with.compass.bias_rad, 0);
  EXPECT_NE(with.clock.drift_ppm, 0);
  EXPECT_EQ(with.compass.bias_rad, more.compass.bias_rad);
  EXPECT_EQ(with.clock.drift_ppm, more.clock.drift_ppm);
  EXPECT_NE(more.dvl->scale_error, 0);
}

}  // namespace shoal::navigator_test
