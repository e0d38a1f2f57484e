// Simulates one vehicle. Subscribes to ACTUATORS_<V> and SIM_COMMAND_<V>, publishes NAV_<V> in
// every step, and what its instruments measure: MEASURED_NAV_<V>, SONAR_<V>, WATER_SAMPLE_<V>; with
// [vehicle.navigation] what it makes of them: ESTIMATED_NAV_<V>, NAVIGATION_<V>. Where packets can
// be ranges it subscribes to ACOUSTIC_RX_<V>.
// Where it has a sonar or can run into others it also subscribes to their NAV; where it has run
// into one it publishes HELM_COMMAND_<V>, an all-stop with that reason.
//
// Actuators are held until the next message; after kActuatorTimeout_us without one they go to zero.
// Step 0 shows the start pose; every later step integrates the time since the last.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "apps/vehicle_sim/nav_instruments.h"
#include "apps/vehicle_sim/navigation_unit.h"
#include "apps/vehicle_sim/other_vehicles.h"
#include "apps/vehicle_sim/simulated_craft.h"
#include "apps/vehicle_sim/sonar_unit.h"
#include "lib/base/geodesy/local_frame.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/file/ocean_of.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"
#include "lib/vehicle/vehicle/obstacle_watch.h"

namespace shoal {

class VehicleSimApp : public App {
 public:
  static constexpr int64_t kActuatorTimeout_us = 2'000'000;

  VehicleSimApp(const Mission& mission, const Vehicle& vehicle, Bus& bus);

  void Tick(int64_t utime) override;
  StatusPage Status() const override;

 private:
  void OnActuators(const actuators_t& actuators);
  void OnSimCommand(const sim_command_t& command);
  void Reset(const StartPose& pose);
  void Integrate(int64_t until_utime);
  /// Returns current and sea floor at the position of the vehicle.
  Water WaterAt(int64_t utime) const;
  void WatchActuators(int64_t utime);
  /// Stops for good, its helm too, where another vehicle touches it and the mission demands it.
  void WatchContact(int64_t utime);
  /// Stops a surface craft, its helm too, where the floor lies at its keel or above it.
  void WatchGround(int64_t utime);
  void StandStill(int64_t utime, const std::string& why);
  void WatchCurrentGrid(int64_t utime);
  void PublishNav(int64_t utime);
  void PublishInstruments(const nav_t& nav);
  bool is_still() const { return paused_ || !touched_by_.empty(); }

  // Members that every step needs come first: with thousands of vehicles in one process, the caches
  // have room for little more.
  const std::unique_ptr<SimulatedCraft> craft_;
  Bus& bus_;
  const int64_t tick_us_;
  const int64_t start_utime_;
  int64_t num_actuators_ = 0;
  std::optional<int64_t> utime_;            ///< Of the last step.
  std::optional<int64_t> actuators_utime_;  ///< When the last ACTUATORS came.
  const ContactRule contact_rule_;
  const bool has_instruments_;  ///< It publishes more than NAV.
  bool actuators_are_late_ = false;
  bool is_off_grid_ = false;  ///< Of the current.
  bool paused_ = false;
  Eigen::Vector2d drift_mps_ = Eigen::Vector2d::Zero();  ///< By SIM_COMMAND, on top of the current.
  std::string touched_by_;  ///< It ran into this vehicle, or "the ground", and stands still.
  const Channel<nav_t> nav_channel_;
  const Ocean ocean_;
  const LocalFrame frame_;

  const Vehicle vehicle_;
  const std::optional<NavInstruments> instruments_;
  std::optional<NavigationUnit> navigation_;
  std::optional<SonarUnit> sonar_;
  std::vector<Polygon> obstacles_m_;  ///< Of the mission, and their names.
  std::vector<std::string> obstacle_ids_;
  std::optional<OtherVehicles> others_;  ///< Absent: it has no sonar and runs into none.
  StatusLog log_;
  int64_t num_commands_ = 0;
  int64_t num_refused_ = 0;
};

}  // namespace shoal
