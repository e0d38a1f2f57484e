#include "apps/vehicle_sim/other_vehicles.h"

#include "lib/vehicle/vehicle/contact.h"

namespace shoal {

OtherVehicles::OtherVehicles(const Mission& mission, const Vehicle& own) {
  for (const Vehicle& vehicle : mission.vehicles) {
    if (vehicle.name == own.name) continue;
    names_.push_back(vehicle.name);
    lengths_m_.push_back(vehicle.length_m);
  }
  places_in_targets_.assign(names_.size(), kUnknown);
}

void OtherVehicles::OnNav(size_t place, const nav_t& nav) {
  const Eigen::Vector3d position_m(nav.x_m, nav.y_m, nav.z_m);
  if (!position_m.allFinite()) return;
  size_t& target = places_in_targets_[place];
  if (target == kUnknown) {
    target = targets_.size();
    known_.push_back(place);
    targets_.push_back({.position_m = position_m, .radius_m = lengths_m_[place]});
  }
  targets_[target].position_m = position_m;
}

std::string OtherVehicles::Touching(const Eigen::Vector3d& position_m, double length_m) const {
  for (size_t i = 0; i < targets_.size(); ++i) {
    if (InContact(position_m, length_m, targets_[i].position_m, targets_[i].radius_m)) {
      return names_[known_[i]];
    }
  }
  return "";
}

}  // namespace shoal
