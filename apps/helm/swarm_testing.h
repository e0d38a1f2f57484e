// A swarm for tests of what a helm knows of it.
#pragma once

#include <string>
#include <vector>

#include "apps/helm/swarm_view.h"

namespace shoal {

inline Task Following(const std::string& target, const std::vector<std::string>& group = {}) {
  TargetTrackTask track;
  track.target = target;
  track.group = group;
  return {.name = "follow_" + target, .what = track};
}

inline Vehicle VehicleNamed(const std::string& name, const std::vector<Task>& tasks = {}) {
  Vehicle vehicle;
  vehicle.name = name;
  vehicle.tasks = tasks;
  return vehicle;
}

/// alpha leads bravo, charlie and delta; echo is not in the swarm.
inline Mission Swarm() {
  Mission mission;
  mission.vehicles = {VehicleNamed("alpha"), VehicleNamed("bravo", {Following("alpha")}),
                      VehicleNamed("charlie", {Following("alpha")}),
                      VehicleNamed("delta", {Following("alpha")}), VehicleNamed("echo")};
  return mission;
}

inline nav_t At(double x_m, double y_m, double z_m = 20) {
  nav_t nav{};
  nav.x_m = x_m;
  nav.y_m = y_m;
  nav.z_m = z_m;
  nav.altitude_m = -1;
  return nav;
}

/// Gives `swarm` a NAV, where it subscribes to that vehicle's.
inline void TakeNav(SwarmView* swarm, const std::string& name, const nav_t& nav) {
  for (size_t i = 0; i < swarm->names().size(); ++i) {
    if (swarm->names()[i] == name) swarm->OnNav(i, NavNeighbour(nav));
  }
}

}  // namespace shoal
