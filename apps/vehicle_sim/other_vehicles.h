// The other vehicles of a mission, where their NAV had them a step before: what a sonar sees and
// what a vehicle can run into.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/vehicle/sensors/forward_looking_sonar.h"
#include "shoal/nav_t.hpp"

namespace shoal {

class OtherVehicles {
 public:
  /// All vehicles of `mission` but `own`.
  OtherVehicles(const Mission& mission, const Vehicle& own);

  /// Returns the vehicles whose NAV it needs.
  const std::vector<std::string>& names() const { return names_; }

  /// Takes note of where one of them is, by its place in names(). Positions that are not finite are
  /// passed over.
  void OnNav(size_t place, const nav_t& nav);

  /// Returns those whose NAV came, as a sonar sees them: spheres whose radius is the vehicle's
  /// length.
  std::span<const SonarTarget> targets() const { return targets_; }

  /// Returns the name of one that touches a vehicle of this length at `position_m`, as they were
  /// when their NAV last came; empty: none does.
  [[nodiscard]] std::string Touching(const Eigen::Vector3d& position_m, double length_m) const;

 private:
  static constexpr size_t kUnknown = static_cast<size_t>(-1);

  std::vector<std::string> names_;
  std::vector<double> lengths_m_;          ///< By place in names_.
  std::vector<size_t> places_in_targets_;  ///< The same; kUnknown before the first NAV.
  std::vector<size_t> known_;              ///< Places in names_ of targets_, in the same order.
  std::vector<SonarTarget> targets_;
};

}  // namespace shoal
