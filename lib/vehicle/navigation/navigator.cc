#include "lib/vehicle/navigation/navigator.h"

#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kEllipseProbability = 0.95;

}  // namespace

FilterOptions FilterFor(const InstrumentOptions& options, FilterOptions tuning) {
  tuning.gyro_noise_rad_per_rts = options.gyro.noise_rad_per_rts;
  tuning.gyro_bias_walk_radps_per_rts = options.gyro.bias_walk_radps_per_rts;
  tuning.compass_noise_rad = options.compass.noise_rad;
  tuning.compass_bias_rad = options.compass.bias_sigma_rad;
  tuning.compass_deviation_rad = DeviationRms(options.compass.deviation);
  tuning.dvl_noise_mps = options.dvl ? options.dvl->noise_mps : 0;
  tuning.log_noise_mps = options.log ? options.log->noise_mps : 0;
  tuning.gps_noise_m = options.gps ? options.gps->noise_m : 0;
  return tuning;
}

Navigator::Navigator(const InstrumentOptions& assumed, const FilterOptions& tuning,
                     const StartKnowledge& knowledge, std::vector<Beacon> beacons,
                     const StreamKey& key)
    : assumed_(assumed),
      filter_options_(FilterFor(assumed, tuning)),
      knowledge_(knowledge),
      beacons_(std::move(beacons)),
      key_(key) {}

void Navigator::Start(const Eigen::Vector2d& position_m, double heading_rad) {
  Stream draws(key_.With("start").With(starts_++));
  NavigationSolution start;
  const double east = draws.Normal();
  const double north = draws.Normal();
  start.position_m = position_m + knowledge_.position_m * Eigen::Vector2d(east, north);
  start.heading_rad = WrapTwoPi(heading_rad + knowledge_.heading_rad * draws.Normal());
  const double sound_speed_mps = assumed_.ranging ? assumed_.ranging->sound_speed_mps : 0;
  StateVector sigmas = StateVector::Zero();
  sigmas[kStateX] = sigmas[kStateY] = knowledge_.position_m;
  sigmas[kStateHeading] = knowledge_.heading_rad;
  sigmas[kStateGyroBias] = assumed_.gyro.bias_sigma_radps;
  // The speed is found by the first reading of log or DVL.
  constexpr double kAnySpeed_mps = 3;
  sigmas[kStateForward] = kAnySpeed_mps;
  sigmas[kStateStarboard] = filter_options_.sway_mps;
  sigmas[kStateCurrentX] = sigmas[kStateCurrentY] = knowledge_.current_mps;
  sigmas[kStateDvlScale] = assumed_.dvl ? assumed_.dvl->scale_sigma : 0;
  sigmas[kStateCompassBias] =
      Hypot(filter_options_.compass_bias_rad, filter_options_.compass_deviation_rad);
  sigmas[kStateClock] = assumed_.clock.phase_sigma_s * sound_speed_mps;
  sigmas[kStateClockDrift] = assumed_.clock.drift_sigma_ppm * 1e-6 * sound_speed_mps;
  filter_.emplace(filter_options_, start, sigmas);
}

void Navigator::Take(const Readings& readings, double dt_s) {
  SHOAL_CHECK(filter_.has_value(), "Take comes after Start");
  if (dt_s > 0) filter_->Propagate(readings.yaw_rate_radps, dt_s);
  depth_m_ = readings.depth_m;
  used_ = {};
  ranges_.clear();
  if (readings.heading_rad) {
    used_.compass = filter_->UpdateCompass(*readings.heading_rad).is_accepted;
  }
  if (readings.forward_mps) used_.log = filter_->UpdateLog(*readings.forward_mps).is_accepted;
  if (readings.over_ground_mps) {
    used_.dvl = filter_->UpdateDvl(*readings.over_ground_mps).is_accepted;
  }
  if (readings.position_m) used_.gps = filter_->UpdateGps(*readings.position_m).is_accepted;
  for (const BeaconReading& reading : readings.beacons) {
    const Beacon& beacon = beacons_.at(reading.beacon);
    const BeaconFix place = {beacon.position_m, beacon.position_sigma_m, reading.beacon};
    RangeUsed used;
    used.beacon = reading.beacon;
    used.range_m = reading.range_m;
    used.result =
        filter_->UpdateRange(place, depth_m_, reading.range_m, assumed_.ranging->errors.noise_m,
                             reading.kind != BeaconKind::kTwoWay);
    // An echo came from another direction too.
    if (reading.direction && used.result.is_accepted) {
      used.direction =
          filter_->UpdateDirection(place, depth_m_, *reading.direction, *assumed_.ranging->usbl);
    }
    ranges_.push_back(used);
  }
}

ErrorEllipse Navigator::ellipse() const {
  return EllipseOf(filter_->covariance().block<2, 2>(kStateX, kStateX), kEllipseProbability);
}

}  // namespace shoal
