#include "lib/sea/acoustics/absorption.h"

#include <cmath>
#include <limits>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"

namespace shoal {
namespace {

/// False for NaN.
/// One chemical that takes up sound around its `relaxation_khz`.
double Relaxation(double relaxation_khz, double frequency_khz) {
  const double f2 = frequency_khz * frequency_khz;
  return relaxation_khz * f2 / (f2 + relaxation_khz * relaxation_khz);
}

/// The viscous absorption of water at the surface, in dB/km/kHz^2. Two cubics meet at 20 degC.
double PureWater(double t) {
  if (t <= 20) return 4.937e-4 - 2.59e-5 * t + 9.11e-7 * t * t - 1.50e-8 * t * t * t;
  return 3.964e-4 - 1.146e-5 * t + 1.45e-7 * t * t - 6.5e-10 * t * t * t;
}

}  // namespace

double ThorpAbsorption(double frequency_khz) {
  if (!IsFrequency(frequency_khz)) return kInfinity;
  const double f2 = frequency_khz * frequency_khz;
  return 0.11 * f2 / (1 + f2) + 44 * f2 / (4100 + f2) + 2.75e-4 * f2 + 0.003;
}

double FrancoisGarrisonAbsorption(double frequency_khz, const SeaWater& water) {
  if (!IsFrequency(frequency_khz) || !IsSeaWater(water)) return kInfinity;
  const double t = water.temperature_degc;
  const double s = water.salinity_ppt;
  const double d = water.depth_m;
  const double kelvin = 273 + t;
  const double sound_speed_mps = 1412 + 3.21 * t + 1.19 * s + 0.0167 * d;

  const double boric_strength = 8.86 / sound_speed_mps * Pow(10, 0.78 * water.ph - 5);
  const double boric_khz = 2.8 * std::sqrt(s / 35) * Pow(10, 4 - 1245 / kelvin);

  const double sulphate_strength = 21.44 * s / sound_speed_mps * (1 + 0.025 * t);
  const double sulphate_pressure = 1 - 1.37e-4 * d + 6.2e-9 * d * d;
  const double sulphate_khz = 8.17 * Pow(10, 8 - 1990 / kelvin) / (1 + 0.0018 * (s - 35));

  const double water_pressure = 1 - 3.83e-5 * d + 4.9e-10 * d * d;

  return boric_strength * Relaxation(boric_khz, frequency_khz) +
         sulphate_strength * sulphate_pressure * Relaxation(sulphate_khz, frequency_khz) +
         PureWater(t) * water_pressure * frequency_khz * frequency_khz;
}

double Absorption(AbsorptionModel model, double frequency_khz, const SeaWater& water) {
  return model == AbsorptionModel::kThorp ? ThorpAbsorption(frequency_khz)
                                          : FrancoisGarrisonAbsorption(frequency_khz, water);
}

}  // namespace shoal
