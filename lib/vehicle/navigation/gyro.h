// A yaw rate gyro: noise that integrates to an angle random walk, and a bias that wanders.
#pragma once

#include <cstdint>

#include "lib/base/random/stream.h"

namespace shoal {

/// Units as in data sheets, but in radians and seconds (Groves, Principles of GNSS, Inertial, and
/// Multisensor Integrated Navigation Systems, 2013, 4.4).
struct Gyro {
  double bias_radps = 0;               ///< At the start, clockwise.
  double bias_sigma_radps = 0;         ///< Spread of biases, and what a filter assumes; >= 0.
  double noise_rad_per_rts = 0;        ///< Angle random walk, rad per root second; >= 0.
  double bias_walk_radps_per_rts = 0;  ///< Random walk of the bias, rad/s per root second; >= 0.
};

class GyroUnit {
 public:
  explicit GyroUnit(const Gyro& gyro, const StreamKey& key)
      : gyro_(gyro), key_(key), bias_radps_(gyro.bias_radps) {}

  /// Returns the mean yaw rate over the `dt_s` that end at `utime`, in which the vehicle turned by
  /// `turn_rad`, both clockwise. @pre dt_s > 0
  double Read(double turn_rad, double dt_s, int64_t utime);

  double bias_radps() const { return bias_radps_; }

 private:
  Gyro gyro_;
  StreamKey key_;
  double bias_radps_;
};

}  // namespace shoal
