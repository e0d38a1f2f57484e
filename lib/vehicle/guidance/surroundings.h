// What a vehicle knows of the world when it decides on a velocity: the input of all velocity laws.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace shoal {

/// Another vehicle, as it is known now: predicted from its last report, or the truth.
struct Neighbour {
  int id = 0;  ///< Unique in a mission: decides which vehicle goes where when two coincide.
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< x East, y North, z down.
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
  bool is_silent = false;  ///< No report for so long that the rest is a guess.
};

/// What one beam of a forward-looking sonar sees.
struct SonarEcho {
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< Unit vector, world axes.
  double range_m = 0;                                    ///< >= 0.
};

/// Everything is finite unless stated otherwise. The spans must outlive the call they are given to.
struct Surroundings {
  Neighbour own = {};
  std::optional<Neighbour> target = {};   ///< The vehicle that it follows; none: nothing known.
  bool target_is_silent = false;          ///< No report for long; `target` is a guess, or nothing.
  std::span<const Neighbour> group = {};  ///< The others, without the target and itself.
  std::span<const SonarEcho> sonar = {};
  Eigen::Vector3d current_mps = Eigen::Vector3d::Zero();  ///< Of the water, over ground.
  double seabed_z_m = 6000;  ///< Depth of the sea floor below; deep or +infinity: not sensed.
};

}  // namespace shoal
