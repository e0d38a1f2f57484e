#include "lib/sea/acoustics/modulation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"

namespace shoal {
namespace {

/// `ratio` is Eb/N0 as a plain number, [0, infinity].
double WithoutFading(Modulation modulation, double ratio) {
  switch (modulation) {
    case Modulation::kCoherentPsk:
      return Erfc(std::sqrt(ratio)) / 2;
    case Modulation::kDifferentialPsk:
      return Exp(-ratio) / 2;
    case Modulation::kCoherentFsk:
      return Erfc(std::sqrt(ratio / 2)) / 2;
    case Modulation::kNoncoherentFsk:
      return Exp(-ratio / 2) / 2;
  }
  return 0.5;
}

/// Returns (1 - sqrt(ratio / (loss + ratio))) / 2 without the cancellation of large ratios.
double CoherentInRayleighFading(double ratio, double loss) {
  const double mu = std::sqrt(1 / (1 + loss / ratio));
  return loss / (loss + ratio) / (1 + mu) / 2;
}

/// Likewise; `ratio` is the mean of Eb/N0.
double InRayleighFading(Modulation modulation, double ratio) {
  switch (modulation) {
    case Modulation::kCoherentPsk:
      return CoherentInRayleighFading(ratio, 1);
    case Modulation::kDifferentialPsk:
      return 1 / (1 + ratio) / 2;
    case Modulation::kCoherentFsk:
      return CoherentInRayleighFading(ratio, 2);
    case Modulation::kNoncoherentFsk:
      return 1 / (2 + ratio);
  }
  return 0.5;
}

}  // namespace

double EnergyPerBitToNoise(double snr_db, double bandwidth_khz, double data_rate_bps) {
  if (!(bandwidth_khz > 0 && data_rate_bps > 0)) return -kInfinity;
  const double ratio_db = snr_db + 10 * Log10(bandwidth_khz * 1000 / data_rate_bps);
  return std::isnan(ratio_db) ? -kInfinity : ratio_db;
}

double BitErrorRate(Modulation modulation, Fading fading, double eb_over_n0_db) {
  if (std::isnan(eb_over_n0_db)) return 0.5;
  const double ratio = Pow(10, eb_over_n0_db / 10);
  const double rate = fading == Fading::kRayleigh ? InRayleighFading(modulation, ratio)
                                                  : WithoutFading(modulation, ratio);
  return std::clamp(rate, 0.0, 0.5);
}

}  // namespace shoal
