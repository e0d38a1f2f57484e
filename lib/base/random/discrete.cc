// Binomial draws. Small means: inversion. Large means: the transformed rejection of W. Hoermann,
// "The generation of binomial random variates", J. Statist. Comput. Simul. 46 (1993) (algorithm
// BTRS). The constants are his.
#include "lib/base/random/discrete.h"

#include <array>
#include <cmath>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

namespace {

/// The rejection holds from this mean on; inversion needs about as many steps.
constexpr double kLargeMean = 10;

/// Returns ln(k!). (std::lgamma writes a global variable.)
double LogFactorial(double k) {
  static constexpr std::array<double, 10> kFactorials = {1,   1,   2,    6,     24,
                                                         120, 720, 5040, 40320, 362880};
  if (k < 10) return Log(kFactorials[static_cast<size_t>(k)]);
  // Stirling's series for k >= 10: the next term is below 6e-11.
  const double n = k + 1;
  const double inverse_square = 1 / (n * n);
  const double correction = (1.0 / 12 - (1.0 / 360 - inverse_square / 1260) * inverse_square) / n;
  return (k + 0.5) * Log(n) - n + 0.5 * Log(2 * std::numbers::pi) + correction;
}

int64_t BinomialByInversion(Stream& stream, int64_t trials, double probability) {
  const double odds = probability / (1 - probability);
  const double none = Exp(static_cast<double>(trials) * Log1p(-probability));  // > e^-20.
  for (;;) {
    double remaining = stream.Uniform();
    double mass = none;
    for (int64_t k = 0; k <= trials; ++k) {
      if (remaining < mass) return k;
      remaining -= mass;
      mass *= odds * static_cast<double>(trials - k) / static_cast<double>(k + 1);
      if (mass == 0) break;  // Rounding has left a remainder that belongs to no k: draw again.
    }
  }
}

int64_t BinomialByRejection(Stream& stream, double trials, double probability) {
  const double deviation = std::sqrt(trials * probability * (1 - probability));
  const double b = 1.15 + 2.53 * deviation;
  const double a = -0.0873 + 0.0248 * b + 0.01 * probability;
  const double c = trials * probability + 0.5;
  const double alpha = (2.83 + 5.1 / b) * deviation;
  const double squeeze = 0.92 - 4.2 / b;
  const double log_odds = Log(probability / (1 - probability));
  const double mode = std::floor((trials + 1) * probability);
  const double log_mode = LogFactorial(mode) + LogFactorial(trials - mode);
  for (;;) {
    const double u = stream.Uniform() - 0.5;
    const double v = stream.Uniform();
    const double us = 0.5 - std::abs(u);
    const double k = std::floor((2 * a / us + b) * u + c);
    if (!(k >= 0 && k <= trials)) continue;
    if (us >= 0.07 && v <= squeeze) return static_cast<int64_t>(k);
    const double accept =
        log_mode - LogFactorial(k) - LogFactorial(trials - k) + (k - mode) * log_odds;
    if (Log(v * alpha / (a / (us * us) + b)) <= accept) return static_cast<int64_t>(k);
  }
}

}  // namespace

int64_t DrawBinomial(int64_t trials, double probability, Stream* stream) {
  SHOAL_CHECK(trials >= 0 && probability >= 0 && probability <= 1,
              "trials >= 0, 0 <= probability <= 1");
  if (trials == 0 || probability == 0) return 0;
  if (probability > 0.5) return trials - DrawBinomial(trials, 1 - probability, stream);
  const auto n = static_cast<double>(trials);
  return n * probability < kLargeMean ? BinomialByInversion(*stream, trials, probability)
                                      : BinomialByRejection(*stream, n, probability);
}

}  // namespace shoal
