#include "lib/vehicle/navigation/chi_square.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

namespace {

constexpr int kMaxTerms = 10'000;

/// Returns P(a, x) by its series; for x < a + 1.
double GammaSeries(double a, double x) {
  double term = 1 / a;
  double sum = term;
  for (int n = 1; n < kMaxTerms && term > sum * 1e-17; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * Exp(-x + a * Log(x) - LogGamma(a));
}

/// Returns 1 - P(a, x) by its continued fraction, evaluated after Lentz (1976); for x >= a + 1.
double GammaFraction(double a, double x) {
  constexpr double kTiny = 1e-300;
  double b = x + 1 - a;
  double c = 1 / kTiny;
  double d = 1 / b;
  double fraction = d;
  for (int i = 1; i < kMaxTerms; ++i) {
    const double step = -i * (i - a);
    b += 2;
    d = step * d + b;
    if (std::abs(d) < kTiny) d = kTiny;
    c = b + step / c;
    if (std::abs(c) < kTiny) c = kTiny;
    d = 1 / d;
    fraction *= d * c;
    if (std::abs(d * c - 1) < 1e-16) break;
  }
  return fraction * Exp(-x + a * Log(x) - LogGamma(a));
}

}  // namespace

double ChiSquareCumulative(int degrees, double value) {
  SHOAL_CHECK(degrees >= 1, "degrees >= 1");
  if (!(value > 0)) return 0;
  const double a = degrees / 2.0;
  const double x = value / 2;
  return x < a + 1 ? GammaSeries(a, x) : 1 - GammaFraction(a, x);
}

double ChiSquareQuantile(int degrees, double probability) {
  SHOAL_CHECK(probability >= 0 && probability < 1, "0 <= probability < 1");
  if (probability == 0) return 0;
  double low = 0;
  double high = degrees;
  while (ChiSquareCumulative(degrees, high) < probability) high *= 2;
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double middle = (low + high) / 2;
    (ChiSquareCumulative(degrees, middle) < probability ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace shoal
