// Currents by name: "moderate" speed, "choppy" periods. A zone is a range from
// which a number is drawn once, when a mission starts. The names and numbers are MuNet's.
#pragma once

#include <span>
#include <string_view>

#include "lib/base/geometry/angles.h"
#include "lib/base/random/stream.h"
#include "lib/sea/ocean/current.h"

namespace shoal {

/// What a number is drawn from: low <= high; equal ones are that number. Directions: psi in
/// radians, high at most low + 2 pi.
struct DrawRange {
  double low = 0;
  double high = 0;
};

struct Zone {
  std::string_view name;
  DrawRange range = {};
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
  DrawRange speed_mps = {0.05, 0.5};
  DrawRange speed_deviation_mps = {0.01, 0.1};
  DrawRange speed_half_period_s = {30, 90};
  DrawRange direction_rad = {kPi / 8, 3 * kPi / 8};
  DrawRange direction_deviation_rad = {0.01, kPi / 18};
  DrawRange direction_half_period_s = {30, 90};
};

/// Draws each parameter uniformly from its range, with a stream of its own: another range for one
/// changes none of the others. The direction comes wrapped to (-pi, pi].
[[nodiscard]] CurrentParams DrawCurrent(const CurrentRanges& ranges, const StreamKey& key);

}  // namespace shoal
