// The other vehicles of a mission, where their NAV had them a step before: what a sonar sees and
// what a vehicle can run into.
#pragma once

#include <Eigen/Core>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "lib/mission/mission.h"
#include "lib/sensors/forward_looking_sonar.h"
#include "shoal/nav_t.hpp"

namespace shoal {

class OtherVehicles {
 public:
  /// All vehicles of `mission` but `own`.
  OtherVehicles(const Mission& mission, const Vehicle& own);

  /// Returns the vehicles whose NAV it needs.
  const std::vector<std::string>& names() const { return names_; }

  /// Takes note of where one of them is. Positions that are not finite are passed over.
  void OnNav(const std::string& name, const nav_t& nav);

  /// Returns those whose NAV came, as a sonar sees them: spheres whose radius is the vehicle's
  /// length.
  std::span<const SonarTarget> targets() const { return targets_; }

  /// Returns the name of one that touches a vehicle of this length at `position_m`, as they were
  /// when their NAV last came; empty: none does.
  [[nodiscard]] std::string Touching(const Eigen::Vector3d& position_m, double length_m) const;

 private:
  std::vector<std::string> names_;
  std::map<std::string, double> lengths_m_;
  std::vector<std::string> known_;  ///< Names of targets_, in the same order.
  std::vector<SonarTarget> targets_;
};

}  // namespace shoal
