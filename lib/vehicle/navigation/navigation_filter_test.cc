#include "lib/vehicle/navigation/navigation_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>

#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"
#include "lib/vehicle/navigation/chi_square.h"

namespace shoal::navigation_filter_test {

constexpr StateVector::Scalar kTiny = 1e-6;

/// A vehicle that turns, in a current, somewhere.
NavigationSolution Underway() {
  return {.position_m = {120, -40},
          .heading_rad = 0.7,
          .gyro_bias_radps = 0.001,
          .in_water_mps = {1.5, 0.1},
          .current_mps = {0.2, -0.3},
          .dvl_scale = 0.01,
          .compass_bias_rad = 0.02,
          .clock_m = 3,
          .clock_drift_mps = 0.01};
}

FilterOptions NoNoise() {
  FilterOptions options;
  options.speed_walk_mps_per_rts = 0;
  options.sway_mps = 0;
  options.current_walk_mps_per_rts = 0;
  return options;
}

StateVector Only(int state, double sigma) {
  StateVector sigmas = StateVector::Zero();
  sigmas[state] = sigma;
  return sigmas;
}

/// Returns the solution with one state greater by `step`.
NavigationSolution Moved(const NavigationSolution& solution, int state, double step) {
  NavigationSolution moved = solution;
  double* const values[kNumStates] = {
      &moved.position_m.x(),   &moved.position_m.y(),   &moved.heading_rad,
      &moved.gyro_bias_radps,  &moved.in_water_mps.x(), &moved.in_water_mps.y(),
      &moved.current_mps.x(),  &moved.current_mps.y(),  &moved.dvl_scale,
      &moved.compass_bias_rad, &moved.clock_m,          &moved.clock_drift_mps};
  *values[state] += step;
  return moved;
}

TEST(NavigationFilter, ReckonsAlongACircle) {
  // 1.5 m/s and 0.1 rad/s: after a quarter of a turn it is a radius of 15 m ahead and to starboard.
  NavigationFilter filter(NoNoise(), {.in_water_mps = {1.5, 0}}, StateVector::Zero());
  constexpr int kSteps = 1000;
  for (int i = 0; i < kSteps; ++i) filter.Propagate(0.1, kPi / 2 / 0.1 / kSteps);
  EXPECT_NEAR(filter.solution().position_m.x(), 15, 1e-5);
  EXPECT_NEAR(filter.solution().position_m.y(), 15, 1e-5);
  EXPECT_NEAR(filter.solution().heading_rad, kPi / 2, 1e-12);
}

TEST(NavigationFilter, DriftsWithTheCurrent) {
  NavigationFilter filter(NoNoise(), {.current_mps = {0.5, -0.2}}, StateVector::Zero());
  for (int i = 0; i < 10; ++i) filter.Propagate(0, 1);
  EXPECT_TRUE(filter.solution().position_m.isApprox(Eigen::Vector2d(5, -2), 1e-12));
}

// Column by column, the covariance of one error against what the nominal equations make of it.
TEST(NavigationFilter, PropagatesEachErrorAsItsEquationsDo) {
  for (int state = 0; state < kNumStates; ++state) {
    NavigationFilter filter(NoNoise(), Underway(), Only(state, 1));
    filter.Propagate(0.1, 0.5);
    NavigationFilter moved(NoNoise(), Moved(Underway(), state, kTiny), StateVector::Zero());
    moved.Propagate(0.1, 0.5);
    const StateVector column = filter.ErrorsOf(moved.solution()) / kTiny;
    EXPECT_TRUE(filter.covariance().isApprox(column * column.transpose(), 1e-4)) << state;
  }
}

// The gate's distance shows the derivative that an update uses: innovation^2 / (H^2 + noise^2) for
// an error of 1 in one state alone.
TEST(NavigationFilter, UpdatesByTheDerivativesOfItsMeasurements) {
  FilterOptions options = NoNoise();
  options.compass_noise_rad = 0.5;
  options.log_noise_mps = 0.5;
  const BeaconFix beacon = {.position_m = {300, 200, 60}};
  struct Measurement {
    double noise;
    std::function<UpdateResult(NavigationFilter&)> take;
  };
  const Measurement measurements[] = {
      {0.5, [](NavigationFilter& filter) { return filter.UpdateCompass(0.9); }},
      {0.5, [](NavigationFilter& filter) { return filter.UpdateLog(1.7); }},
      {2, [&](NavigationFilter& f) { return f.UpdateRange(beacon, 20, 310, 2, true); }},
      {2, [&](NavigationFilter& f) { return f.UpdateRange(beacon, 20, 310, 2, false); }}};
  for (const Measurement& measurement : measurements) {
    int states = 0;
    for (int state = 0; state < kNumStates; ++state) {
      NavigationFilter filter(options, Underway(), Only(state, 1));
      NavigationFilter moved(options, Moved(Underway(), state, kTiny), Only(state, 1));
      const UpdateResult result = measurement.take(filter);
      const double slope = (result.innovation - measurement.take(moved).innovation) / kTiny;
      const double spread = slope * slope + measurement.noise * measurement.noise;
      EXPECT_NEAR(result.distance2 * spread, result.innovation * result.innovation, 1e-4) << state;
      if (std::abs(slope) > 1e-3) ++states;
    }
    EXPECT_GE(states, 1);
  }
}

TEST(NavigationFilter, WeighsAFixByItsNoise) {
  FilterOptions options = NoNoise();
  options.gps_noise_m = 3;
  NavigationFilter filter(options, {}, Only(kStateX, 4));
  EXPECT_TRUE(filter.UpdateGps({5, 0}).is_accepted);
  EXPECT_NEAR(filter.solution().position_m.x(), 5 * 16.0 / 25, 1e-12);
  EXPECT_NEAR(filter.covariance()(kStateX, kStateX), 9 * 16.0 / 25, 1e-12);
}

TEST(NavigationFilter, ComesDownToTheNoiseOfAFixAfterALongDive) {
  FilterOptions options = NoNoise();
  options.gps_noise_m = 3;
  StateVector sigmas = Only(kStateX, 5000);
  sigmas[kStateY] = 5000;
  NavigationFilter filter(options, {}, sigmas);
  EXPECT_TRUE(filter.UpdateGps({400, -300}).is_accepted);
  EXPECT_NEAR(std::sqrt(filter.covariance()(kStateX, kStateX)), 3, 1e-3);
  EXPECT_LT((filter.solution().position_m - Eigen::Vector2d(400, -300)).norm(), 1e-3);
}

TEST(NavigationFilter, LearnsTheCurrentFromTwoFixes) {
  FilterOptions options = NoNoise();
  options.gps_noise_m = 1;
  StateVector sigmas = Only(kStateCurrentX, 0.5);
  sigmas[kStateX] = 1;
  NavigationFilter filter(options, {}, sigmas);
  for (int i = 0; i < 600; ++i) filter.Propagate(0, 1);
  EXPECT_TRUE(filter.UpdateGps({240, 0}).is_accepted);
  EXPECT_NEAR(filter.solution().current_mps.x(), 0.4, 0.001);
  EXPECT_LT(std::sqrt(filter.covariance()(kStateCurrentX, kStateCurrentX)), 0.003);
}

TEST(NavigationFilter, LetsAMeasurementThroughJustInsideItsGateAndNoneBeyond) {
  FilterOptions options = NoNoise();
  options.gate_probability = 0.99;
  const double edge_m = std::sqrt(ChiSquareQuantile(1, 0.99) * (9 + 16));
  const auto offer = [&](double error_m) {
    NavigationFilter filter(options, {}, Only(kStateX, 4));
    return filter.UpdateRange({.position_m = {-100, 0, 0}}, 0, 100 + error_m, 3, false);
  };
  EXPECT_TRUE(offer(edge_m - 1e-6).is_accepted);
  EXPECT_FALSE(offer(edge_m + 1e-6).is_accepted);
  EXPECT_NEAR(offer(edge_m).distance2, offer(edge_m).gate, 1e-9);
  EXPECT_NEAR(offer(7).innovation, 7, 1e-12);
}

TEST(NavigationFilter, StaysAsItIsWhereAnOutlierIsRejected) {
  NavigationFilter filter(NoNoise(), Underway(), Only(kStateX, 1));
  const StateMatrix before = filter.covariance();
  EXPECT_FALSE(filter.UpdateRange({}, 20, 5000, 1, false).is_accepted);
  EXPECT_EQ(filter.covariance(), before);
  EXPECT_EQ(filter.solution().position_m, Underway().position_m);
}

TEST(NavigationFilter, BelievesFixesAfterItHasLostItsWay) {
  FilterOptions options = NoNoise();
  options.gps_noise_m = 3;
  options.most_rejected_fixes = 3;
  NavigationFilter filter(options, {}, Only(kStateX, 1));
  EXPECT_FALSE(filter.UpdateGps({500, 0}).is_accepted);
  EXPECT_FALSE(filter.UpdateGps({500, 0}).is_accepted);
  EXPECT_TRUE(filter.UpdateGps({500, 0}).is_accepted);
  EXPECT_NEAR(filter.solution().position_m.x(), 500, 0.1);
}

TEST(NavigationFilter, BelievesTheLogOnceTheSpeedHasChangedFasterThanItAssumes) {
  FilterOptions options = NoNoise();
  options.log_noise_mps = 0.05;
  NavigationFilter filter(options, {}, Only(kStateForward, 0.05));
  EXPECT_FALSE(filter.UpdateLog(2).is_accepted);
  EXPECT_TRUE(filter.UpdateLog(2).is_accepted);
  EXPECT_NEAR(filter.solution().in_water_mps.x(), 2, 0.01);
  // One outlier alone is none.
  EXPECT_FALSE(filter.UpdateLog(0).is_accepted);
  EXPECT_TRUE(filter.UpdateLog(2).is_accepted);
  EXPECT_FALSE(filter.UpdateLog(0).is_accepted);
}

TEST(NavigationFilter, ForgetsTheDeviationOfTheHeadingThatItTurnedFrom) {
  FilterOptions options = NoNoise();
  options.compass_deviation_rad = 0.1;
  NavigationFilter filter(options, {.compass_bias_rad = 0.08}, Only(kStateCompassBias, 0.001));
  filter.Propagate(0, 100);
  EXPECT_EQ(filter.solution().compass_bias_rad, 0.08);
  filter.Propagate(1, 10);
  EXPECT_NEAR(filter.solution().compass_bias_rad, 0, 1e-5);
  EXPECT_NEAR(std::sqrt(filter.covariance()(kStateCompassBias, kStateCompassBias)), 0.1, 1e-6);
}

TEST(NavigationFilter, KeepsItsCovarianceSymmetricAndPositive) {
  FilterOptions options;
  options.gps_noise_m = 1e-3;
  options.dvl_noise_mps = 1e-4;
  options.compass_noise_rad = 1e-3;
  options.log_noise_mps = 0.05;
  options.gyro_noise_rad_per_rts = 1e-4;
  NavigationFilter filter(options, Underway(), StateVector::Constant(0.5));
  Stream draws(1, "covariance");
  for (int i = 0; i < 300; ++i) {
    filter.Propagate(0.1 * draws.Normal(), 0.5);
    filter.UpdateCompass(filter.solution().heading_rad);
    filter.UpdateDvl({draws.Normal(), draws.Normal()});
    filter.UpdateLog(1.5);
    if (i % 20 == 0) filter.UpdateGps(filter.solution().position_m);
    ASSERT_EQ(filter.covariance(), filter.covariance().transpose().eval()) << i;
  }
  const Eigen::SelfAdjointEigenSolver<StateMatrix> solver(filter.covariance());
  EXPECT_GT(solver.eigenvalues().minCoeff(), -1e-12);
}

TEST(NavigationFilter, TakesNoDirectionToABeaconStraightBelow) {
  NavigationFilter filter(NoNoise(), {}, Only(kStateX, 1));
  EXPECT_FALSE(filter.UpdateDirection({.position_m = {0, 0, 50}}, 0, {}, {0.1, 0.1}).is_accepted);
}

/// Ranges to three beacons about the vehicle, `bias_m` too long.
UpdateResult TakeRanges(NavigationFilter* filter, const Eigen::Vector2d& truth_m, double bias_m,
                        bool is_one_way) {
  const std::vector<Eigen::Vector2d> places_m = {{-300, 400}, {500, 300}, {0, -600}};
  UpdateResult last;
  for (size_t i = 0; i < places_m.size(); ++i) {
    const BeaconFix beacon = {.position_m = {places_m[i].x(), places_m[i].y(), 0}, .number = i};
    last = filter->UpdateRange(beacon, 0, (truth_m - places_m[i]).norm() + bias_m, 1, is_one_way);
  }
  return last;
}

TEST(NavigationFilter, BelievesRangesAfterItHasLostItsWay) {
  StateVector sigmas = Only(kStateX, 1);
  sigmas[kStateY] = 1;
  NavigationFilter filter(NoNoise(), {}, sigmas);
  const Eigen::Vector2d truth_m(40, -30);
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(TakeRanges(&filter, truth_m, 0, false).is_accepted);
    EXPECT_EQ(filter.solution().position_m, Eigen::Vector2d(0, 0)) << "echoes would look like this";
  }
  for (int i = 0; i < 8; ++i) TakeRanges(&filter, truth_m, 0, false);
  EXPECT_LT((filter.solution().position_m - truth_m).norm(), 2);
}

