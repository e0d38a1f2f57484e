// Propeller forces, and which speed goes with which number of revolutions.
#pragma once

#include "lib/vehicle/vehicle/remus100_params.h"

namespace shoal {

struct PropellerForce {
  double thrust_n = 0;   ///< Without thrust deduction.
  double torque_nm = 0;  ///< On the shaft, in the sense of roll.
};

/// Returns what the propeller does at `rpm` in water that comes with `speed_mps` from ahead. Ahead,
/// the coefficients fall linearly with the advance ratio (Allen, Vorus and Prestero 2000); astern
/// and in water from behind they are those at rest. Continuous in both arguments.
[[nodiscard]] PropellerForce ForceOf(const Propeller& propeller, double density_kgpm3, double rpm,
                                     double speed_mps);

/// Returns the revolutions at which thrust and drag balance at `speed_mps` through water,
/// straight on, on an even keel; negative astern. Not limited to what the propeller can do: see
/// Propeller::max_rpm. Continuous and strictly increasing. @pre speed_mps finite
[[nodiscard]] double RpmForSpeed(const Remus100& auv, double speed_mps);

/// Returns the steady speed through water at `rpm`, limited to what the propeller can do; the
/// inverse of RpmForSpeed. @pre rpm finite
[[nodiscard]] double SteadySpeed(const Remus100& auv, double rpm);

/// Returns by how much SteadySpeed grows per rpm: the mean over one rpm to either side, within what
/// the propeller can do. @pre rpm finite
[[nodiscard]] double SteadySpeedSlope(const Remus100& auv, double rpm);

/// Returns muNet's speed for `rpm`: three straight lines that do not quite meet, at 100 rpm (a fall
/// of 0.4 mm/s) and at 400 rpm (of 0.8 mm/s); a border belongs to the line below it. To be used
/// with the set `munet` where its results are to be had; otherwise use SteadySpeed. @pre rpm finite
[[nodiscard]] double MunetSpeedFromRpm(double rpm);

/// Returns the slope of MunetSpeedFromRpm. @pre rpm finite
[[nodiscard]] double MunetSpeedSlope(double rpm);

/// Returns muNet's revolutions for a speed: three straight lines that do not quite meet, at 0.0605
/// m/s (a rise of 1.0 rpm) and 0.6383 m/s (a fall of 0.4 rpm); a border belongs to the line below
/// it. Not the exact inverse of MunetSpeedFromRpm, not limited. @pre speed_mps finite
[[nodiscard]] double MunetRpmFromSpeed(double speed_mps);

}  // namespace shoal
