#include "lib/sea/acoustics/ambient_noise.h"

#include <cmath>
#include <limits>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/sea/acoustics/absorption.h"

namespace shoal {
namespace {

// Of Simpson's rule over the logarithm of frequency; even. Within 0.001 dB for a band of three
// decades, which the tests compare with a rule fifty times as fine.
constexpr int kIntervals = 64;

double FromDecibels(double level_db) { return Pow(10, level_db / 10); }

}  // namespace

double TurbulenceNoise(double frequency_khz) {
  if (!IsFrequency(frequency_khz)) return kInfinity;
  return 17 - 30 * Log10(frequency_khz);
}

double ShippingNoise(double frequency_khz, double shipping) {
  if (!IsFrequency(frequency_khz) || !IsBetween(shipping, 0, 1)) return kInfinity;
  return 40 + 20 * (shipping - 0.5) + 26 * Log10(frequency_khz) - 60 * Log10(frequency_khz + 0.03);
}

double WindNoise(double frequency_khz, double wind_mps) {
  if (!IsFrequency(frequency_khz) || !IsBetween(wind_mps, 0, kMaxWind_mps)) return kInfinity;
  return 50 + 7.5 * std::sqrt(wind_mps) + 20 * Log10(frequency_khz) -
         40 * Log10(frequency_khz + 0.4);
}

double ThermalNoise(double frequency_khz) {
  if (!IsFrequency(frequency_khz)) return kInfinity;
  return -15 + 20 * Log10(frequency_khz);
}

double NoiseSpectrumLevel(const AmbientNoise& noise, double frequency_khz) {
  return 10 * Log10(FromDecibels(TurbulenceNoise(frequency_khz)) +
                    FromDecibels(ShippingNoise(frequency_khz, noise.shipping)) +
                    FromDecibels(WindNoise(frequency_khz, noise.wind_mps)) +
                    FromDecibels(ThermalNoise(frequency_khz)));
}

double NoiseBandLevel(const AmbientNoise& noise, double low_khz, double high_khz) {
  if (!IsFrequency(low_khz) || !IsFrequency(high_khz) || low_khz > high_khz) return kInfinity;
  const double log_width = Log(high_khz / low_khz);
  double sum = 0;
  for (int i = 0; i <= kIntervals; ++i) {
    const double frequency_khz = low_khz * Exp(log_width * i / kIntervals);
    const double level_db = NoiseSpectrumLevel(noise, std::fmin(frequency_khz, high_khz));
    const int weight = i == 0 || i == kIntervals ? 1 : (i % 2 == 1 ? 4 : 2);
    sum += weight * FromDecibels(level_db) * frequency_khz * 1000;
  }
  return 10 * Log10(sum * log_width / kIntervals / 3);
}

}  // namespace shoal
