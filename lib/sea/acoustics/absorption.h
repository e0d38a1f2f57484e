// Absorption of sound by sea water, in dB per km. Spreading is separate
// (lib/sea/acoustics/propagation.h).
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "lib/sea/ocean/sound_speed.h"

namespace shoal {

/// Francois and Garrison is the default: it follows temperature, salinity, depth and pH, and it
/// was fitted to measurements up to 1 MHz. Thorp is for the deep sea at 4 degC and below 50 kHz;
/// it is here because much of the literature on acoustic networks uses it.
enum class AbsorptionModel { kFrancoisGarrison, kThorp };

constexpr std::array<std::pair<std::string_view, AbsorptionModel>, 2> kAbsorptionModels = {{
    {"francois_garrison", AbsorptionModel::kFrancoisGarrison},
    {"thorp", AbsorptionModel::kThorp},
}};

/// Highest frequency of both models, which is that of Francois and Garrison's measurements.
constexpr double kMaxFrequency_khz = 1000;

/// Returns true where the formulas for absorption and noise hold.
constexpr bool IsFrequency(double frequency_khz) {
  return frequency_khz > 0 && frequency_khz <= kMaxFrequency_khz;
}

/// Returns the absorption in dB/km at `frequency_khz`, in (0, kMaxFrequency_khz]; infinity for any
/// other frequency, so that an impossible link carries nothing.
/// Thorp, W. H. (1967), Analytic description of the low-frequency attenuation coefficient, J.
/// Acoust. Soc. Am. 42, 270, per km instead of per kiloyard and with the viscous and the constant
/// term that Brekhovskikh and Lysanov, Fundamentals of Ocean Acoustics (1982), add: eq. (3) of
/// Stojanovic (2007). Holds at 4 degC, 35 ppt, pH 8, about 1000 m; Thorp fitted 0.1 to 10 kHz, and
/// the literature uses it up to 50.
[[nodiscard]] double ThorpAbsorption(double frequency_khz);

/// Returns the absorption in dB/km by boric acid, magnesium sulphate and pure water at
/// `frequency_khz`, in (0, kMaxFrequency_khz]; infinity for any other frequency and where `water`
/// is not IsSeaWater.
/// Francois, R. E. and Garrison, G. R. (1982), Sound absorption based on ocean measurements, part
/// II: boric acid contribution and equation for total absorption, J. Acoust. Soc. Am. 72(6),
/// 1879-1890. For all conditions of the oceans and 0.2 kHz to 1 MHz (their abstract). Without salt
/// it is their term of pure water alone, which holds for lakes.
[[nodiscard]] double FrancoisGarrisonAbsorption(double frequency_khz, const SeaWater& water);

/// Returns the absorption in dB/km by `model`, which may ignore `water`.
[[nodiscard]] double Absorption(AbsorptionModel model, double frequency_khz, const SeaWater& water);

}  // namespace shoal
