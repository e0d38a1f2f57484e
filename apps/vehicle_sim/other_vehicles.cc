#include "apps/vehicle_sim/other_vehicles.h"

#include <algorithm>

#include "lib/vehicle/contact.h"

namespace shoal {

OtherVehicles::OtherVehicles(const Mission& mission, const Vehicle& own) {
  for (const Vehicle& vehicle : mission.vehicles) {
    if (vehicle.name == own.name) continue;
    names_.push_back(vehicle.name);
    lengths_m_[vehicle.name] = vehicle.length_m;
  }
}

void OtherVehicles::OnNav(const std::string& name, const nav_t& nav) {
  const Eigen::Vector3d position_m(nav.x_m, nav.y_m, nav.z_m);
  const auto length_m = lengths_m_.find(name);
  if (length_m == lengths_m_.end() || !position_m.allFinite()) return;
  const auto found = std::find(known_.begin(), known_.end(), name);
  if (found != known_.end()) {
    targets_[static_cast<size_t>(found - known_.begin())].position_m = position_m;
    return;
  }
  known_.push_back(name);
  targets_.push_back({.position_m = position_m, .radius_m = length_m->second});
}

std::string OtherVehicles::Touching(const Eigen::Vector3d& position_m, double length_m) const {
  for (size_t i = 0; i < targets_.size(); ++i) {
    if (InContact(position_m, length_m, targets_[i].position_m, targets_[i].radius_m)) {
      return known_[i];
    }
  }
  return "";
}

}  // namespace shoal
