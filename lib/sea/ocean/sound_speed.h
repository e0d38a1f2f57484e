// How fast sound travels in sea water.
//
//   const std::optional<double> speed_mps = SoundSpeed({.temperature_degc = 25, .depth_m = 1000});
#pragma once

#include <optional>

namespace shoal {

/// The water between two modems, taken to be the same everywhere.
struct SeaWater {
  double temperature_degc = 10;
  double salinity_ppt = 35;  ///< Parts per thousand; 0 is fresh water.
  double depth_m = 10;       ///< At which sound travels: between the depths of the two ends.
  double ph = 8;             ///< Matters for absorption below 10 kHz only.

  bool operator==(const SeaWater&) const = default;
};

// What Mackenzie's equation was fitted to: Mackenzie (1981), abstract; the standard error is
// 0.070 m/s for salinities from 25 to 40 ppt. Absorption takes less salty water too, and fresh.
constexpr double kMinTemperature_degc = -2;
constexpr double kMaxTemperature_degc = 30;
constexpr double kMinSalinity_ppt = 0;
constexpr double kMinSalinityForSoundSpeed_ppt = 25;
constexpr double kMaxSalinity_ppt = 40;
constexpr double kMaxDepth_m = 8000;
constexpr double kMinPh = 6;
constexpr double kMaxPh = 9;

/// Returns true where every value is finite and within the limits above, fresh water included.
[[nodiscard]] bool IsSeaWater(const SeaWater& water);

/// Returns the speed of sound in m/s; nullopt where `water` is outside the limits above or fresher
/// than kMinSalinityForSoundSpeed_ppt.
/// Mackenzie, K. V. (1981), Nine-term equation for sound speed in the oceans, J. Acoust. Soc. Am.
/// 70(3), 807-812.
[[nodiscard]] std::optional<double> SoundSpeed(const SeaWater& water);

}  // namespace shoal
