#include "apps/vehicle_sim/navigation_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/file/ray_surroundings.h"
#include "lib/vehicle/navigation/assumed_motion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal {

namespace {

InstrumentOptions AssumedOf(const Mission& mission, const Vehicle& vehicle) {
  return InstrumentsOf(vehicle.navigation, mission.acoustics.options.sound_speed_mps);
}

FilterOptions TuningOf(const Vehicle& vehicle) {
  FilterOptions tuning;
  tuning.gate_probability = vehicle.navigation.gate_probability;
  if (const auto* remus100 = std::get_if<Remus100Options>(&vehicle.model)) {
    AssumeMotionOf(BuildRemus100(ParamsOf(*remus100)), &tuning);
  }
  return tuning;
}

std::vector<Beacon> BeaconsOf(const Mission& mission) {
  std::vector<Beacon> beacons;
  for (const BeaconOptions& options : mission.beacons) {
    beacons.push_back({.name = options.name,
                       .position_m = {options.point_m.x(), options.point_m.y(), options.depth_m},
                       .position_sigma_m = options.position_sigma_m,
                       .kind = options.kind == "packets"   ? BeaconKind::kPackets
                               : options.kind == "one_way" ? BeaconKind::kOneWay
                                                           : BeaconKind::kTwoWay,
                       .interval_s = options.interval_s,
                       .offset_s = options.offset_s,
                       .turnaround_s = options.turnaround_s});
  }
  return beacons;
}

/// Where sound bends, ranges are by the first arrival of their sound.
TravelTimes TravelTimesOf(const Mission& mission) {
  std::shared_ptr<RayChannel> channel = MakeRayChannel(mission);
  if (channel == nullptr) return {};
  return [channel](const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m) {
    return channel->TravelTime(from_m, to_m);
  };
}

/// Returns the beacons where all vehicles believe them to be.
std::vector<Beacon> SurveyedBeacons(const Mission& mission) {
  std::vector<Beacon> beacons = BeaconsOf(mission);
  for (Beacon& beacon : beacons) {
    Stream draws(mission.seed, "beacon", beacon.name);
    const double east = draws.Normal();
    const double north = draws.Normal();
    beacon.position_m.head<2>() += beacon.position_sigma_m * Eigen::Vector2d(east, north);
  }
  return beacons;
}

/// Returns the components of a velocity over ground: forward, starboard.
Eigen::Vector2d InBody(const Eigen::Vector2d& velocity_mps, double heading_rad) {
  const Eigen::Vector2d forward = UnitVector(heading_rad);
  const Eigen::Vector2d starboard(forward.y(), -forward.x());
  return {forward.dot(velocity_mps), starboard.dot(velocity_mps)};
}

TrueMotion MotionOf(const nav_t& truth, const Eigen::Vector2d& current_mps) {
  const double heading_rad = DegToRad(truth.heading_deg);
  const Eigen::Vector2d over_ground_mps =
      truth.speed_over_ground_mps * UnitVector(DegToRad(truth.course_over_ground_deg));
  TrueMotion motion = {.position_m = {truth.x_m, truth.y_m, truth.z_m},
                       .heading_rad = heading_rad,
                       .over_ground_mps = InBody(over_ground_mps, heading_rad),
                       .in_water_mps = InBody(over_ground_mps - current_mps, heading_rad),
                       .altitude_m = {}};
  if (truth.altitude_m >= 0) motion.altitude_m = truth.altitude_m;
  return motion;
}

}  // namespace

NavigationUnit::NavigationUnit(const Mission& mission, const Vehicle& vehicle)
    : assumed_(AssumedOf(mission, vehicle)),
      drawn_(Drawn(assumed_, StreamKey(mission.seed, "navigation").With(vehicle.name))),
      key_(StreamKey(mission.seed, "navigation").With(vehicle.name)),
      beacon_options_(mission.beacons),
      beacons_(BeaconsOf(mission)),
      report_every_s_(vehicle.navigation.report_every_s),
      start_utime_(mission.start_utime),
      travel_times_(TravelTimesOf(mission)),
      instruments_(drawn_, beacons_, key_, travel_times_),
      navigator_(assumed_, TuningOf(vehicle), StartKnowledgeOf(vehicle.navigation),
                 SurveyedBeacons(mission), key_) {
  takes_packets_ =
      assumed_.ranging && std::any_of(beacons_.begin(), beacons_.end(), [](const Beacon& beacon) {
        return beacon.kind == BeaconKind::kPackets;
      });
  Start(vehicle.start);
}

void NavigationUnit::Start(const StartPose& pose) {
  instruments_ = Instruments(drawn_, beacons_, key_, travel_times_);
  navigator_.Start({pose.x_m, pose.y_m}, DegToRad(pose.heading_deg));
  packets_.clear();
  utime_.reset();
}

void NavigationUnit::TakePacket(const acoustic_rx_t& packet) {
  for (size_t i = 0; i < beacon_options_.size(); ++i) {
    if (beacons_[i].kind != BeaconKind::kPackets) continue;
    if (VehicleKey(beacon_options_[i].sender) != VehicleKey(packet.source)) continue;
    packets_.push_back({.beacon = i, .number = packet.number});
  }
}

