// Is the filter's covariance that of its errors? Trials whose truth moves as the filter assumes,
// with errors of instruments drawn for each (Bar-Shalom, Li and Kirubarajan, 2001, 5.4).
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/navigation/chi_square.h"
#include "lib/vehicle/navigation/navigator.h"

namespace shoal::navigation_consistency_test {

constexpr double kStep_s = 0.5;
constexpr int kSteps = 400;
constexpr uint64_t kSeeds = 1000;

InstrumentOptions AllInstruments() {
  InstrumentOptions options;
  options.compass = {.bias_sigma_rad = DegToRad(1), .noise_rad = DegToRad(0.5), .rate_hz = 1};
  options.gyro = {.bias_sigma_radps = DegToRad(0.02),
                  .noise_rad_per_rts = DegToRad(0.05),
                  .bias_walk_radps_per_rts = DegToRad(0.0005)};
  options.dvl = Dvl{.max_altitude_m = 30, .scale_sigma = 0.005, .noise_mps = 0.02, .rate_hz = 1};
  options.log = SpeedLog{.noise_mps = 0.1, .rate_hz = 1};
  options.gps = Gps{.hot_fix_s = 3, .noise_m = 3, .rate_hz = 0.5};
  options.clock = {.phase_sigma_s = 0.01, .drift_sigma_ppm = 5};
  options.ranging =
      AcousticRanging{.errors = {.noise_m = 2}, .usbl = UsblErrors{DegToRad(2), DegToRad(2)}};
  return options;
}

const std::vector<Beacon> kBeacons = {{.name = "clocked",
                                       .position_m = {400, 600, 10},
                                       .position_sigma_m = 0,
                                       .kind = BeaconKind::kOneWay,
                                       .interval_s = 20},
                                      {.name = "answering",
                                       .position_m = {-500, 700, 30},
                                       .position_sigma_m = 0,
                                       .kind = BeaconKind::kTwoWay,
                                       .interval_s = 30}};

/// One vehicle: on the surface for a quarter of the time, then at 20 m, the last quarter out of
/// reach of the floor; turning one way and the other.
class Trial {
 public:
  Trial(const InstrumentOptions& options, const FilterOptions& tuning, uint64_t seed)
      : key_(StreamKey(seed, "trial")),
        drawn_(Drawn(options, key_)),
        tuning_(FilterFor(options, tuning)),
        instruments_(drawn_, kBeacons, key_),
        navigator_(options, tuning, kKnowledge, kBeacons, key_),
        draws_(key_.With("truth")) {
    truth_.heading_rad = 2 * kPi * draws_.Uniform();
    truth_.in_water_mps = {1.5, tuning_.sway_mps * draws_.Normal()};
    truth_.current_mps = kKnowledge.current_mps * Eigen::Vector2d(draws_.Normal(), draws_.Normal());
    truth_.dvl_scale = drawn_.dvl->scale_error;
    truth_.compass_bias_rad = drawn_.compass.bias_rad;
    navigator_.Start(truth_.position_m, truth_.heading_rad);
  }

  void Step(int number) {
    if (number > 0) Move(number);
    const double heading_rad = truth_.heading_rad;
    Eigen::Matrix2d axes;
    axes << std::sin(heading_rad), std::cos(heading_rad), std::cos(heading_rad),
        -std::sin(heading_rad);
    const double depth_m = number < kSteps / 4 ? 0 : 20;
    const TrueMotion motion = {
        .position_m = {truth_.position_m.x(), truth_.position_m.y(), depth_m},
        .heading_rad = heading_rad,
        .over_ground_mps = truth_.in_water_mps + axes.transpose() * truth_.current_mps,
        .in_water_mps = truth_.in_water_mps,
        .altitude_m = number < kSteps * 3 / 4 ? 20 : 200};
    const double time_s = number * kStep_s;
    truth_.clock_m = 1500 * ClockOffset_s(drawn_.clock, time_s);
    truth_.clock_drift_mps = 1500 * drawn_.clock.drift_ppm * 1e-6;
    truth_.gyro_bias_radps = instruments_.gyro().bias_radps();
    navigator_.Take(instruments_.Read(motion, static_cast<int64_t>(time_s * 1e6), 0),
                    number > 0 ? kStep_s : 0);
  }

  /// Returns the normalized estimation error squared of the whole state.
  double Nees() const {
    const StateVector errors = navigator_.filter().ErrorsOf(truth_);
    return errors.dot(navigator_.filter().covariance().ldlt().solve(errors));
  }
  /// The same of the position alone.
  double PositionNees() const {
    const Eigen::Vector2d errors = navigator_.filter().ErrorsOf(truth_).head<2>();
    return errors.dot(navigator_.filter().covariance().topLeftCorner<2, 2>().ldlt().solve(errors));
  }
  double PositionError_m() const { return navigator_.filter().ErrorsOf(truth_).head<2>().norm(); }

