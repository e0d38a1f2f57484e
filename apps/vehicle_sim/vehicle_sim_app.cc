#include "apps/vehicle_sim/vehicle_sim_app.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"

namespace shoal {

namespace {

constexpr char kOffGrid[] =
    "off the grid of the current: the water here is taken to move as at the grid's nearest edge";
constexpr char kLateActuators[] = "no ACTUATORS for 2 s: thrust and rudder are zero";
/// A pose or a drift beyond this is refused as a typing error.
constexpr double kMaxPosition_m = 1e6;
constexpr double kMaxDepth_m = 20'000;
constexpr double kMaxDrift_mps = 100;

bool AllFinite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// True for x, y, heading and speed, and perhaps a depth.
bool IsPose(const std::vector<double>& values) {
  return (values.size() == 4 || values.size() == 5) &&
         std::max(std::abs(values[0]), std::abs(values[1])) <= kMaxPosition_m &&
         std::abs(values[3]) <= kMaxDrift_mps &&
         (values.size() == 4 || (values[4] >= 0 && values[4] <= kMaxDepth_m));
}

Ocean OceanOrDie(const Mission& mission) {
  Result<Ocean> ocean = OceanOf(mission);
  SHOAL_CHECK(ocean.ok(), "the mission file was checked, and its grid could be read");
  return std::move(*ocean);
}

std::optional<NavInstruments> InstrumentsOf(const Mission& mission, const Vehicle& vehicle) {
  if (!vehicle.sensors.is_fitted) return std::nullopt;
  return NavInstruments(vehicle.sensors, mission.seed, vehicle.name);
}

std::optional<SonarUnit> SonarOf(const Mission& mission, const Vehicle& vehicle) {
  if (!vehicle.sonar.is_fitted) return std::nullopt;
  return SonarUnit(vehicle.sonar, mission.seed, vehicle.name);
}

}  // namespace

VehicleSimApp::VehicleSimApp(const Mission& mission, const Vehicle& vehicle, Bus& bus)
    : craft_(MakeSimulatedCraft(mission, vehicle)),
      bus_(bus),
      tick_us_(mission.tick_us),
      start_utime_(mission.start_utime),
      contact_rule_(mission.environment.contact),
      has_instruments_(vehicle.sensors.is_fitted || vehicle.navigation.is_fitted ||
                       vehicle.sonar.is_fitted || mission.environment.plume.exists),
      nav_channel_(channels::Nav(vehicle.name)),
      ocean_(OceanOrDie(mission)),
      frame_({.lat_deg = mission.origin_lat_deg, .lon_deg = mission.origin_lon_deg}),
      vehicle_(vehicle),
      instruments_(InstrumentsOf(mission, vehicle)),
      sonar_(SonarOf(mission, vehicle)) {
  if (vehicle.navigation.is_fitted) navigation_.emplace(mission, vehicle);
  Reset(vehicle.start);
  Subscribe(bus, channels::Actuators(vehicle.name),
            [this](const actuators_t& actuators) { OnActuators(actuators); });
  Subscribe(bus, channels::SimCommand(vehicle.name),
            [this](const sim_command_t& command) { OnSimCommand(command); });
  if (navigation_ && navigation_->takes_packets()) {
    Subscribe(bus, channels::AcousticRx(vehicle.name),
              [this](const acoustic_rx_t& packet) { navigation_->TakePacket(packet); });
  }
  if (!sonar_ && contact_rule_ == ContactRule::kIgnore) return;
  others_.emplace(mission, vehicle);
  for (const Obstacle& obstacle : mission.obstacles) {
    obstacles_m_.push_back(obstacle.polygon_m);
    obstacle_ids_.push_back(obstacle.id);
  }
  for (size_t i = 0; i < others_->names().size(); ++i) {
    Subscribe(bus, channels::Nav(others_->names()[i]),
              [this, i](const nav_t& nav) { others_->OnNav(i, nav); });
  }
}

void VehicleSimApp::Reset(const StartPose& pose) {
  // The water at the new place is asked for once the vehicle is there.
  craft_->Reset(pose, {});
  craft_->Reset(pose, WaterAt(utime_.value_or(start_utime_)));
  if (navigation_ && utime_) navigation_->Start(pose);
  touched_by_.clear();
}

Water VehicleSimApp::WaterAt(int64_t utime) const {
  const double time_s = Seconds(utime - start_utime_);
  Water water = {.time_s = time_s,
                 .velocity_mps = ocean_.WaterVelocityAt(craft_->position_m(), time_s) + drift_mps_,
                 .floor_z_m = std::nullopt};
  if (ocean_.floor) water.floor_z_m = ocean_.floor->DepthAt(craft_->position_m().head<2>());
  return water;
}

void VehicleSimApp::OnActuators(const actuators_t& actuators) {
  ++num_actuators_;
  if (!craft_->Execute(actuators)) {
    log_.Warn("ACTUATORS with NaN or infinity refused");
    return;
  }
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
  } else if (command.command == "reset" && finite && IsPose(values)) {
    Reset({.x_m = values[0],
           .y_m = values[1],
           .heading_deg = values[2],
           .speed_mps = values[3],
           .depth_m = values.size() > 4 ? values[4] : 0});
  } else if (command.command == "drift" && values.size() == 2 && finite &&
             std::max(std::abs(values[0]), std::abs(values[1])) <= kMaxDrift_mps) {
    drift_mps_ = {values[0], values[1]};
  } else {
    ++num_refused_;
    const std::string text =
        fmt::format("SIM_COMMAND refused: '{}' with {} values; see sim_command_t",
                    Printable(command.command), values.size());
    log_.Warn(text);
    log_.Event(utime, text);
    return;
  }
  log_.Event(utime, fmt::format("{} {}", command.command, fmt::join(values, " ")));
}

