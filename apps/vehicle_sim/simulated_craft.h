// A vehicle model as vehicle_sim runs it: commanded by ACTUATORS, published as NAV. One class per
// model; CONTRIBUTING.md has the recipe for a new one.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>

#include "lib/mission/model/mission.h"
#include "shoal/actuators_t.hpp"
#include "shoal/nav_t.hpp"

namespace shoal {

/// The sea around one vehicle at one time.
struct Water {
  double time_s = 0;                                       ///< Since the mission's start.
  Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();  ///< Over ground; x East, y North.
  std::optional<double> floor_z_m;                         ///< Absent: not known.
};

class SimulatedCraft {
 public:
  virtual ~SimulatedCraft() = default;

  /// Sets the pose; actuators at rest, velocity that of the water. What is replayed stays where its
  /// track has it.
  virtual void Reset(const StartPose& pose, const Water& water) = 0;

  /// Takes a command. Returns false, and changes nothing, where it holds NaN or infinity.
  virtual bool Execute(const actuators_t& actuators) = 0;
  /// All actuators to zero.
  virtual void Rest() = 0;

  /// Goes on by `dt_s` > 0. The water may differ from place to place but not within a step.
  virtual void Step(const Water& water, double dt_s) = 0;

  virtual Eigen::Vector3d position_m() const = 0;
  /// Fills in all but utime, latitude and longitude. `water` is that of the moment.
  virtual void Show(const Water& water, nav_t* nav) const = 0;
  /// Returns lines of a status page about the actuators, four blanks before each.
  virtual std::string ActuatorsText() const = 0;
};

/// @pre the mission was checked, and what it reads is still there
[[nodiscard]] std::unique_ptr<SimulatedCraft> MakeSimulatedCraft(const Mission& mission,
                                                                 const Vehicle& vehicle);

}  // namespace shoal
