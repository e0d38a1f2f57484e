#include "lib/sea/ocean/sound_speed.h"

#include "lib/base/check/bounds.h"

namespace shoal {
bool IsSeaWater(const SeaWater& water) {
  return IsBetween(water.temperature_degc, kMinTemperature_degc, kMaxTemperature_degc) &&
         IsBetween(water.salinity_ppt, kMinSalinity_ppt, kMaxSalinity_ppt) &&
         IsBetween(water.depth_m, 0, kMaxDepth_m) && IsBetween(water.ph, kMinPh, kMaxPh);
}

std::optional<double> SoundSpeed(const SeaWater& water) {
  if (!IsSeaWater(water) || water.salinity_ppt < kMinSalinityForSoundSpeed_ppt) {
    return std::nullopt;
  }
  const double t = water.temperature_degc;
  const double s = water.salinity_ppt - 35;
  const double d = water.depth_m;
  return 1448.96 + 4.591 * t - 5.304e-2 * t * t + 2.374e-4 * t * t * t + 1.340 * s + 1.630e-2 * d +
         1.675e-7 * d * d - 1.025e-2 * t * s - 7.139e-13 * t * d * d * d;
}

}  // namespace shoal
