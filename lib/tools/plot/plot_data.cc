#include "lib/tools/plot/plot_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/tools/plot/plot_distances.h"

namespace shoal {

namespace {

/// What begins later than this counts from no mission's start: three years.
constexpr int64_t kWallTime_us = 100'000'000'000'000;
constexpr size_t kMaxRunsOfAll = 46'000;  // Of each kind of curve: some 80 MB for seventeen.
constexpr size_t kFewestRuns = 32;
constexpr size_t kMaxWaypoints = 500;
/// A position this old has no neighbours any more.
constexpr int64_t kStale_us = 2'000'000;
/// A vehicle that moves more slowly than this over ground has no course.
constexpr double kNoCourse_mps = 0.1;
/// A vehicle that moves more slowly than this relative to the water drifts: its heading
/// does not show its course.
constexpr double kDrifts_mps = 0.3;
constexpr double kDives_m = 0.1;

bool IsFinite(double value) { return std::isfinite(value) && std::abs(value) < 1e9; }

template <class Visit>
void ForEachCurve(VehicleCurves* curves, const Visit& visit) {
  for (ThinnedCurve* curve : {&curves->track,
                              &curves->depth_m,
                              &curves->floor_m,
                              &curves->cross_track_m,
                              &curves->crab_deg,
                              &curves->expected_crab_deg,
                              &curves->desired_depth_m,
                              &curves->pitch_deg,
                              &curves->desired_pitch_deg,
                              &curves->nearest_m,
                              &curves->target_m,
                              &curves->target_age_s,
                              &curves->other_age_s,
                              &curves->thrust_pct,
                              &curves->propeller_rpm,
                              &curves->rudder_deg,
                              &curves->stern_plane_deg,
                              &curves->speed_mps,
                              &curves->desired_speed_mps,
                              &curves->heading_deg,
                              &curves->desired_heading_deg,
                              &curves->navigation_error_m,
                              &curves->navigation_bound_m,
                              &curves->believed_track}) {
    visit(curve);
  }
  for (LayerCurves& layer : curves->layers) {
    visit(&layer.weight);
    visit(&layer.asks);
  }
}

}  // namespace

PlotDataBuilder::PlotDataBuilder(PlotSelection selection, const PlotSetting& setting)
    : selection_(std::move(selection)),
      zero_utime_(setting.start_utime),
      contacts_(setting.vehicles) {
  for (std::string& name : selection_.vehicles) name = UpperCase(name);
  for (const PlannedVehicle& vehicle : setting.vehicles) {
    if (!vehicle.target.empty()) targets_[UpperCase(vehicle.name)] = UpperCase(vehicle.target);
  }
}

void PlotDataBuilder::Add(const LogEvent& event) {
  const auto take = [&]<class T>(T message, auto use) {
    if (Decode(Unseal(event.data).message, &message)) {
      use(message);
    } else {
      ++data_.num_undecodable;
    }
  };
  const auto take_of_vehicle = [&]<class T>(std::string_view topic, T message,
                                            void (PlotDataBuilder::*add)(Vehicle*, const T&)) {
    const std::string_view name = VehicleOfChannel(event.channel, topic);
    if (name.empty()) return false;
    take(message, [&](const T& decoded) {
      if (Vehicle* vehicle = Find(name)) (this->*add)(vehicle, decoded);
    });
    return true;
  };
  if (event.channel == topics::kNodeReportLocal || event.channel == topics::kNodeReport) {
    take(node_report_t{}, [&](const node_report_t& report) { TakeReport(report); });
    return;
  }
  if (std::ranges::count(DrawingBook::Topics(), event.channel) > 0) {
    TakeDrawing(event);
    return;
  }
  take_of_vehicle(topics::kNav, nav_t{}, &PlotDataBuilder::AddNav) ||
      take_of_vehicle(topics::kHelmState, helm_state_t{}, &PlotDataBuilder::AddHelmState) ||
      take_of_vehicle(topics::kActuators, actuators_t{}, &PlotDataBuilder::AddActuators) ||
      take_of_vehicle(topics::kDesired, desired_t{}, &PlotDataBuilder::AddDesired) ||
      take_of_vehicle(topics::kNavigation, navigation_t{}, &PlotDataBuilder::AddNavigation) ||
      take_of_vehicle(topics::kGuidance, guidance_t{}, &PlotDataBuilder::AddGuidance) ||
      take_of_vehicle(topics::kSwarm, swarm_t{}, &PlotDataBuilder::AddSwarm);
}

/// Drawings last from the time of the vehicles' last NAV.
void PlotDataBuilder::TakeDrawing(const LogEvent& event) {
  const int64_t now_utime = round_utime_;
  const bool is_too_late =
      selection_.to_s && zero_utime_ && Seconds(now_utime - *zero_utime_) > *selection_.to_s;
  if (is_too_late) return;
  if (!drawings_.Take(event.channel, Unseal(event.data).message, now_utime)) {
    ++data_.num_undecodable;
  }
}

/// Returns the vehicle of this name in channels, nullptr where there are too many.
PlotDataBuilder::Vehicle* PlotDataBuilder::Find(std::string_view channel_name) {
  if (const auto found = vehicles_.find(channel_name); found != vehicles_.end()) {
    return &found->second;
  }
  if (vehicles_.size() >= kMaxPlotted) {
    data_.has_too_many = true;
    return nullptr;
  }
  const std::string name(channel_name);
  Vehicle& vehicle = vehicles_[name];
  vehicle.curves.name = name;
  vehicle.is_selected = selection_.vehicles.empty() ||
                        std::find(selection_.vehicles.begin(), selection_.vehicles.end(),
                                  UpperCase(name)) != selection_.vehicles.end();
  if (const auto target = targets_.find(name); target != targets_.end()) {
    vehicle.target = target->second;
  }
  data_.seen.insert(name);
  const size_t max_runs =
      std::clamp(kMaxRunsOfAll / vehicles_.size(), kFewestRuns, ThinnedCurve::kMaxRuns);
  if (max_runs < ThinnedCurve::kMaxRuns) {
    for (auto& [other, each] : vehicles_) {
      ForEachCurve(&each.curves, [&](ThinnedCurve* curve) { curve->LimitTo(max_runs); });
    }
  }
  return &vehicle;
}

/// Returns seconds since the beginning, nothing for what is not selected.
std::optional<double> PlotDataBuilder::TimeOf(int64_t utime) {
  if (utime < -kLatest_us || utime > kLatest_us) {
    ++data_.num_impossible;
    return std::nullopt;
  }
  if (!zero_utime_) {
    data_.zero_is_first = utime > kWallTime_us;
    zero_utime_ = data_.zero_is_first ? utime : 0;
  }
  const double time_s = Seconds(utime - *zero_utime_);
  if (!data_.log_span_s) data_.log_span_s = {time_s, time_s};
  data_.log_span_s->first = std::min(data_.log_span_s->first, time_s);
  data_.log_span_s->second = std::max(data_.log_span_s->second, time_s);
  // Half a microsecond of tolerance: 12.3 is no whole number of microseconds in binary.
  constexpr double kTolerance_s = 0.5e-6;
  if (selection_.from_s && time_s < *selection_.from_s - kTolerance_s) return std::nullopt;
  if (selection_.to_s && time_s > *selection_.to_s + kTolerance_s) return std::nullopt;
  data_.has_selected_times = true;
  return time_s;
}

void PlotDataBuilder::Draw(ThinnedCurve* curve, double x, double y) {
  if (!curve->Add(x, y)) ++data_.num_impossible;
}

void PlotDataBuilder::AddNav(Vehicle* vehicle, const nav_t& nav) {
  const auto time = TimeOf(nav.utime);
  if (!time) return;
  const double time_s = *time;
  if (round_is_open_ && nav.utime != round_utime_) {
    MeasureDistances();
    MarkCollisions();
  }
  round_utime_ = nav.utime;
  round_is_open_ = true;
  if (IsFinite(nav.x_m) && IsFinite(nav.y_m) && IsFinite(nav.z_m)) {
    vehicle->position_m = {nav.x_m, nav.y_m, nav.z_m};
    vehicle->nav_utime = nav.utime;
    if (contacts_.Move(UpperCase(vehicle->curves.name), vehicle->position_m, nav.altitude_m)) {
      Mark(*vehicle, &data_.groundings);
    }
    DrawNavigation(vehicle);
  }
  if (!vehicle->is_selected) return;
  if (!std::exchange(has_drawn_, true)) data_.first_s = data_.last_s = time_s;
  data_.first_s = std::min(data_.first_s, time_s);
  data_.last_s = std::max(data_.last_s, time_s);

  VehicleCurves& curves = vehicle->curves;
  if (curves.track.Add(nav.x_m, nav.y_m)) {
    const CurvePoint here{nav.x_m, nav.y_m};
    if (!curves.start) curves.start = here;
    curves.end = here;
    vehicle->marks.Add(time_s, here);
  } else {
    ++data_.num_impossible;
  }
  Draw(&curves.depth_m, time_s, nav.z_m);
  curves.dives = curves.dives || (IsFinite(nav.z_m) && std::abs(nav.z_m) > kDives_m);
  if (nav.altitude_m >= 0) {
    Draw(&curves.floor_m, time_s, nav.z_m + nav.altitude_m);
  } else {
    curves.floor_m.Break();
  }
  Draw(&curves.speed_mps, time_s, nav.speed_mps);
  Draw(&curves.heading_deg, time_s, nav.heading_deg);
  if (nav.pitch_deg != 0 || !curves.pitch_deg.empty()) {
    Draw(&curves.pitch_deg, time_s, nav.pitch_deg);
  }
  // Until it has half of the speed that it wants, or where it wants none, the current decides.
  const double least_mps = std::max(kDrifts_mps, 0.5 * vehicle->desired_speed_mps.value_or(0));
  const bool drives = vehicle->desired_speed_mps.value_or(1) > 0 && nav.speed_mps > least_mps;
  if (nav.speed_over_ground_mps > kNoCourse_mps && drives) {
    Draw(&curves.crab_deg, time_s,
         std::remainder(nav.course_over_ground_deg - nav.heading_deg, 360.0));
  } else {
    curves.crab_deg.Break();
  }
}

void PlotDataBuilder::AddHelmState(Vehicle* vehicle, const helm_state_t& state) {
  const auto time_s = TimeOf(state.utime);
  if (!time_s || !vehicle->is_selected) return;
  VehicleCurves& curves = vehicle->curves;
  if (!state.vehicle.empty() && UpperCase(state.vehicle) == UpperCase(curves.name)) {
    curves.name = state.vehicle;
  }
  const bool on_leg = state.state == "DRIVE" && state.waypoint_index >= 0;
  std::string leg = on_leg ? state.task + " " + std::to_string(state.waypoint_index) : "";
  if (leg != vehicle->leg) {
    curves.cross_track_m.Break();
    const CurvePoint point{state.waypoint_x_m, state.waypoint_y_m};
    if (on_leg && curves.steered_for.size() < kMaxWaypoints && IsFinite(point.x) &&
        IsFinite(point.y) &&
        std::find(curves.steered_for.begin(), curves.steered_for.end(), point) ==
            curves.steered_for.end()) {
      curves.steered_for.push_back(point);
    }
  }
  vehicle->leg = std::move(leg);
  if (on_leg) Draw(&curves.cross_track_m, *time_s, state.cross_track_error_m);
}

void PlotDataBuilder::AddActuators(Vehicle* vehicle, const actuators_t& actuators) {
  const auto time_s = TimeOf(actuators.utime);
  if (!time_s || !vehicle->is_selected) return;
  VehicleCurves& curves = vehicle->curves;
  Draw(&curves.thrust_pct, *time_s, actuators.thrust_pct);
  Draw(&curves.propeller_rpm, *time_s, actuators.propeller_rpm);
  Draw(&curves.rudder_deg, *time_s, actuators.rudder_deg);
  Draw(&curves.stern_plane_deg, *time_s, actuators.stern_plane_deg);
  curves.has_thrust = curves.has_thrust || actuators.thrust_pct != 0;
  curves.has_rpm = curves.has_rpm || actuators.propeller_rpm != 0;
  curves.has_stern = curves.has_stern || actuators.stern_plane_deg != 0;
}

void PlotDataBuilder::AddDesired(Vehicle* vehicle, const desired_t& desired) {
  const auto time_s = TimeOf(desired.utime);
  if (!time_s || !vehicle->is_selected) return;
  vehicle->desired_speed_mps = desired.speed_mps;
  Draw(&vehicle->curves.desired_speed_mps, *time_s, desired.speed_mps);
  Draw(&vehicle->curves.desired_heading_deg, *time_s, desired.heading_deg);
}

void PlotDataBuilder::AddNavigation(Vehicle* vehicle, const navigation_t& navigation) {
  if (!TimeOf(navigation.utime)) return;
  vehicle->navigation = navigation;
  DrawNavigation(vehicle);
}

/// Draws the last estimate once the truth of the same time is known.
void PlotDataBuilder::DrawNavigation(Vehicle* vehicle) {
  if (!vehicle->navigation || !vehicle->is_selected ||
      vehicle->nav_utime != vehicle->navigation->utime) {
    return;
  }
  const navigation_t navigation = *std::exchange(vehicle->navigation, std::nullopt);
  const double time_s = Seconds(navigation.utime - zero_utime_.value_or(0));
  VehicleCurves& curves = vehicle->curves;
  Draw(&curves.navigation_error_m, time_s,
       Hypot(navigation.x_m - vehicle->position_m.x(), navigation.y_m - vehicle->position_m.y()));
  Draw(&curves.navigation_bound_m, time_s, navigation.ellipse_major_m);
  Draw(&curves.believed_track, navigation.x_m, navigation.y_m);
}

void PlotDataBuilder::AddGuidance(Vehicle* vehicle, const guidance_t& guidance) {
  const auto time_s = TimeOf(guidance.utime);
  if (!time_s || !vehicle->is_selected) return;
  VehicleCurves& curves = vehicle->curves;
  Draw(&curves.desired_depth_m, *time_s, guidance.depth_m);
  Draw(&curves.desired_pitch_deg, *time_s, guidance.pitch_deg);
  if (guidance.waypoint_index >= 0) {
    Draw(&curves.expected_crab_deg, *time_s, guidance.crab_deg);
  } else {
    curves.expected_crab_deg.Break();
  }
  for (size_t i = 0; i < kPlottedLayers.size(); ++i) {
    const auto found = std::find_if(
        guidance.layers.begin(), guidance.layers.end(),
        [&](const guidance_layer_t& layer) { return layer.name == kPlottedLayers.at(i); });
    LayerCurves& layer = curves.layers.at(i);
    if (found == guidance.layers.end() || !(guidance.u_max_mps > 0)) {
      layer.weight.Break();
      layer.asks.Break();
      continue;
    }
    Draw(&layer.weight, *time_s, found->weight);
    Draw(&layer.asks, *time_s, std::min(1.0, found->speed_mps / guidance.u_max_mps));
  }
}

void PlotDataBuilder::AddSwarm(Vehicle* vehicle, const swarm_t& swarm) {
  const auto time_s = TimeOf(swarm.utime);
  if (!time_s || !vehicle->is_selected) return;
  std::optional<int64_t> target_utime, other_utime;
  for (const swarm_contact_t& contact : swarm.contacts) {
    if (!contact.is_heard || !contact.is_known) continue;
    if (contact.report_utime < -kLatest_us || contact.report_utime > kLatest_us) {
      ++data_.num_impossible;
      continue;
    }
    std::optional<int64_t>& oldest = contact.is_target ? target_utime : other_utime;
    oldest = std::min(oldest.value_or(contact.report_utime), contact.report_utime);
  }
  DrawAge(*time_s, swarm.utime, target_utime, &vehicle->target_report_utime,
          &vehicle->curves.target_age_s);
  DrawAge(*time_s, swarm.utime, other_utime, &vehicle->other_report_utime,
          &vehicle->curves.other_age_s);
}

/// A newer report makes the age fall: the line goes down at once, as the tooth of a saw.
void PlotDataBuilder::DrawAge(double time_s, int64_t utime, std::optional<int64_t> report_utime,
                              std::optional<int64_t>* before, ThinnedCurve* curve) {
  const auto draw = [&](int64_t of_utime) {
    Draw(curve, time_s, std::max(0.0, Seconds(utime - of_utime)));
  };
  if (!report_utime) curve->Break();
  if (report_utime && *before && *before != report_utime) draw(**before);
  if (report_utime) draw(*report_utime);
  *before = report_utime;
}

void PlotDataBuilder::TakeReport(const node_report_t& report) {
  const auto found = vehicles_.find(UpperCase(report.name));
  if (found == vehicles_.end()) return;
  found->second.curves.name = report.name;
  found->second.curves.color = report.color;
}

/// After all NAV of one time: how far from one another they are.
void PlotDataBuilder::MeasureDistances() {
  const auto time_s = TimeOf(round_utime_);
  if (!time_s) return;
  std::vector<Vehicle*> here;
  std::vector<Eigen::Vector3d> positions_m;
  const auto is_fresh = [&](const Vehicle& vehicle) {
    return vehicle.nav_utime && std::abs(round_utime_ - *vehicle.nav_utime) <= kStale_us;
  };
  for (auto& [name, vehicle] : vehicles_) {
    if (!is_fresh(vehicle)) continue;
    here.push_back(&vehicle);
    positions_m.push_back(vehicle.position_m);
  }
  const std::vector<double> nearest_m = NearestDistances_m(positions_m);
  for (size_t i = 0; i < here.size(); ++i) {
    Vehicle& vehicle = *here[i];
    if (!vehicle.is_selected || *vehicle.nav_utime != round_utime_) continue;
    if (std::isfinite(nearest_m[i])) Draw(&vehicle.curves.nearest_m, *time_s, nearest_m[i]);
    const auto target = vehicles_.find(vehicle.target);
    if (target == vehicles_.end() || !is_fresh(target->second)) continue;
    Draw(&vehicle.curves.target_m, *time_s,
         (vehicle.position_m - target->second.position_m).norm());
  }
}

void PlotDataBuilder::MarkCollisions() {
  for (const std::string& name : contacts_.EndOfStep()) {
    if (const auto vehicle = vehicles_.find(name); vehicle != vehicles_.end()) {
      Mark(vehicle->second, &data_.collisions);
    }
  }
}

void PlotDataBuilder::Mark(const Vehicle& vehicle, std::vector<CurvePoint>* marks) {
  if (!vehicle.is_selected || marks->size() == kMaxContacts) return;
  marks->push_back({vehicle.position_m.x(), vehicle.position_m.y()});
}

PlotData PlotDataBuilder::Build() {
  if (std::exchange(round_is_open_, false)) {
    MeasureDistances();
    MarkCollisions();
  }
  data_.zero_utime = zero_utime_.value_or(0);
  const int64_t end_utime = selection_.to_s
                                ? data_.zero_utime + std::min(round_utime_ - data_.zero_utime,
                                                              Microseconds(*selection_.to_s))
                                : round_utime_;
  for (const MapDrawing* drawing : drawings_.At(end_utime)) data_.drawings.push_back(*drawing);
  for (const auto& [name, vehicle] : vehicles_) {
    data_.mark_interval_s = std::max(data_.mark_interval_s, vehicle.marks.step_s());
  }
  for (auto& [name, vehicle] : vehicles_) {
    if (!vehicle.is_selected) continue;
    vehicle.curves.marks = vehicle.marks.MultiplesOf(data_.mark_interval_s);
    data_.vehicles.push_back(std::move(vehicle.curves));
  }
  return std::move(data_);
}

}  // namespace shoal