TEST(NavigationFilter, TakesNoNoticeOfEchoesAmongGoodRanges) {
  StateVector sigmas = Only(kStateX, 1);
  sigmas[kStateY] = 1;
  NavigationFilter filter(NoNoise(), {}, sigmas);
  for (int i = 0; i < 40; ++i) TakeRanges(&filter, {0, 0}, i % 4 == 0 ? 0 : 50, false);
  EXPECT_LT(filter.solution().position_m.norm(), 0.1);
}

TEST(NavigationFilter, FindsThatTheClockIsWorseThanItAssumes) {
  StateVector sigmas = Only(kStateX, 1);
  sigmas[kStateY] = 1;
  NavigationFilter filter(NoNoise(), {}, sigmas);
  for (int i = 0; i < 8; ++i) TakeRanges(&filter, {0, 0}, 30, true);
  EXPECT_NEAR(filter.solution().clock_m, 30, 3);
  EXPECT_LT(filter.solution().position_m.norm(), 3);
}

TEST(NavigationFilter, GrowsItsEllipseWhereOneBeaconInsists) {
  StateVector sigmas = Only(kStateX, 1);
  sigmas[kStateY] = 1;
  NavigationFilter filter(NoNoise(), {}, sigmas);
  const auto ellipse_m = [&] {
    return EllipseOf(filter.covariance().block<2, 2>(0, 0), 0.95).major_m;
  };
  const double sure_m = ellipse_m();
  for (int i = 0; i < 8; ++i) {
    filter.UpdateRange({.position_m = {-300, 400, 0}}, 0, 530, 1, true);
  }
  EXPECT_GT(ellipse_m(), 5 * sure_m) << "it may be the clock, or the place";
  EXPECT_LT(filter.solution().position_m.norm(), ellipse_m());
}

