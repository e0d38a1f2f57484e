#include "lib/sea/acoustics/loss_models.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

namespace {

constexpr double kLossPerKhz = 0.01;
constexpr double kSpreading_db = 15;        ///< Per decade of range.
constexpr double kNearest = 1e-6;           ///< Of the nominal distance: keeps log10 finite.
constexpr double kUninformativeRate = 0.5;  ///< Of bits that are wrong.

/// Returns `probability` brought into [0, limit]; 0 for NaN, which only options that FindProblems
/// refuses lead to.
double Limited(double probability, double limit) {
  return probability > 0 ? std::min(probability, limit) : 0;
}

}  // namespace

double PacketLossProbability(const AcousticOptions& options, double range_m, double freq_khz) {
  if (!(options.packet_loss > 0)) return 0;
  const double frequency_factor = 1 + kLossPerKhz * (freq_khz - options.base_freq_khz);
  const double distance_factor =
      Exp((range_m - options.nominal_distance_m) / options.packet_loss_distance_m);
  switch (options.packet_loss_model) {
    case PacketLossModel::kUniform:
      return Limited(options.packet_loss, 1);
    case PacketLossModel::kExpSimple:
      return Limited(options.packet_loss * distance_factor * frequency_factor, 1);
    case PacketLossModel::kSonarSimple: {
      const double distance = range_m / options.nominal_distance_m;
      return Limited(
          options.packet_loss * distance * std::sqrt(distance) * distance_factor * frequency_factor,
          1);
    }
    case PacketLossModel::kOff:
    case PacketLossModel::kModem:
      return 0;
  }
  return 0;
}

double BitErrorProbability(const AcousticOptions& options, double range_m) {
  if (!(options.bit_error_rate > 0)) return 0;
  const double distance = range_m / options.nominal_distance_m;
  switch (options.bit_error_model) {
    case BitErrorModel::kPoisson:
      return Limited(options.bit_error_rate, kUninformativeRate);
    case BitErrorModel::kExpSimple:
      return Limited(options.bit_error_rate *
                         Exp((range_m - options.nominal_distance_m) / options.bit_error_distance_m),
                     kUninformativeRate);
    case BitErrorModel::kSnr: {
      const double lost_db = kSpreading_db * Log10(std::max(distance, kNearest));
      return Limited(options.bit_error_rate * Pow(10, options.snr_slope * lost_db),
                     kUninformativeRate);
    }
    case BitErrorModel::kOff:
    case BitErrorModel::kModem:
      return 0;
  }
  return 0;
}

}  // namespace shoal