void VehicleSimApp::Tick(int64_t utime) {
  WatchActuators(utime);
  WatchContact(utime);
  WatchGround(utime);
  WatchCurrentGrid(utime);
  if (utime_ && !is_still()) Integrate(utime);
  if (!utime_ && !actuators_utime_) actuators_utime_ = utime;
  utime_ = utime;
  PublishNav(utime);
}

void VehicleSimApp::WatchActuators(int64_t utime) {
  const bool late = actuators_utime_ && utime - *actuators_utime_ > kActuatorTimeout_us;
  if (late && !actuators_are_late_) {
    craft_->Rest();
    log_.Warn(kLateActuators);
    log_.Event(utime, kLateActuators);
  }
  if (!late && actuators_are_late_) log_.Retract(kLateActuators);
  actuators_are_late_ = late;
}

void VehicleSimApp::WatchContact(int64_t utime) {
  if (contact_rule_ == ContactRule::kIgnore || !touched_by_.empty()) return;
  // Both are looked at where they were in the step before, so that both see the same distance.
  touched_by_ = others_->Touching(craft_->position_m(), vehicle_.length_m);
  const int obstacle =
      TouchedObstacle(obstacles_m_, craft_->position_m().head<2>(), vehicle_.length_m);
  if (touched_by_.empty() && obstacle >= 0) {
    touched_by_ = "obstacle " + obstacle_ids_.at(static_cast<size_t>(obstacle));
  }
  if (!touched_by_.empty()) StandStill(utime, "collision with " + touched_by_);
}

void VehicleSimApp::WatchGround(int64_t utime) {
  if (!ocean_.floor || !touched_by_.empty()) return;
  if (!std::holds_alternative<SurfaceCraftParams>(vehicle_.model)) return;
  if (ocean_.floor->DepthAt(craft_->position_m().head<2>()) > vehicle_.draught_m) return;
  touched_by_ = "the ground";
  StandStill(utime, "aground");
}

void VehicleSimApp::StandStill(int64_t utime, const std::string& why) {
  const std::string text = "ran into " + touched_by_ + ": it moves no more";
  log_.Warn(text);
  log_.Event(utime, text);
  helm_command_t stop{};
  stop.utime = utime;
  stop.command = "all_stop";
  stop.argument = why;
  Publish(bus_, channels::HelmCommand(vehicle_.name), stop);
}

void VehicleSimApp::WatchCurrentGrid(int64_t utime) {
  if (!ocean_.current_grid) return;
  const bool is_off = !ocean_.current_grid->IsInside(craft_->position_m().head<2>());
  if (is_off && !is_off_grid_) {
    log_.Warn(kOffGrid);
    log_.Event(utime, kOffGrid);
  }
  if (!is_off && is_off_grid_) log_.Retract(kOffGrid);
  is_off_grid_ = is_off;
}

