#include "lib/vehicle/navigation/ranging.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

double WholeMicroseconds(double time_s) { return std::round(time_s * 1e6) / 1e6; }

/// Returns the additional way of this range. Draws the same numbers whatever the options are.
double RangeError(const RangeErrors& errors, Stream* draws) {
  const double noise = draws->Normal();
  const bool is_outlier = draws->Uniform() < errors.outlier_ratio;
  const double longer = draws->Uniform();
  return errors.noise_m * noise + (is_outlier ? errors.outlier_m * longer : 0);
}

}  // namespace

double ClockOffset_s(const OwnClock& clock, double time_s) {
  return clock.phase_s + clock.drift_ppm * 1e-6 * time_s;
}

double OneWayRange(double range_m, double sound_speed_mps, const OwnClock& clock, double time_s,
                   const RangeErrors& errors, Stream* draws) {
  SHOAL_CHECK(range_m >= 0 && sound_speed_mps > 0, "range_m >= 0, sound_speed_mps > 0");
  const double way_m = range_m + RangeError(errors, draws);
  return WholeMicroseconds(way_m / sound_speed_mps + ClockOffset_s(clock, time_s)) *
         sound_speed_mps;
}

double TwoWayRange(double range_m, double sound_speed_mps, double turnaround_s,
                   const OwnClock& clock, const RangeErrors& errors, Stream* draws) {
  SHOAL_CHECK(range_m >= 0 && sound_speed_mps > 0, "range_m >= 0, sound_speed_mps > 0");
  SHOAL_CHECK(turnaround_s >= 0, "turnaround_s >= 0");
  const double way_m = range_m + RangeError(errors, draws);
  const double elapsed_s =
      (2 * way_m / sound_speed_mps + turnaround_s) * (1 + clock.drift_ppm * 1e-6);
  return (WholeMicroseconds(elapsed_s) - turnaround_s) / 2 * sound_speed_mps;
}

UsblReading TrueUsbl(const Eigen::Vector3d& position_m, double heading_rad,
                     const Eigen::Vector3d& target_m) {
  const Eigen::Vector3d way_m = target_m - position_m;
  return {.range_m = way_m.norm(),
          .bearing_rad = WrapPi(HeadingOf(way_m.head<2>()) - heading_rad),
          .depression_rad = Atan2(way_m.z(), way_m.head<2>().norm())};
}

UsblReading WithNoise(const UsblReading& truth, const UsblErrors& errors, Stream* draws) {
  const double bearing = draws->Normal();
  const double depression = draws->Normal();
  return {.range_m = truth.range_m,
          .bearing_rad = WrapPi(truth.bearing_rad + errors.bearing_noise_rad * bearing),
          .depression_rad = std::clamp(
              truth.depression_rad + errors.depression_noise_rad * depression, -kPi / 2, kPi / 2)};
}

}  // namespace shoal
