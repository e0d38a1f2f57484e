// How much weaker a radio signal is at its receiver, and how far antennas see each other.
#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace shoal {

enum class PathLossModel {
  kNone,         ///< The range alone decides.
  kLogDistance,  ///< Free space up to 1 m, then 10 x exponent x log10(range).
  kTwoRay,       ///< The direct ray and the one that the sea reflects.
};

inline constexpr std::array<std::pair<std::string_view, PathLossModel>, 3> kPathLossModels = {{
    {"none", PathLossModel::kNone},
    {"log_distance", PathLossModel::kLogDistance},
    {"two_ray", PathLossModel::kTwoRay},
}};

/// Returns the loss between isotropic antennas in free space (Friis 1946): 20 log10(4 pi range /
/// wavelength), in dB. Below a range of 1 m it is that of 1 m. @pre frequency_mhz > 0
[[nodiscard]] double FreeSpaceLoss_db(double range_m, double frequency_mhz);

/// Returns the loss of the log-distance model with the reference distance 1 m (Rappaport, Wireless
/// Communications, 2nd ed. 2002, section 4.9.1), in dB. @pre frequency_mhz > 0, exponent > 0
[[nodiscard]] double LogDistanceLoss_db(double range_m, double frequency_mhz, double exponent);

/// Returns the loss over a flat sea (Rappaport, section 4.6): that of free space up to the range
/// 4 pi h1 h2 / wavelength, where both are equal, then 40 log10(range) - 20 log10(h1 h2), in dB.
/// Antennas count as 1 cm high at least. @pre frequency_mhz > 0
[[nodiscard]] double TwoRayLoss_db(double range_m, double frequency_mhz, double height_m,
                                   double other_height_m);

/// Returns the range at which each model's loss is `loss_db`; 1 m where it is less than that of
/// 1 m.
[[nodiscard]] double LogDistanceReach_m(double loss_db, double frequency_mhz, double exponent);
[[nodiscard]] double TwoRayReach_m(double loss_db, double frequency_mhz, double height_m,
                                   double other_height_m);

/// What the two-ray model needs again and again, for callers with many links: of the losses alone,
/// and of two antennas of the height that most have.
struct TwoRayTerms {
  double free_m = 0;          ///< The range without a sea.
  double far_per_height = 0;  ///< Beyond the crossover: reach over sqrt(h1 h2).
  double height_m = -1;       ///< Of both antennas, for what follows; negative: no link is.
  double crossover_m = 0;
  double heights_db = 0;  ///< 20 log10(h1 h2).
  double reach_m = 0;
};
[[nodiscard]] TwoRayTerms TwoRayTermsOf(double loss_db, double frequency_mhz,
                                        double usual_height_m = -1);
/// The same as without the terms, bit for bit.
[[nodiscard]] double TwoRayReach_m(const TwoRayTerms& terms, double frequency_mhz, double height_m,
                                   double other_height_m);
[[nodiscard]] double TwoRayLoss_db(const TwoRayTerms& terms, double range_m, double frequency_mhz,
                                   double height_m, double other_height_m);

/// Returns the range at which the round Earth hides two antennas from each other, rays bent by a
/// standard atmosphere: sqrt(2 k R h1) + sqrt(2 k R h2), with k = 4/3 (ITU-R P.310) and R =
/// 6371 km. A height below 0 counts as 0.
[[nodiscard]] double RadioHorizon_m(double height_m, double other_height_m);

}  // namespace shoal
