#include "lib/vehicle/navigation/navigation_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/navigation/chi_square.h"

namespace shoal {

namespace {

/// The deviation of a compass is another one after a turn by about this angle.
constexpr double kDeviationTurn_rad = 1;

/// Returns the axes of the hull: forward and starboard, as columns; x East, y North.
Eigen::Matrix2d HullAxes(double heading_rad) {
  const auto [s, c] = SinCos(heading_rad);
  return Eigen::Matrix2d{{s, c}, {c, -s}};
}

/// Returns how the axes change with the heading: forward turns to starboard.
Eigen::Matrix2d TurnOfAxes(const Eigen::Matrix2d& axes) {
  Eigen::Matrix2d turn;
  turn.col(0) = axes.col(1);
  turn.col(1) = -axes.col(0);
  return turn;
}

}  // namespace

NavigationFilter::NavigationFilter(const FilterOptions& options, const NavigationSolution& start,
                                   const StateVector& sigmas)
    : options_(options),
      gates_{0, ChiSquareQuantile(1, options.gate_probability),
             ChiSquareQuantile(2, options.gate_probability),
             ChiSquareQuantile(3, options.gate_probability)},
      solution_(start),
      covariance_(sigmas.cwiseAbs2().asDiagonal()) {
  SHOAL_CHECK(sigmas.minCoeff() >= 0, "sigmas >= 0");
}

Eigen::Vector2d NavigationFilter::over_ground_mps() const {
  return HullAxes(solution_.heading_rad) * solution_.in_water_mps + solution_.current_mps;
}

void NavigationFilter::Propagate(double yaw_rate_radps, double dt_s) {
  SHOAL_CHECK(dt_s > 0, "dt_s > 0");
  const double turn_rad = (yaw_rate_radps - solution_.gyro_bias_radps) * dt_s;
  const Eigen::Matrix2d axes = HullAxes(solution_.heading_rad + turn_rad / 2);
  const Eigen::Vector2d by_heading_m = TurnOfAxes(axes) * solution_.in_water_mps * dt_s;
  const double keep_sway = Exp(-dt_s / options_.sway_time_s);
  const double rate_radps = yaw_rate_radps - solution_.gyro_bias_radps;
  const double turn_sway_mps = NextSway(options_.sway_in_turns, sway_in_turn_mps_,
                                        solution_.in_water_mps.x(), rate_radps, dt_s);
  // The deviation that was known is forgotten as the heading changes.
  const double keep_bias =
      options_.compass_deviation_rad > 0 ? Exp(-std::abs(turn_rad) / kDeviationTurn_rad) : 1;

  StateMatrix step = StateMatrix::Identity();
  step.block<2, 1>(kStateX, kStateHeading) = by_heading_m;
  step.block<2, 1>(kStateX, kStateGyroBias) = -dt_s / 2 * by_heading_m;
  step.block<2, 2>(kStateX, kStateForward) = axes * dt_s;
  step.block<2, 2>(kStateX, kStateCurrentX) = Eigen::Matrix2d::Identity() * dt_s;
  step(kStateHeading, kStateGyroBias) = -dt_s;
  step(kStateStarboard, kStateStarboard) = keep_sway;
  step(kStateCompassBias, kStateCompassBias) = keep_bias;
  step(kStateClock, kStateClockDrift) = dt_s;

  solution_.position_m += (axes * solution_.in_water_mps + solution_.current_mps) * dt_s;
  solution_.heading_rad = WrapTwoPi(solution_.heading_rad + turn_rad);
  solution_.in_water_mps.y() =
      turn_sway_mps + keep_sway * (solution_.in_water_mps.y() - sway_in_turn_mps_);
  sway_in_turn_mps_ = turn_sway_mps;
  solution_.compass_bias_rad *= keep_bias;
  solution_.clock_m += solution_.clock_drift_mps * dt_s;

  const auto squared = [](double value) { return value * value; };
  StateVector noise = StateVector::Zero();
  noise[kStateHeading] = squared(options_.gyro_noise_rad_per_rts) * dt_s;
  noise[kStateGyroBias] = squared(options_.gyro_bias_walk_radps_per_rts) * dt_s;
  noise[kStateForward] = squared(options_.speed_walk_mps_per_rts) * dt_s;
  noise[kStateStarboard] =
      (squared(options_.sway_mps) + squared(options_.sway_share * turn_sway_mps)) *
      (1 - squared(keep_sway));
  noise[kStateCurrentX] = noise[kStateCurrentY] = squared(options_.current_walk_mps_per_rts) * dt_s;
  noise[kStateCompassBias] =
      (squared(options_.compass_bias_rad) + squared(options_.compass_deviation_rad)) *
      (1 - squared(keep_bias));
  const StateMatrix stepped = step * covariance_;
  covariance_.noalias() = stepped * step.transpose();
  covariance_.diagonal() += noise;
}

template <int kSize>
UpdateResult NavigationFilter::Update(const Eigen::Matrix<double, kSize, 1>& innovation,
                                      const Jacobian<kSize>& jacobian,
                                      const Eigen::Matrix<double, kSize, kSize>& noise) {
  const Eigen::Matrix<double, kNumStates, kSize> cross = covariance_ * jacobian.transpose();
  const Eigen::Matrix<double, kSize, kSize> spread = jacobian * cross + noise;
  const Eigen::Matrix<double, kSize, kSize> inverse = spread.inverse();
  UpdateResult result;
  result.gate = gates_[kSize];
  result.innovation = innovation[0];
  result.distance2 = innovation.dot(inverse * innovation);
  // False, too, where nothing is uncertain: nothing can be learned.
  result.is_accepted = result.distance2 <= result.gate;
  if (!result.is_accepted) return result;
  const Eigen::Matrix<double, kNumStates, kSize> gain = cross * inverse;
  Add(gain * innovation);
  StateMatrix keep = StateMatrix::Identity();
  keep.noalias() -= gain * jacobian;
  const StateMatrix kept = keep * covariance_;
  const StateMatrix joseph = kept * keep.transpose() + gain * noise * gain.transpose();
  covariance_ = (joseph + joseph.transpose()) / 2;
  return result;
}

template <int kSize>
UpdateResult NavigationFilter::UpdateInsistent(const Eigen::Matrix<double, kSize, 1>& innovation,
                                               const Jacobian<kSize>& jacobian,
                                               const Eigen::Matrix<double, kSize, kSize>& noise,
                                               std::initializer_list<int> states, int most,
                                               int* count) {
  UpdateResult result = Update<kSize>(innovation, jacobian, noise);
  if (!result.is_accepted && ++*count >= most) {
    for (const int state : states) covariance_(state, state) += innovation.squaredNorm();
    result = Update<kSize>(innovation, jacobian, noise);
  }
  if (result.is_accepted) *count = 0;
  return result;
}

void NavigationFilter::Add(const StateVector& error) {
  solution_.position_m += error.segment<2>(kStateX);
  solution_.heading_rad = WrapTwoPi(solution_.heading_rad + error[kStateHeading]);
  solution_.gyro_bias_radps += error[kStateGyroBias];
  solution_.in_water_mps += error.segment<2>(kStateForward);
  solution_.current_mps += error.segment<2>(kStateCurrentX);
  solution_.dvl_scale += error[kStateDvlScale];
  solution_.compass_bias_rad += error[kStateCompassBias];
  solution_.clock_m += error[kStateClock];
  solution_.clock_drift_mps += error[kStateClockDrift];
}

UpdateResult NavigationFilter::UpdateCompass(double heading_rad) {
  Jacobian<1> jacobian = Jacobian<1>::Zero();
  jacobian[kStateHeading] = 1;
  jacobian[kStateCompassBias] = 1;
  const Eigen::Matrix<double, 1, 1> innovation{
      WrapPi(heading_rad - solution_.heading_rad - solution_.compass_bias_rad)};
  return UpdateInsistent<1>(
      innovation, jacobian,
      Eigen::Matrix<double, 1, 1>{options_.compass_noise_rad * options_.compass_noise_rad},
      {kStateHeading, kStateCompassBias}, options_.most_rejected_headings, &rejected_compass_);
}

UpdateResult NavigationFilter::UpdateDvl(const Eigen::Vector2d& over_ground_mps) {
  const Eigen::Matrix2d axes = HullAxes(solution_.heading_rad);
  const Eigen::Vector2d expected_mps =
      solution_.in_water_mps + axes.transpose() * solution_.current_mps;
  const double scale = 1 + solution_.dvl_scale;
  Jacobian<2> jacobian = Jacobian<2>::Zero();
  jacobian.block<2, 2>(0, kStateForward) = scale * Eigen::Matrix2d::Identity();
  jacobian.block<2, 2>(0, kStateCurrentX) = scale * axes.transpose();
  jacobian.col(kStateHeading) = scale * (TurnOfAxes(axes).transpose() * solution_.current_mps);
  jacobian.col(kStateDvlScale) = expected_mps;
  return UpdateInsistent<2>(
      over_ground_mps - scale * expected_mps, jacobian,
      options_.dvl_noise_mps * options_.dvl_noise_mps * Eigen::Matrix2d::Identity(),
      {kStateForward, kStateStarboard}, options_.most_rejected_speeds, &rejected_dvl_);
}

UpdateResult NavigationFilter::UpdateLog(double forward_mps) {
  Jacobian<1> jacobian = Jacobian<1>::Zero();
  jacobian[kStateForward] = 1;
  const Eigen::Matrix<double, 1, 1> innovation{forward_mps - solution_.in_water_mps.x()};
  const Eigen::Matrix<double, 1, 1> noise{options_.log_noise_mps * options_.log_noise_mps};
  return UpdateInsistent<1>(innovation, jacobian, noise, {kStateForward, kStateStarboard},
                            options_.most_rejected_speeds, &rejected_log_);
}

UpdateResult NavigationFilter::UpdateGps(const Eigen::Vector2d& position_m) {
  Jacobian<2> jacobian = Jacobian<2>::Zero();
  jacobian.block<2, 2>(0, kStateX).setIdentity();
  const Eigen::Vector2d innovation_m = position_m - solution_.position_m;
  const Eigen::Matrix2d noise_m2 =
      options_.gps_noise_m * options_.gps_noise_m * Eigen::Matrix2d::Identity();
  return UpdateInsistent<2>(innovation_m, jacobian, noise_m2, {kStateX, kStateY},
                            options_.most_rejected_fixes, &rejected_fixes_);
}

UpdateResult NavigationFilter::UpdateRange(const BeaconFix& beacon, double depth_m, double range_m,
                                           double noise_m, bool is_one_way) {
  if (beacon.number >= rejected_ranges_.size()) rejected_ranges_.resize(beacon.number + 1);
  int* num_rejected = &rejected_ranges_[beacon.number];
  const Eigen::Vector2d away_m = solution_.position_m - beacon.position_m.head<2>();
  const double expected_m = Hypot(away_m.norm(), depth_m - beacon.position_m.z());
  Jacobian<1> jacobian = Jacobian<1>::Zero();
  if (expected_m > 0) jacobian.segment<2>(kStateX) = away_m.transpose() / expected_m;
  // The place of the beacon is wrong along the range by as much as in x and y.
  const double beacon_m = beacon.sigma_m * jacobian.segment<2>(kStateX).norm();
  double innovation_m = range_m - expected_m;
  if (is_one_way) {
    jacobian[kStateClock] = 1;
    innovation_m -= solution_.clock_m;
  }
  const Eigen::Matrix<double, 1, 1> innovation{innovation_m};
  const Eigen::Matrix<double, 1, 1> noise{noise_m * noise_m + beacon_m * beacon_m};
  const int most = options_.most_rejected_ranges;
  if (!is_one_way) {
    return UpdateInsistent<1>(innovation, jacobian, noise, {kStateX, kStateY}, most, num_rejected);
  }
  // It may as well be the clock that is wrong, by more than its data sheet has it.
  return UpdateInsistent<1>(innovation, jacobian, noise, {kStateX, kStateY, kStateClock}, most,
                            num_rejected);
}

UpdateResult NavigationFilter::UpdateDirection(const BeaconFix& beacon, double depth_m,
                                               const UsblReading& direction,
                                               const UsblErrors& errors) {
  const Eigen::Vector2d way_m = beacon.position_m.head<2>() - solution_.position_m;
  const double level_m = way_m.norm();
  const double below_m = beacon.position_m.z() - depth_m;
  if (level_m <= 0) return {};
  const double range2_m2 = level_m * level_m + below_m * below_m;
  // The bearing of the way (x, y) is atan2(x, y); its depression atan2(below, level).
  const Eigen::RowVector2d bearing_by_way(way_m.y() / (level_m * level_m),
                                          -way_m.x() / (level_m * level_m));
  const Eigen::RowVector2d depression_by_way = -below_m / (range2_m2 * level_m) * way_m.transpose();
  Jacobian<2> jacobian = Jacobian<2>::Zero();
  jacobian.block<1, 2>(0, kStateX) = -bearing_by_way;
  jacobian.block<1, 2>(1, kStateX) = -depression_by_way;
  jacobian(0, kStateHeading) = -1;
  const Eigen::Vector2d innovation(
      WrapPi(direction.bearing_rad - (HeadingOf(way_m) - solution_.heading_rad)),
      direction.depression_rad - Atan2(below_m, level_m));
  Eigen::Matrix2d noise = Eigen::Vector2d(errors.bearing_noise_rad * errors.bearing_noise_rad,
                                          errors.depression_noise_rad * errors.depression_noise_rad)
                              .asDiagonal();
  const double sigma2_m2 = beacon.sigma_m * beacon.sigma_m;
  noise(0, 0) += sigma2_m2 * bearing_by_way.squaredNorm();
  noise(1, 1) += sigma2_m2 * depression_by_way.squaredNorm();
  return UpdateInsistent<2>(innovation, jacobian, noise, {kStateHeading},
                            options_.most_rejected_ranges, &rejected_directions_);
}

StateVector NavigationFilter::ErrorsOf(const NavigationSolution& truth) const {
  StateVector errors;
  errors << truth.position_m - solution_.position_m,
      WrapPi(truth.heading_rad - solution_.heading_rad),
      truth.gyro_bias_radps - solution_.gyro_bias_radps,
      truth.in_water_mps - solution_.in_water_mps, truth.current_mps - solution_.current_mps,
      truth.dvl_scale - solution_.dvl_scale, truth.compass_bias_rad - solution_.compass_bias_rad,
      truth.clock_m - solution_.clock_m, truth.clock_drift_mps - solution_.clock_drift_mps;
  return errors;
}

ErrorEllipse EllipseOf(const Eigen::Matrix2d& covariance_m2, double probability) {
  // Eigenvalues and direction of a symmetric matrix of two rows, in closed form.
  const double mean = (covariance_m2(0, 0) + covariance_m2(1, 1)) / 2;
  const double half_difference = (covariance_m2(1, 1) - covariance_m2(0, 0)) / 2;
  const double radius = Hypot(half_difference, covariance_m2(0, 1));
  const double scale = std::sqrt(-2 * Log1p(-probability));
  const double heading_rad = Atan2(covariance_m2(0, 1), half_difference) / 2;
  return {.major_m = scale * std::sqrt(std::max(0.0, mean + radius)),
          .minor_m = scale * std::sqrt(std::max(0.0, mean - radius)),
          .heading_rad = heading_rad < 0 ? heading_rad + kPi : heading_rad};
}

}  // namespace shoal