TEST(NavigationFilter, BelievesACompassThatInsists) {
  FilterOptions options = NoNoise();
  options.compass_noise_rad = 0.01;
  NavigationFilter filter(options, {.heading_rad = 1}, Only(kStateHeading, 0.01));
  for (int i = 1; i < options.most_rejected_headings; ++i) {
    ASSERT_FALSE(filter.UpdateCompass(1.3).is_accepted) << i;
  }
  EXPECT_TRUE(filter.UpdateCompass(1.3).is_accepted);
  EXPECT_GT(filter.covariance()(kStateHeading, kStateHeading), 0.01);
}

TEST(NavigationFilter, FindsItsPositionByRangeAndDirectionOfOneBeacon) {
  StateVector sigmas = Only(kStateX, 30);
  sigmas[kStateY] = 30;
  const NavigationSolution truth = {.position_m = {20, -10}, .heading_rad = 0.5};
  NavigationFilter filter(NoNoise(), {.heading_rad = 0.5}, sigmas);
  const BeaconFix beacon = {.position_m = {200, 100, 40}};
  const UsblReading reading = TrueUsbl({20, -10, 5}, truth.heading_rad, beacon.position_m);
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(filter.UpdateRange(beacon, 5, reading.range_m, 0.5, false).is_accepted);
    EXPECT_TRUE(filter.UpdateDirection(beacon, 5, reading, {0.005, 0.005}).is_accepted);
  }
  EXPECT_LT((filter.solution().position_m - truth.position_m).norm(), 0.5);
}

