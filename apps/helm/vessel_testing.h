// For tests: a helm on a MemoryBus together with a vessel that follows ACTUATORS, publishes NAV,
// with the delays of a mission (one step from NAV to helm, one from ACTUATORS to vessel).
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/helm/helm_app.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/vehicle/vehicle/surface_craft.h"

namespace shoal {

inline Vehicle TestVehicle() {
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.return_task.point_m = {0, -20};
  vehicle.tasks = {
      {.name = "survey", .what = WaypointsTask{.points_m = {{0, 100}, {80, 100}, {80, 0}}}},
      {.name = "circle", .what = LoiterTask{.center_m = {0, 0}, .duration_s = 60}}};
  return vehicle;
}

class HelmAndVessel {
 public:
  explicit HelmAndVessel(const Vehicle& vehicle, int64_t tick_us = 100'000)
      : vehicle_(vehicle),
        tick_us_(tick_us),
        helm_bus_(hub_.Join("helm_alpha")),
        test_bus_(hub_.Join("test")),
        helm_(Mission{}, vehicle, helm_bus_) {
    Subscribe(test_bus_, channels::Actuators("alpha"),
              [this](const actuators_t& message) { actuators = message; });
    Subscribe(test_bus_, channels::Desired("alpha"),
              [this](const desired_t& message) { desired = message; });
    Subscribe(test_bus_, channels::HelmDecision("alpha"),
              [this](const helm_decision_t& message) { decisions.push_back(message); });
    Subscribe(test_bus_, channels::NodeMessageLocal(),
              [this](const node_message_t& message) { messages.push_back(message); });
    Subscribe(test_bus_, channels::HelmState("alpha"), [this](const helm_state_t& message) {
      state = message;
      states.push_back(message);
    });
  }

  void Command(const std::string& command, const std::vector<double>& values = {},
               const std::string& argument = {}) {
    helm_command_t message;
    message.utime = utime;
    message.command = command;
    message.argument = argument;
    message.num_values = static_cast<int32_t>(values.size());
    message.values = values;
    Publish(test_bus_, channels::HelmCommand("alpha"), message);
  }

  void PublishMessage(const node_message_t& message) {
    Publish(test_bus_, channels::NodeMessage("alpha"), message);
  }
  void PublishNav(const nav_t& nav) { Publish(test_bus_, channels::Nav("alpha"), nav); }
  void SayReport(const node_report_t& report) {
    Publish(test_bus_, channels::NodeReport("alpha"), report);
  }

  nav_t Nav() const {
    nav_t nav{};
    nav.utime = utime;
    nav.x_m = vessel.position_m.x();
    nav.y_m = vessel.position_m.y();
    nav.heading_deg = RadToDeg(vessel.heading_rad);
    nav.speed_mps = std::abs(vessel.speed_mps);
    nav.yaw_rate_degps = RadToDeg(vessel.yaw_rate_radps);
    return nav;
  }

  /// One step of mission time.
  void Step() {
    hub_.NextStep();
    hub_.HandleAll();
    helm_.Tick(utime);
    if (actuators) {
      vessel = shoal::Step(std::get<SurfaceCraftParams>(vehicle_.model), vessel,
                           {actuators->thrust_pct, actuators->rudder_deg}, current_mps,
                           Seconds(tick_us_));
    }
    if (publishes_nav) PublishNav(Nav());
    utime += tick_us_;
  }

  void Run(double duration_s) {
    const int64_t num_steps = std::llround(duration_s * 1e6 / static_cast<double>(tick_us_));
    for (int64_t i = 0; i < num_steps; ++i) Step();
  }

  StatusPage Page() const { return helm_.Status(); }
  /// The events of all decisions so far.
  std::vector<std::string> Events() const {
    std::vector<std::string> events;
    for (const helm_decision_t& decision : decisions) {
      events.insert(events.end(), decision.events.begin(), decision.events.end());
    }
    return events;
  }
  size_t NumWarnings() const { return Page().run_warnings.size(); }

  int64_t utime = 0;
  bool publishes_nav = true;
  Eigen::Vector2d current_mps = Eigen::Vector2d::Zero();
  SurfaceCraftState vessel = {};
  std::optional<actuators_t> actuators;
  std::optional<desired_t> desired;
  helm_state_t state{};
  std::vector<helm_state_t> states;
  std::vector<helm_decision_t> decisions;
  std::vector<node_message_t> messages;  ///< To other vehicles.

 private:
  Vehicle vehicle_;
  int64_t tick_us_;
  MemoryBus hub_;
  Bus& helm_bus_;
  Bus& test_bus_;
  HelmApp helm_;
};

}  // namespace shoal
