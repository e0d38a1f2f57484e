// Ranges and directions from the travel time of sound: one way, two ways, ultra-short baseline.
//
// Clocks and modems count whole microseconds, so a range is known to half of one times the speed
// of sound (one way) or a quarter (two ways), before any other error.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "lib/base/random/stream.h"

namespace shoal {

/// A vehicle's clock: its offset is phase_s at time 0 and grows by drift_ppm microseconds a second.
struct OwnClock {
  double phase_s = 0;
  double phase_sigma_s = 0;  ///< Spread of phases, and what a filter assumes; >= 0.
  double drift_ppm = 0;
  double drift_sigma_ppm = 0;  ///< The same of drifts.
};

/// Returns how much the clock is ahead of the right time.
[[nodiscard]] double ClockOffset_s(const OwnClock& clock, double time_s);

/// Errors of one kind of range.
struct RangeErrors {
  double noise_m = 0;        ///< Standard deviation; >= 0.
  double outlier_ratio = 0;  ///< Share of ranges by an echo that took a longer way; 0 .. 1.
  double outlier_m = 0;      ///< Such a way is longer by 0 to this, uniformly; >= 0.
};

/// Returns the range by the travel time from a sender that shares the right time, whole
/// microseconds by the receiver's clock. Positive offsets make it longer.
/// @pre range_m >= 0, sound_speed_mps > 0
[[nodiscard]] double OneWayRange(double range_m, double sound_speed_mps, const OwnClock& clock,
                                 double time_s, const RangeErrors& errors, Stream* draws);

/// Returns the range by the time from question to answer less `turnaround_s`, which the answering
/// side keeps; the asking clock counts, drifts, and its offset falls out.
/// @pre range_m >= 0, sound_speed_mps > 0, turnaround_s >= 0
[[nodiscard]] double TwoWayRange(double range_m, double sound_speed_mps, double turnaround_s,
                                 const OwnClock& clock, const RangeErrors& errors, Stream* draws);

/// What an ultra-short baseline array on the vehicle measures of a transponder.
struct UsblReading {
  double range_m = 0;
  double bearing_rad = 0;     ///< From the bow, clockwise, (-pi, pi].
  double depression_rad = 0;  ///< Below the horizontal, -pi/2 .. pi/2.
};

struct UsblErrors {
  double bearing_noise_rad = 0;     ///< Standard deviation; >= 0.
  double depression_noise_rad = 0;  ///< Standard deviation; >= 0.
};

/// Returns range, bearing and depression of `target_m` without errors; x East, y North, z down.
[[nodiscard]] UsblReading TrueUsbl(const Eigen::Vector3d& position_m, double heading_rad,
                                   const Eigen::Vector3d& target_m);

/// Returns the direction with noise; the range is as given.
[[nodiscard]] UsblReading WithNoise(const UsblReading& truth, const UsblErrors& errors,
                                    Stream* draws);

}  // namespace shoal
