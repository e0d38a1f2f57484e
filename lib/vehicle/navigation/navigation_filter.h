// Dead reckoning with an error-state Kalman filter.
//
//   NavigationFilter filter(options, start);
//   filter.Propagate(yaw_rate_radps, dt_s);
//   filter.UpdateCompass(heading_rad);
//   if (const auto result = filter.UpdateGps(fix_m); !result.is_accepted) ...
//
// The nominal state is propagated without approximation of its equations, the covariance of its
// error by their derivatives; an update estimates the error, adds it to the nominal state and
// begins again at zero (Solà, "Quaternion kinematics for the error-state Kalman filter", 2017,
// 5 and 6; with one angle, the heading, the reset leaves the covariance as it is). Updates are in
// Joseph's form (Bucy and Joseph, 1968). The vehicle's velocity over ground is that relative to
// the water plus the current, so that what the DVL has found of the current still counts where
// bottom lock is lost, and what a fix finds of it counts for a vehicle without DVL.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <vector>

#include "lib/vehicle/navigation/ranging.h"
#include "lib/vehicle/vehicle/sway_in_turns.h"

namespace shoal {

/// Where each error is in the state.
enum NavigationState {
  kStateX,          ///< m, East.
  kStateY,          ///< m, North.
  kStateHeading,    ///< rad, clockwise.
  kStateGyroBias,   ///< rad/s.
  kStateForward,    ///< m/s, relative to the water.
  kStateStarboard,  ///< m/s, relative to the water.
  kStateCurrentX,   ///< m/s over ground, East.
  kStateCurrentY,   ///< m/s over ground, North.
  kStateDvlScale,
  kStateCompassBias,  ///< rad.
  kStateClock,        ///< m: the own clock's offset times the speed of sound.
  kStateClockDrift,   ///< m/s.
  kNumStates
};

using StateVector = Eigen::Matrix<double, kNumStates, 1>;
using StateMatrix = Eigen::Matrix<double, kNumStates, kNumStates>;

/// What the filter assumes; standard deviations, >= 0.
struct FilterOptions {
  double gyro_noise_rad_per_rts = 0;
  double gyro_bias_walk_radps_per_rts = 0;
  double compass_noise_rad = 0;
  double compass_bias_rad = 0;       ///< Of the bias, which stays.
  double compass_deviation_rad = 0;  ///< Of the deviation, which changes with the heading.
  double dvl_noise_mps = 0;
  double log_noise_mps = 0;
  double gps_noise_m = 0;
  double speed_walk_mps_per_rts = 0.2;      ///< How fast the forward speed changes.
  SwayInTurns sway_in_turns = {};           ///< Of the vehicle's model.
  double sway_mps = 0.05;                   ///< Of the sway beside that, which comes and goes ...
  double sway_share = 0;                    ///< ... and of its share in a turn ...
  double sway_time_s = 5;                   ///< ... within about this time; > 0.
  double current_walk_mps_per_rts = 0.002;  ///< How fast the current changes.
  double gate_probability = 0.999;          ///< Of keeping a good measurement; 0 .. 1, not 1.
  /// This many readings of log or DVL rejected in a row are believed all the same: the speed
  /// has changed faster than it assumes; > 0.
  int most_rejected_speeds = 2;
  /// This many GPS fixes rejected in a row are believed all the same: the filter has lost
  /// its way, and widens its covariance by what they show; > 0.
  int most_rejected_fixes = 5;
  /// This many ranges of one beacon or directions rejected in a row are believed all the same; > 0.
  /// An echo comes by chance, and an error that stays is the filter's own.
  int most_rejected_ranges = 4;
  /// Likewise of the compass, whose disturbances last some seconds.
  int most_rejected_headings = 100;
};

/// The nominal state.
struct NavigationSolution {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< x East, y North.
  double heading_rad = 0;                                ///< Clockwise, [0, 2 pi).
  double gyro_bias_radps = 0;
  Eigen::Vector2d in_water_mps = Eigen::Vector2d::Zero();  ///< Forward, starboard.
  Eigen::Vector2d current_mps = Eigen::Vector2d::Zero();   ///< x East, y North.
  double dvl_scale = 0;
  double compass_bias_rad = 0;
  double clock_m = 0;
  double clock_drift_mps = 0;
};

/// What became of one measurement.
struct UpdateResult {
  bool is_accepted = false;
  double distance2 = 0;   ///< Innovation squared over its covariance (Mahalanobis, 1936).
  double gate = 0;        ///< The greatest distance2 that is accepted.
  double innovation = 0;  ///< Its first component: metres of a range, east of a fix.
};

/// Where a beacon is.
struct BeaconFix {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< z down.
  double sigma_m = 0;                                    ///< Of x and y; >= 0.
  size_t number = 0;                                     ///< Which of the beacons.
};

class NavigationFilter {
 public:
  /// `sigmas` holds the standard deviation of each state at the start, >= 0.
  NavigationFilter(const FilterOptions& options, const NavigationSolution& start,
                   const StateVector& sigmas);