TEST(ErrorEllipse, HasTheAxesOfItsCovariance) {
  // Axes of 5 m and 2 m, the long one toward North-East by East.
  const double heading_rad = DegToRad(60);
  const Eigen::Vector2d along = UnitVector(heading_rad);
  const Eigen::Vector2d across(along.y(), -along.x());
  const ErrorEllipse ellipse =
      EllipseOf(25 * along * along.transpose() + 4 * across * across.transpose(), 0.95);
  EXPECT_NEAR(ellipse.major_m, 5 * std::sqrt(ChiSquareQuantile(2, 0.95)), 1e-9);
  EXPECT_NEAR(ellipse.minor_m, 2 * std::sqrt(ChiSquareQuantile(2, 0.95)), 1e-9);
  EXPECT_NEAR(ellipse.heading_rad, heading_rad, 1e-12);
}

TEST(ErrorEllipse, LiesNorthAndSouthOrEastAndWest) {
  EXPECT_NEAR(EllipseOf(Eigen::Vector2d(1, 9).asDiagonal().toDenseMatrix(), 0.95).heading_rad, 0,
              1e-12);
  EXPECT_NEAR(EllipseOf(Eigen::Vector2d(9, 1).asDiagonal().toDenseMatrix(), 0.95).heading_rad,
              kPi / 2, 1e-12);
}

}  // namespace shoal::navigation_filter_test
