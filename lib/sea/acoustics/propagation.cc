#include "lib/sea/acoustics/propagation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"

namespace shoal {

double TransmissionLoss(double range_m, double spreading_exponent, double absorption_dbpkm) {
  if (!(range_m >= 0 && spreading_exponent >= 0 && absorption_dbpkm >= 0)) return kInfinity;
  const double spreading_db = spreading_exponent * 10 * Log10(std::max(range_m, 1.0));
  const double loss_db = spreading_db + absorption_dbpkm * (range_m / 1000);
  return std::isnan(loss_db) ? kInfinity : loss_db;
}

double SignalToNoise(double source_level_db, double transmission_loss_db, double noise_level_db) {
  const double snr_db = source_level_db - transmission_loss_db - noise_level_db;
  return std::isnan(snr_db) ? -kInfinity : snr_db;
}

}  // namespace shoal