  /// Goes on by `dt_s` > 0, in which the gyro read this mean rate, clockwise.
  void Propagate(double yaw_rate_radps, double dt_s);

  UpdateResult UpdateCompass(double heading_rad);
  /// Velocity over ground: forward, starboard.
  UpdateResult UpdateDvl(const Eigen::Vector2d& over_ground_mps);
  UpdateResult UpdateLog(double forward_mps);
  UpdateResult UpdateGps(const Eigen::Vector2d& position_m);
  /// A range to a beacon from `depth_m`, by the own clock where it is one-way.
  UpdateResult UpdateRange(const BeaconFix& beacon, double depth_m, double range_m, double noise_m,
                           bool is_one_way);
  /// The direction to a beacon: bearing from the bow, and depression. The horizontal distance is
  /// > 0 as far as the filter knows, or it is rejected.
  UpdateResult UpdateDirection(const BeaconFix& beacon, double depth_m,
                               const UsblReading& direction, const UsblErrors& errors);

  const NavigationSolution& solution() const { return solution_; }
  /// Of the errors, symmetric.
  const StateMatrix& covariance() const { return covariance_; }
  /// Returns the velocity over ground, x East, y North.
  [[nodiscard]] Eigen::Vector2d over_ground_mps() const;

  /// Returns the errors against a known truth, in the order of the states.
  [[nodiscard]] StateVector ErrorsOf(const NavigationSolution& truth) const;

 private:
  template <int kSize>
  using Jacobian = Eigen::Matrix<double, kSize, kNumStates>;

  template <int kSize>
  UpdateResult Update(const Eigen::Matrix<double, kSize, 1>& innovation,
                      const Jacobian<kSize>& jacobian,
                      const Eigen::Matrix<double, kSize, kSize>& noise);
  /// Updates with a measurement of which `most` rejected in a row, as `count` counts them, are
  /// believed: the variance of the `states`, in what they are, grows by the innovation squared.
  template <int kSize>
  UpdateResult UpdateInsistent(const Eigen::Matrix<double, kSize, 1>& innovation,
                               const Jacobian<kSize>& jacobian,
                               const Eigen::Matrix<double, kSize, kSize>& noise,
                               std::initializer_list<int> states, int most, int* count);
  void Add(const StateVector& error);

  FilterOptions options_;
  std::array<double, 4> gates_;  ///< By the number of components.
  NavigationSolution solution_;
  StateMatrix covariance_;
  int rejected_fixes_ = 0;  ///< In a row; likewise the others.
  int rejected_dvl_ = 0;
  int rejected_log_ = 0;
  int rejected_compass_ = 0;
  int rejected_directions_ = 0;
  std::vector<int> rejected_ranges_ = {};  ///< By the number of the beacon.
  double sway_in_turn_mps_ = 0;  ///< By the model of the vehicle; the state is this and the rest.
};

/// An ellipse that holds the truth with a stated probability.
struct ErrorEllipse {
  double major_m = 0;      ///< Half of the long axis.
  double minor_m = 0;      ///< Half of the short axis.
  double heading_rad = 0;  ///< Of the long axis, clockwise from North, [0, pi).
};

/// Returns the ellipse of a normal distribution (Bar-Shalom, Li and Kirubarajan, Estimation with
/// Applications to Tracking and Navigation, 2001, 1.4). @pre symmetric, 0 <= probability < 1
[[nodiscard]] ErrorEllipse EllipseOf(const Eigen::Matrix2d& covariance_m2, double probability);

}  // namespace shoal
