#include "sim/kept_controls.h"

#include "lib/bus/bus/control_message.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

bool KeptControls::Keep(const ControlRow& row, const unc_control_t& control) {
  if (row.type == ControlType::kRequest || !IsPossible(row, ValueOf(control))) return true;
  if (row.of_vehicle ? !IsLegalVehicleName(control.vehicle) : !control.vehicle.empty()) return true;
  const auto key = std::pair(std::string(row.channel), VehicleKey(control.vehicle));
  if (const auto found = kept_.find(key); found != kept_.end()) {
    found->second = control;
    return true;
  }
  if (kept_.size() == kMax) return false;
  kept_.emplace(key, control);
  return true;
}

unc_controls_t KeptControls::All() const {
  unc_controls_t all;
  all.utime = 0;
  for (const auto& [key, control] : kept_) {
    all.controls.push_back({.channel = key.first, .control = control});
  }
  all.num_controls = static_cast<int32_t>(all.controls.size());
  return all;
}

}  // namespace shoal
