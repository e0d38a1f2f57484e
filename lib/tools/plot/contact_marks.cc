#include "lib/tools/plot/contact_marks.h"

#include <algorithm>

#include "lib/base/text/letters.h"

namespace shoal {

namespace {

std::vector<double> LengthsOf(const std::vector<PlannedVehicle>& vehicles) {
  std::vector<double> lengths_m;
  lengths_m.reserve(vehicles.size());
  for (const PlannedVehicle& vehicle : vehicles) lengths_m.push_back(vehicle.length_m);
  return lengths_m;
}

}  // namespace

ContactMarks::ContactMarks(const std::vector<PlannedVehicle>& vehicles)
    : positions_m_(vehicles.size(), Eigen::Vector3d::Zero()),
      collisions_(LengthsOf(vehicles)),
      groundings_(vehicles.size()) {
  for (const PlannedVehicle& vehicle : vehicles) {
    numbers_.emplace(UpperCase(vehicle.name), static_cast<uint32_t>(names_.size()));
    names_.push_back(UpperCase(vehicle.name));
    draughts_m_.push_back(vehicle.draught_m);
  }
}

bool ContactMarks::Move(std::string_view name, const Eigen::Vector3d& position_m,
                        double altitude_m) {
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) return false;
  const uint32_t number = found->second;
  positions_m_[number] = position_m;
  moved_.push_back(number);
  const std::optional<double> draught_m = draughts_m_[number];
  return draught_m && altitude_m >= 0 && groundings_.Look(number, altitude_m - *draught_m);
}

std::vector<std::string> ContactMarks::EndOfStep() {
  std::ranges::sort(moved_);
  moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
  std::vector<std::string> names;
  for (const Collision& collision : collisions_.Look(moved_, positions_m_)) {
    names.push_back(names_[collision.first]);
  }
  moved_.clear();
  return names;
}

}  // namespace shoal
