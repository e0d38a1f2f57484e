// The sets of gains that mission files know by name.
#pragma once

#include <optional>
#include <string_view>

#include "lib/vehicle/control/auv_pilot.h"

namespace shoal {

/// Returns the gains of Fossen's Python Vehicle Simulator, for fins of 15 degrees and 0.1 s. Depth
/// and pitch are its PI and PID. Its heading law (Fossen 2021, eq. 16.479) is an integral sliding
/// mode; within its boundary layer, and for a heading at rest, that is this PID:
///
///   kp = (T lambda^2 + 2 lambda (1 + k)) / K   ki = lambda^2 (1 + k) / K   kd = (2 lambda T + k) /
///   K
///
/// with k = K_d + K_sigma / phi_b, Nomoto's T and K. `kFossenHeaveGain` goes with it.
[[nodiscard]] AuvPilotParams FossenRemusPilot();

/// Radian of stern plane per m/s of sinking: Fossen's K_w, on top of his pitch PID.
inline constexpr double kFossenHeaveGain = 5;

/// Returns the set of that name: "default", "munet" or "fossen".
[[nodiscard]] std::optional<AuvPilotParams> RemusPilotByName(std::string_view name);

}  // namespace shoal