nav_t NavigationUnit::Estimate(const nav_t& truth, const Eigen::Vector2d& current_mps,
                               const LocalFrame& frame) {
  const Readings readings =
      instruments_.Read(MotionOf(truth, current_mps), truth.utime, start_utime_, packets_);
  packets_.clear();
  const double dt_s = utime_ ? Seconds(truth.utime - *utime_) : 0;
  utime_ = truth.utime;
  navigator_.Take(readings, dt_s);
  Count();
  report_.has_dvl_lock = readings.has_dvl_lock;
  report_.has_gps_fix = readings.has_gps_fix;

  const NavigationSolution& solution = navigator_.filter().solution();
  nav_t nav = truth;
  nav.x_m = solution.position_m.x();
  nav.y_m = solution.position_m.y();
  nav.z_m = navigator_.depth_m();
  const GeoPoint geo = frame.ToGeo({nav.x_m, nav.y_m});
  nav.lat_deg = geo.lat_deg;
  nav.lon_deg = geo.lon_deg;
  nav.heading_deg = Wrap360(RadToDeg(solution.heading_rad));
  nav.surge_mps = solution.in_water_mps.x();
  nav.sway_mps = solution.in_water_mps.y();
  nav.yaw_rate_degps = RadToDeg(readings.yaw_rate_radps - solution.gyro_bias_radps);
  nav.speed_mps = solution.in_water_mps.norm();
  const Eigen::Vector2d over_ground_mps = navigator_.filter().over_ground_mps();
  nav.speed_over_ground_mps = over_ground_mps.norm();
  nav.course_over_ground_deg = nav.speed_over_ground_mps > 0
                                   ? Wrap360(RadToDeg(HeadingOf(over_ground_mps)))
                                   : nav.heading_deg;
  return nav;
}

void NavigationUnit::Count() {
  const InstrumentsUsed& used = navigator_.used();
  report_.num_compass += used.compass ? 1 : 0;
  report_.num_dvl += used.dvl ? 1 : 0;
  report_.num_log += used.log ? 1 : 0;
  report_.num_gps += used.gps ? 1 : 0;
  for (const RangeUsed& range : navigator_.ranges()) {
    const UpdateResult& result = range.result;
    ++(result.is_accepted ? report_.num_ranges_taken : report_.num_ranges_rejected);
    report_.ranges.push_back({.beacon = beacons_[range.beacon].name,
                              .range_m = range.range_m,
                              .innovation_m = result.innovation,
                              .distance2 = result.distance2,
                              .gate = result.gate,
                              .is_taken = static_cast<int8_t>(result.is_accepted)});
  }
}

std::optional<navigation_t> NavigationUnit::Report(int64_t utime) {
  const auto period = static_cast<int64_t>(
      std::floor(static_cast<double>(utime - start_utime_) / (report_every_s_ * 1e6) + 1e-9));
  if (last_report_ == period) return std::nullopt;
  last_report_ = period;
  const NavigationFilter& filter = navigator_.filter();
  const NavigationSolution& solution = filter.solution();
  const StateMatrix& covariance = filter.covariance();
  const Eigen::Vector2d over_ground_mps = filter.over_ground_mps();
  const ErrorEllipse ellipse = navigator_.ellipse();
  navigation_t report = report_;
  report.utime = utime;
  report.x_m = solution.position_m.x();
  report.y_m = solution.position_m.y();
  report.z_m = navigator_.depth_m();
  report.heading_deg = Wrap360(RadToDeg(solution.heading_rad));
  report.east_mps = over_ground_mps.x();
  report.north_mps = over_ground_mps.y();
  report.current_east_mps = solution.current_mps.x();
  report.current_north_mps = solution.current_mps.y();
  report.gyro_bias_degps = RadToDeg(solution.gyro_bias_radps);
  report.compass_bias_deg = RadToDeg(solution.compass_bias_rad);
  report.dvl_scale_error = solution.dvl_scale;
  report.clock_offset_s =
      assumed_.ranging ? solution.clock_m / assumed_.ranging->sound_speed_mps : 0;
  report.variance_x_m2 = covariance(kStateX, kStateX);
  report.variance_y_m2 = covariance(kStateY, kStateY);
  report.covariance_xy_m2 = covariance(kStateX, kStateY);
  report.heading_sigma_deg = RadToDeg(std::sqrt(covariance(kStateHeading, kStateHeading)));
  report.ellipse_major_m = ellipse.major_m;
  report.ellipse_minor_m = ellipse.minor_m;
  report.ellipse_heading_deg = RadToDeg(ellipse.heading_rad);
  report.num_ranges = static_cast<int32_t>(report.ranges.size());
  report_.ranges.clear();
  return report;
}

std::string NavigationUnit::StatusText() const {
  const NavigationSolution& solution = navigator_.filter().solution();
  const ErrorEllipse ellipse = navigator_.ellipse();
  return fmt::format(
      "    Estimate: x {:.2f} m, y {:.2f} m, heading {:.1f} deg; 95 % within {:.1f} x {:.1f} m\n"
      "    Bottom lock: {}, GPS: {}\n"
      "    Taken: compass {}, DVL {}, log {}, GPS {}, ranges {} ({} rejected)\n",
      solution.position_m.x(), solution.position_m.y(), RadToDeg(solution.heading_rad),
      ellipse.major_m, ellipse.minor_m, report_.has_dvl_lock ? "yes" : "no",
      report_.has_gps_fix ? "fix" : "no fix", report_.num_compass, report_.num_dvl, report_.num_log,
      report_.num_gps, report_.num_ranges_taken, report_.num_ranges_rejected);
}

}  // namespace shoal
