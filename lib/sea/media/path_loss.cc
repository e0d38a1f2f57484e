#include "lib/sea/media/path_loss.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

namespace {

constexpr double kLightSpeed_mps = 299'792'458;
constexpr double kNearest_m = 1;
constexpr double kLowest_m = 0.01;

double Wavelength_m(double frequency_mhz) { return kLightSpeed_mps / (frequency_mhz * 1e6); }

/// The product of two antennas' heights.
double Heights_m2(double height_m, double other_height_m) {
  return std::max(height_m, kLowest_m) * std::max(other_height_m, kLowest_m);
}

/// From here on the reflected ray takes the direct one away.
double Crossover_m(double frequency_mhz, double heights_m2) {
  return 4 * std::numbers::pi * heights_m2 / Wavelength_m(frequency_mhz);
}

/// The inverse of FreeSpaceLoss_db.
double FreeSpaceReach_m(double loss_db, double frequency_mhz) {
  return Wavelength_m(frequency_mhz) / (4 * std::numbers::pi) * Pow(10, loss_db / 20);
}

}  // namespace

double FreeSpaceLoss_db(double range_m, double frequency_mhz) {
  return 20 *
         Log10(4 * std::numbers::pi * std::max(range_m, kNearest_m) / Wavelength_m(frequency_mhz));
}

double LogDistanceLoss_db(double range_m, double frequency_mhz, double exponent) {
  return FreeSpaceLoss_db(kNearest_m, frequency_mhz) +
         10 * exponent * Log10(std::max(range_m, kNearest_m) / kNearest_m);
}

double TwoRayLoss_db(double range_m, double frequency_mhz, double height_m, double other_height_m) {
  const double heights_m2 = Heights_m2(height_m, other_height_m);
  const double distance_m = std::max(range_m, kNearest_m);
  if (distance_m <= Crossover_m(frequency_mhz, heights_m2)) {
    return FreeSpaceLoss_db(distance_m, frequency_mhz);
  }
  return 40 * Log10(distance_m) - 20 * Log10(heights_m2);
}

double LogDistanceReach_m(double loss_db, double frequency_mhz, double exponent) {
  const double beyond_db = loss_db - FreeSpaceLoss_db(kNearest_m, frequency_mhz);
  return beyond_db <= 0 ? kNearest_m : kNearest_m * Pow(10, beyond_db / (10 * exponent));
}

double TwoRayReach_m(double loss_db, double frequency_mhz, double height_m, double other_height_m) {
  return TwoRayReach_m(TwoRayTermsOf(loss_db, frequency_mhz), frequency_mhz, height_m,
                       other_height_m);
}

TwoRayTerms TwoRayTermsOf(double loss_db, double frequency_mhz, double usual_height_m) {
  TwoRayTerms terms = {.free_m = FreeSpaceReach_m(loss_db, frequency_mhz),
                       .far_per_height = Pow(10, loss_db / 40)};
  if (usual_height_m < 0) return terms;
  const double heights_m2 = Heights_m2(usual_height_m, usual_height_m);
  terms.crossover_m = Crossover_m(frequency_mhz, heights_m2);
  terms.heights_db = 20 * Log10(heights_m2);
  terms.reach_m = TwoRayReach_m(terms, frequency_mhz, usual_height_m, usual_height_m);
  terms.height_m = usual_height_m;  // Last: from now on it is used.
  return terms;
}

double TwoRayReach_m(const TwoRayTerms& terms, double frequency_mhz, double height_m,
                     double other_height_m) {
  if (height_m == terms.height_m && other_height_m == terms.height_m) return terms.reach_m;
  const double heights_m2 = Heights_m2(height_m, other_height_m);
  const double free_m = terms.free_m;
  const double far_m = terms.far_per_height * std::sqrt(heights_m2);
  const double reach_m = free_m <= Crossover_m(frequency_mhz, heights_m2) ? free_m : far_m;
  return std::max(reach_m, kNearest_m);
}

double TwoRayLoss_db(const TwoRayTerms& terms, double range_m, double frequency_mhz,
                     double height_m, double other_height_m) {
  if (height_m != terms.height_m || other_height_m != terms.height_m) {
    return TwoRayLoss_db(range_m, frequency_mhz, height_m, other_height_m);
  }
  const double distance_m = std::max(range_m, kNearest_m);
  if (distance_m <= terms.crossover_m) return FreeSpaceLoss_db(distance_m, frequency_mhz);
  return 40 * Log10(distance_m) - terms.heights_db;
}

double RadioHorizon_m(double height_m, double other_height_m) {
  constexpr double kEffectiveRadius_m = 4.0 / 3 * 6'371'000;
  const auto horizon_m = [](double height) {
    return std::sqrt(2 * kEffectiveRadius_m * std::max(height, 0.0));
  };
  return horizon_m(height_m) + horizon_m(other_height_m);
}

}  // namespace shoal