void VehicleSimApp::Integrate(int64_t until_utime) {
  // One step at a time, also where ticks were missed: the result must not depend on the gap.
  for (int64_t now = *utime_; now < until_utime;) {
    const int64_t step_us = std::min(tick_us_, until_utime - now);
    craft_->Step(WaterAt(now), Seconds(step_us));
    now += step_us;
  }
}

void VehicleSimApp::PublishNav(int64_t utime) {
  nav_t nav{};
  craft_->Show(WaterAt(utime), &nav);
  const GeoPoint geo = frame_.ToGeo({nav.x_m, nav.y_m});
  nav.utime = utime;
  nav.lat_deg = geo.lat_deg;
  nav.lon_deg = geo.lon_deg;
  if (is_still()) {
    for (double* motion : {&nav.surge_mps, &nav.sway_mps, &nav.heave_mps, &nav.roll_rate_degps,
                           &nav.pitch_rate_degps, &nav.yaw_rate_degps, &nav.speed_mps,
                           &nav.speed_over_ground_mps, &nav.descent_mps}) {
      *motion = 0;
    }
    nav.course_over_ground_deg = nav.heading_deg;
  }
  Publish(bus_, nav_channel_, nav);
  if (has_instruments_) PublishInstruments(nav);
}

void VehicleSimApp::PublishInstruments(const nav_t& nav) {
  if (instruments_) {
    Publish(bus_, channels::MeasuredNav(vehicle_.name), instruments_->Measure(nav, frame_));
  }
  if (navigation_) {
    const nav_t estimate = navigation_->Estimate(nav, WaterAt(nav.utime).velocity_mps, frame_);
    Publish(bus_, channels::EstimatedNav(vehicle_.name), estimate);
    const std::optional<navigation_t> report = navigation_->Report(nav.utime);
    if (report) Publish(bus_, channels::Navigation(vehicle_.name), *report);
  }
  if (sonar_) {
    static const SeaFloor kDeep;
    const auto ping = sonar_->Ping(nav, {.floor = ocean_.floor ? *ocean_.floor : kDeep,
                                         .vehicles = others_->targets(),
                                         .walls_m = obstacles_m_});
    if (ping) Publish(bus_, channels::Sonar(vehicle_.name), *ping);
  }
  if (ocean_.plume) {
    water_sample_t sample{};
    sample.utime = nav.utime;
    sample.concentration_gpm3 = Concentration(*ocean_.plume, {nav.x_m, nav.y_m, nav.z_m});
    Publish(bus_, channels::WaterSample(vehicle_.name), sample);
  }
}

StatusPage VehicleSimApp::Status() const {
  const Water water = WaterAt(utime_.value_or(start_utime_));
  nav_t nav{};
  craft_->Show(water, &nav);
  StatusPage page;
  page.text = fmt::format(
      "Configuration:\n"
      "    Vehicle: {} ({})\n"
      "    Start: x {:.1f} m, y {:.1f} m, depth {:.1f} m, heading {:.1f} deg\n"
      "State:{}\n"
      "    Position: x {:.2f} m, y {:.2f} m, depth {:.2f} m{}\n"
      "    Heading: {:.1f} deg, speed {:.2f} m/s relative to the water, {:.2f} m/s over ground\n"
      "{}{}"
      "    Water: {:.2f} m/s East, {:.2f} m/s North, of it by command {:.2f} and {:.2f}\n"
      "Received:\n"
      "    ACTUATORS: {}\n"
      "    SIM_COMMAND: {} ({} refused)\n",
      vehicle_.name, FactsOfModel(vehicle_.model).name, vehicle_.start.x_m, vehicle_.start.y_m,
      vehicle_.start.depth_m, vehicle_.start.heading_deg,
      !touched_by_.empty() ? " stopped, ran into " + touched_by_
      : paused_            ? " paused"
                           : "",
      nav.x_m, nav.y_m, nav.z_m,
      water.floor_z_m ? fmt::format(", {:.1f} m above the floor", nav.altitude_m) : "",
      nav.heading_deg, nav.speed_mps, nav.speed_over_ground_mps, craft_->ActuatorsText(),
      navigation_ ? navigation_->StatusText() : "", water.velocity_mps.x(), water.velocity_mps.y(),
      drift_mps_.x(), drift_mps_.y(), num_actuators_, num_commands_, num_refused_);
  log_.AppendTo(&page);
  return page;
}

}  // namespace shoal
