// The plain vessel of tests/golden/helm: it turns and changes its speed at fixed rates.
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/helm/colregs/encounter_geometry.h"

namespace shoal {

inline constexpr double kVesselStep_s = 0.05;

/// What a helm commands to a kinematic vessel.
struct KinematicCommand {
  double heading_deg = 0;
  double speed_mps = 0;
};

/// Returns the motion one step later: the heading moves toward the command by the shorter way, at
/// most 15 deg/s (to port, where both are equal), the speed at most 0.5 m/s2 either way; then the
/// vessel moves with both.
inline VesselMotion Step(VesselMotion motion, const KinematicCommand& command) {
  constexpr double kMaxTurn_deg = 15 * kVesselStep_s;
  constexpr double kMaxChange_mps = 0.5 * kVesselStep_s;
  const double turn_deg = -Wrap180(motion.heading_deg - command.heading_deg);
  motion.heading_deg =
      Wrap360(motion.heading_deg + std::clamp(turn_deg, -kMaxTurn_deg, kMaxTurn_deg));
  motion.speed_mps +=
      std::clamp(command.speed_mps - motion.speed_mps, -kMaxChange_mps, kMaxChange_mps);
  motion.position_m += motion.speed_mps * kVesselStep_s * UnitVector(DegToRad(motion.heading_deg));
  return motion;
}

}  // namespace shoal
