// From what a task asks for to the actuators: the autopilots of one model of vehicle.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lib/mission/model/mission.h"
#include "lib/vehicle/guidance/task_runner.h"
#include "shoal/actuators_t.hpp"
#include "shoal/desired_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/sonar_t.hpp"

namespace shoal {

class Pilot {
 public:
  virtual ~Pilot() = default;

  /// Steers as `guidance` asks, `dt_s` after the last step; 0 in the first. Fills in all but utime.
  virtual void Steer(const Guidance& guidance, const nav_t& nav, double dt_s, desired_t* desired,
                     actuators_t* actuators) = 0;

  /// Takes note of what its sonar saw.
  virtual void OnSonar(const sonar_t& /*ping*/) {}

  /// Nothing is asked for: forgets the past, and gives actuators at rest.
  virtual void Rest(const nav_t& nav, desired_t* desired, actuators_t* actuators) = 0;

  /// Returns the pitch that it keeps, bow up; nothing of a vehicle that does not dive.
  virtual std::optional<double> desired_pitch_rad() const { return std::nullopt; }

  /// Returns a line for the status page.
  virtual std::string GainsText() const = 0;
};

[[nodiscard]] std::unique_ptr<Pilot> MakePilot(const Mission& mission, const Vehicle& vehicle);

}  // namespace shoal
