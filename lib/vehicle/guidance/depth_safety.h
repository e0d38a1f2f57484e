// Keeps a commanded velocity from driving a vehicle into the sea floor, or out of the water.
#pragma once

#include <Eigen/Core>

namespace shoal {

struct DepthSafety {
  double z_max_m = 100;  ///< Greatest operating depth.
  double z_min_m = 0;    ///< Least operating depth: the surface.
  double z_safe_m = 5;   ///< Distance kept from z_max and the floor, in which braking grows; > 0.
  double climb_mps = 0;  ///< Upward at z_max or the floor, less in proportion before; 0: MuNet's.

  bool operator==(const DepthSafety&) const = default;
};

/// Returns `command_mps` with its vertical part limited. With z_s = min(z_max, seabed_z) - z_safe,
/// below z_s, and where command and own motion together go down:
///
///   g = min(1, (z - z_s) / z_safe)
///   v_z = command - g max(command, 0) - g max(own, 0)
///
/// and with a `climb_mps`, wherever it is below z_s, v_z <= -g climb_mps: braking alone would let a
/// level vehicle run into a floor that rises.
/// Above z_min the same upward, mirrored. In between nothing changes. The result may be longer than
/// the command by the own vertical speed, which it opposes. A floor so shallow that z_s lies above
/// z_min leaves the vehicle to the floor's rule.
/// MuNet's depthSafetyLimit as it is programmed (its text has another sign); the surface is ours.
/// @pre everything finite, but seabed_z_m may be +infinity: no floor known
[[nodiscard]] Eigen::Vector3d ApplyDepthSafety(const DepthSafety& limits, double seabed_z_m,
                                               double z_m, double own_vz_mps,
                                               const Eigen::Vector3d& command_mps);

}  // namespace shoal