 private:
  static constexpr StartKnowledge kKnowledge = {
      .position_m = 3, .heading_rad = 0.05, .current_mps = 0.3};

  void Move(int number) {
    const double turn_rad = DegToRad(number / 40 % 2 == 0 ? 2 : -3) * kStep_s;
    const double middle_rad = truth_.heading_rad + turn_rad / 2;
    const Eigen::Vector2d forward = UnitVector(middle_rad);
    const Eigen::Vector2d starboard(forward.y(), -forward.x());
    truth_.position_m += kStep_s * (forward * truth_.in_water_mps.x() +
                                    starboard * truth_.in_water_mps.y() + truth_.current_mps);
    truth_.heading_rad = WrapTwoPi(truth_.heading_rad + turn_rad);
    const double root_step = std::sqrt(kStep_s);
    const double keep = std::exp(-kStep_s / tuning_.sway_time_s);
    truth_.in_water_mps.x() += tuning_.speed_walk_mps_per_rts * root_step * draws_.Normal();
    truth_.in_water_mps.y() = keep * truth_.in_water_mps.y() +
                              tuning_.sway_mps * std::sqrt(1 - keep * keep) * draws_.Normal();
    const double walk_mps = tuning_.current_walk_mps_per_rts * root_step;
    truth_.current_mps.x() += walk_mps * draws_.Normal();
    truth_.current_mps.y() += walk_mps * draws_.Normal();
  }

  StreamKey key_;
  InstrumentOptions drawn_;
  FilterOptions tuning_;
  Instruments instruments_;
  Navigator navigator_;
  Stream draws_;
  NavigationSolution truth_;
};

/// Sums over all seeds, at the end of each quarter of the time.
struct Sums {
  double all[4] = {};
  double position[4] = {};
  double squared_error_m2[4] = {};
};

Sums RunAll(const InstrumentOptions& options) {
  FilterOptions tuning;
  tuning.gate_probability = 1 - 1e-9;
  Sums sums;
  for (uint64_t seed = 0; seed < kSeeds; ++seed) {
    Trial trial(options, tuning, seed);
    int quarter = 0;
    for (int number = 0; number < kSteps; ++number) {
      trial.Step(number);
      if (number != (quarter + 1) * kSteps / 4 - 1) continue;
      sums.all[quarter] += trial.Nees();
      sums.position[quarter] += trial.PositionNees();
      sums.squared_error_m2[quarter] += std::pow(trial.PositionError_m(), 2);
      ++quarter;
    }
  }
  return sums;
}

/// Expects a sum over the seeds to be within the bounds that 99.9 % of correct filters keep.
void ExpectWithinChiSquare(double sum, int states) {
  const int degrees = states * static_cast<int>(kSeeds);
  EXPECT_GT(sum, ChiSquareQuantile(degrees, 0.0005));
  EXPECT_LT(sum, ChiSquareQuantile(degrees, 0.9995));
}

TEST(NavigationConsistency, HasErrorsOfItsCovarianceOverAThousandSeeds) {
  const Sums sums = RunAll(AllInstruments());
  for (int quarter = 0; quarter < 4; ++quarter) {
    SCOPED_TRACE(quarter);
    ExpectWithinChiSquare(sums.all[quarter], kNumStates);
    ExpectWithinChiSquare(sums.position[quarter], 2);
    // No filter is consistent by claiming nothing: it is good to some metres.
    EXPECT_LT(std::sqrt(sums.squared_error_m2[quarter] / kSeeds), 5);
  }
}

TEST(NavigationConsistency, HasErrorsOfItsCovarianceWithCompassLogAndGpsAlone) {
  InstrumentOptions options = AllInstruments();
  options.dvl->max_altitude_m = 1;
  options.ranging.reset();
  const Sums sums = RunAll(options);
  for (int quarter = 0; quarter < 4; ++quarter) {
    SCOPED_TRACE(quarter);
    ExpectWithinChiSquare(sums.position[quarter], 2);
  }
}

// What the model leaves out (the deviation as a process of the heading) may make it cautious, never
// sure of itself beyond its errors by more than half.
TEST(NavigationConsistency, IsNotMuchTooSureOfItselfWithADeviationThatItOnlyKnowsTheSizeOf) {
  InstrumentOptions options = AllInstruments();
  const double one = DegToRad(1);
  options.compass.deviation = {.a = 0, .b = 3 * one, .c = -2 * one, .d = one, .e = 0};
  const Sums sums = RunAll(options);
  for (int quarter = 0; quarter < 4; ++quarter) {
    EXPECT_LT(sums.position[quarter] / (2 * kSeeds), 1.5) << quarter;
    EXPECT_GT(sums.position[quarter] / (2 * kSeeds), 0.3) << quarter;
  }
}

}  // namespace shoal::navigation_consistency_test
