// Currents by name: "moderate" speed, "choppy" periods, a "stormy" ocean. A zone is a range from
// which a number is drawn once, when a mission starts. The names and numbers are MuNet's.
#pragma once

#include <span>
#include <string_view>

#include "lib/geometry/angles.h"
#include "lib/ocean/current.h"
#include "lib/random/stream.h"

namespace shoal {

/// low <= high; equal ones are a number. Directions: psi in radians, high at most low + 2 pi.
struct Range {
  double low = 0;
  double high = 0;
};

struct Zone {
  std::string_view name;
  Range range = {};
};

/// dead, typical, moderate, swift, fast, any.
[[nodiscard]] std::span<const Zone> CurrentSpeedZones();
/// constant, steady, varied, unsteady, any; m/s.
[[nodiscard]] std::span<const Zone> CurrentSpeedDeviationZones();
/// east, northeast and so on, toward which the water flows, each 45 degrees wide; any.
[[nodiscard]] std::span<const Zone> CurrentDirectionZones();
/// constant, steady, varied, unsteady, any; radians.
[[nodiscard]] std::span<const Zone> CurrentDirectionDeviationZones();
/// calm, smooth, regular, choppy, any; half periods in seconds.
[[nodiscard]] std::span<const Zone> CurrentHalfPeriodZones();

/// Returns the zone of this name, or nullptr.
[[nodiscard]] const Zone* FindZone(std::span<const Zone> zones, std::string_view name);

/// What a current's parameters are drawn from. The defaults are MuNet's: typical, steady, regular,
/// northeast, steady, regular.
struct CurrentRanges {
  Range speed_mps = {0.05, 0.5};
  Range speed_deviation_mps = {0.01, 0.1};
  Range speed_half_period_s = {30, 90};
  Range direction_rad = {kPi / 8, 3 * kPi / 8};
  Range direction_deviation_rad = {0.01, kPi / 18};
  Range direction_half_period_s = {30, 90};
};

/// Draws each parameter uniformly from its range, with a stream of its own: another range for one
/// changes none of the others. The direction comes wrapped to (-pi, pi].
[[nodiscard]] CurrentParams DrawCurrent(const CurrentRanges& ranges, const StreamKey& key);

/// A whole sea by one name.
struct OceanPreset {
  std::string_view name;
  CurrentRanges current = {};
  double floor_z_m = 125;  ///< Least depth of the floor.
};

/// calm, dead, stormy.
[[nodiscard]] std::span<const OceanPreset> OceanPresets();

/// Returns the preset of this name, or nullptr.
[[nodiscard]] const OceanPreset* FindOceanPreset(std::string_view name);

}  // namespace shoal
