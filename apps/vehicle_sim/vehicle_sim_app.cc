#include "apps/vehicle_sim/vehicle_sim_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/geometry/angles.h"

namespace shoal {

namespace {

constexpr char kLateActuators[] = "no ACTUATORS for 2 s: thrust and rudder are zero";
/// Beyond this a pose or a drift is a slip of the keyboard.
constexpr double kMaxPosition_m = 1e6;
constexpr double kMaxDrift_mps = 100;

bool AllFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

Eigen::Vector2d CurrentOf(const Environment& environment) {
  return environment.current_speed_mps * UnitVector(DegToRad(environment.current_direction_deg));
}

}  // namespace

VehicleSimApp::VehicleSimApp(const Mission& mission, const Vehicle& vehicle, Bus& bus)
    : vehicle_(vehicle),
      tick_us_(mission.tick_us),
      frame_({.lat_deg = mission.origin_lat_deg, .lon_deg = mission.origin_lon_deg}),
      current_mps_(CurrentOf(mission.environment)),
      nav_channel_(channels::Nav(vehicle.name)),
      bus_(bus) {
  Reset(vehicle.start);
  Subscribe(bus, channels::Actuators(vehicle.name),
            [this](const actuators_t& actuators) { OnActuators(actuators); });
  Subscribe(bus, channels::SimCommand(vehicle.name),
            [this](const sim_command_t& command) { OnSimCommand(command); });
}

void VehicleSimApp::Reset(const StartPose& pose) {
  state_ = SurfaceCraftState{};
  state_.position_m = {pose.x_m, pose.y_m};
  state_.heading_rad = WrapTwoPi(DegToRad(pose.heading_deg));
  state_.speed_mps = pose.speed_mps;
  state_.velocity_over_ground_mps =
      pose.speed_mps * UnitVector(state_.heading_rad) + current_mps_ + drift_mps_;
}

void VehicleSimApp::OnActuators(const actuators_t& actuators) {
  ++num_actuators_;
  if (!std::isfinite(actuators.thrust_pct) || !std::isfinite(actuators.rudder_deg)) {
    log_.Warn("ACTUATORS with NaN or infinity refused");
    return;
  }
  command_ = {.thrust_pct = actuators.thrust_pct, .rudder_deg = actuators.rudder_deg};
  actuators_utime_ = utime_.value_or(0) + (utime_ ? tick_us_ : 0);
}

void VehicleSimApp::OnSimCommand(const sim_command_t& command) {
  ++num_commands_;
  const int64_t utime = utime_.value_or(0);
  const std::vector<double>& values = command.values;
  const bool finite = AllFinite(values);
  if (command.command == "pause" && values.empty()) {
    paused_ = true;
  } else if (command.command == "resume" && values.empty()) {
    paused_ = false;
  } else if (command.command == "reset" && values.empty()) {
    Reset(vehicle_.start);
  } else if (command.command == "reset" && values.size() == 4 && finite &&
             std::max(std::abs(values[0]), std::abs(values[1])) <= kMaxPosition_m &&
             std::abs(values[3]) <= kMaxDrift_mps) {
    Reset({.x_m = values[0], .y_m = values[1], .heading_deg = values[2], .speed_mps = values[3]});
  } else if (command.command == "drift" && values.size() == 2 && finite &&
             std::max(std::abs(values[0]), std::abs(values[1])) <= kMaxDrift_mps) {
    drift_mps_ = {values[0], values[1]};
  } else {
    ++num_refused_;
    log_.Warn(fmt::format("SIM_COMMAND refused: '{}' with {} values; see sim_command_t",
                          Printable(command.command), values.size()));
    return;
  }
  log_.Event(utime, fmt::format("{} {}", command.command, fmt::join(values, " ")));
}

void VehicleSimApp::Tick(int64_t utime) {
  WatchActuators(utime);
  if (utime_ && !paused_) Integrate(utime);
  if (!utime_ && !actuators_utime_) actuators_utime_ = utime;
  utime_ = utime;
  PublishNav(utime);
}

void VehicleSimApp::WatchActuators(int64_t utime) {
  const bool late = actuators_utime_ && utime - *actuators_utime_ > kActuatorTimeout_us;
  if (late && !actuators_are_late_) {
    command_ = {};
    log_.Warn(kLateActuators);
    log_.Event(utime, kLateActuators);
  }
  if (!late && actuators_are_late_) log_.Retract(kLateActuators);
  actuators_are_late_ = late;
}

void VehicleSimApp::Integrate(int64_t until_utime) {
  // One step at a time, also where ticks were missed: the result must not depend on the gap.
  for (int64_t now = *utime_; now < until_utime;) {
    const int64_t step_us = std::min(tick_us_, until_utime - now);
    state_ = Step(vehicle_.surface_craft, state_, command_, current_mps_ + drift_mps_,
                  static_cast<double>(step_us) / 1e6);
    now += step_us;
  }
}

void VehicleSimApp::PublishNav(int64_t utime) {
  const GeoPoint geo = frame_.ToGeo(state_.position_m);
  const Eigen::Vector2d over_ground =
      paused_ ? Eigen::Vector2d::Zero() : state_.velocity_over_ground_mps;
  nav_t nav{};
  nav.utime = utime;
  nav.x_m = state_.position_m.x();
  nav.y_m = state_.position_m.y();
  nav.lat_deg = geo.lat_deg;
  nav.lon_deg = geo.lon_deg;
  nav.heading_deg = Wrap360(RadToDeg(state_.heading_rad));
  nav.surge_mps = paused_ ? 0 : state_.speed_mps;
  nav.yaw_rate_degps = paused_ ? 0 : RadToDeg(state_.yaw_rate_radps);
  nav.speed_mps = std::abs(nav.surge_mps);
  nav.speed_over_ground_mps = over_ground.norm();
  nav.course_over_ground_deg =
      over_ground.norm() > 0 ? Wrap360(RadToDeg(HeadingOf(over_ground))) : nav.heading_deg;
  nav.altitude_m = -1;
  Publish(bus_, nav_channel_, nav);
}

StatusPage VehicleSimApp::Status() const {
  StatusPage page;
  page.text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({})\n"
      "    Start: x {:.1f} m, y {:.1f} m, heading {:.1f} deg\n"
      "    Current: {:.2f} m/s East, {:.2f} m/s North\n"
      "State:{}\n"
      "    Position: x {:.2f} m, y {:.2f} m\n"
      "    Heading: {:.1f} deg, speed {:.2f} m/s through the water, {:.2f} m/s over ground\n"
      "    Thrust: {:.1f} %, rudder {:.1f} deg (asked for {:.1f})\n"
      "    Drift by command: {:.2f} m/s East, {:.2f} m/s North\n"
      "Heard:\n"
      "    ACTUATORS: {}\n"
      "    SIM_COMMAND: {} ({} refused)\n",
      vehicle_.name, vehicle_.model, vehicle_.start.x_m, vehicle_.start.y_m,
      vehicle_.start.heading_deg, current_mps_.x(), current_mps_.y(), paused_ ? " paused" : "",
      state_.position_m.x(), state_.position_m.y(), RadToDeg(state_.heading_rad), state_.speed_mps,
      state_.velocity_over_ground_mps.norm(), command_.thrust_pct, state_.rudder_deg,
      command_.rudder_deg, drift_mps_.x(), drift_mps_.y(), num_actuators_, num_commands_,
      num_refused_);
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
