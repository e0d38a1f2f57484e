// What measures a vehicle's velocity: a Doppler velocity log over ground, a speed log relative to
// the water.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "lib/base/random/stream.h"

namespace shoal {

/// A Doppler velocity log that follows the sea floor.
struct Dvl {
  double min_altitude_m = 0.5;  ///< Bottom lock from here ...
  double max_altitude_m = 80;   ///< ... to here, both included.
  double scale_error = 0;       ///< It measures 1 + this times the velocity.
  double scale_sigma = 0;       ///< Spread of scale errors, and what a filter assumes; >= 0.
  double noise_mps = 0;         ///< Standard deviation of each component; >= 0.
  double dropout = 0;           ///< Probability that a ping gives nothing; 0 .. 1.
  double rate_hz = 2;           ///< Pings per second; > 0.
};

/// Returns true where the floor is within reach; false for an altitude that is not known.
[[nodiscard]] bool HasBottomLock(const Dvl& dvl, std::optional<double> altitude_m);

/// Returns the velocity over ground, forward and starboard in the horizontal plane; nothing without
/// bottom lock or where the ping is lost. Draws the same numbers in each case.
[[nodiscard]] std::optional<Eigen::Vector2d> ReadDvl(const Dvl& dvl,
                                                     const Eigen::Vector2d& over_ground_mps,
                                                     std::optional<double> altitude_m,
                                                     Stream* draws);

/// A log that measures the forward speed relative to the water.
struct SpeedLog {
  double noise_mps = 0;  ///< Standard deviation; >= 0.
  double rate_hz = 2;    ///< Readings per second; > 0.
};

[[nodiscard]] double ReadSpeedLog(const SpeedLog& log, double forward_mps, Stream* draws);

/// A pressure sensor.
struct DepthSensor {
  double bias_m = 0;        ///< Added to every reading.
  double bias_sigma_m = 0;  ///< Spread of biases; >= 0.
  double noise_m = 0;       ///< Standard deviation; >= 0.
};

[[nodiscard]] double ReadDepth(const DepthSensor& sensor, double depth_m, Stream* draws);

}  // namespace shoal
