// lib/vehicle/sensors/forward_looking_sonar as vehicle_sim runs it: pings at its rate, with angles
// in the body frame.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/mission/model/mission.h"
#include "lib/sea/ocean/sea_floor.h"
#include "lib/vehicle/sensors/forward_looking_sonar.h"
#include "shoal/nav_t.hpp"
#include "shoal/sonar_t.hpp"

namespace shoal {

class SonarUnit {
 public:
  SonarUnit(const SonarOptions& options, uint64_t seed, std::string_view vehicle);

  /// Returns what it sees from where `nav` has it, if it pings now: rate_hz times per second, once
  /// per step at most, the first time at once. Vehicles are where they were a step before.
  [[nodiscard]] std::optional<sonar_t> Ping(const nav_t& nav, const SonarScene& scene);

 private:
  ForwardLookingSonar sonar_;
  std::vector<SonarBeam> level_;  ///< The beams of a level hull that looks along psi = 0.
  std::vector<SonarBeam> beams_;
  std::optional<int64_t> last_ping_;  ///< Number of the period in which it was.
};

}  // namespace shoal
