#include "lib/base/statistics/distributions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

namespace {

/// Returns p[0] x^(N-1) + ... + p[N-1].
template <size_t N>
double Polynomial(const std::array<double, N>& p, double x) {
  double sum = 0;
  for (const double each : p) sum = sum * x + each;
  return sum;
}

/// Returns the quantile of the normal distribution to 1.2e-9 of itself: Acklam's rational
/// approximation. @pre 0 < p <= 1/2
double RoughNormalQuantile(double p) {
  constexpr std::array kA = {-3.969683028665376e+01, 2.209460984245205e+02,  -2.759285104469687e+02,
                             1.383577518672690e+02,  -3.066479806614716e+01, 2.506628277459239e+00};
  constexpr std::array kB = {-5.447609879822406e+01, 1.615858368580409e+02,  -1.556989798598866e+02,
                             6.680131188771972e+01,  -1.328068155288572e+01, 1.0};
  constexpr std::array kC = {-7.784894002430293e-03, -3.223964580411365e-01, -2.400758277161838e+00,
                             -2.549732539343734e+00, 4.374664141464968e+00,  2.938163982698783e+00};
  constexpr std::array kD = {7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00,
                             3.754408661907416e+00, 1.0};
  constexpr double kTail = 0.02425;
  if (p < kTail) {
    const double q = std::sqrt(-2 * Log(p));
    return Polynomial(kC, q) / Polynomial(kD, q);
  }
  const double q = p - 0.5;
  return q * Polynomial(kA, q * q) / Polynomial(kB, q * q);
}

/// Returns the continued fraction of the incomplete beta function (DLMF 8.17.22), by Lentz's
/// method. It converges quickly for x < (a + 1) / (a + b + 2).
double BetaFraction(double a, double b, double x) {
  constexpr double kTiny = 1e-300;
  constexpr int kMaxTerms = 100'000;  // About the root of the larger parameter is enough.
  const auto away_from_0 = [](double value) { return std::abs(value) < kTiny ? kTiny : value; };
  double c = 1;
  double d = 1 / away_from_0(1 - (a + b) * x / (a + 1));
  double fraction = d;
  for (int m = 1; m <= kMaxTerms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / away_from_0(1 + even * d);
    c = away_from_0(1 + even / c);
    fraction *= d * c;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / away_from_0(1 + odd * d);
    c = away_from_0(1 + odd / c);
    fraction *= d * c;
    if (std::abs(d * c - 1) < 1e-16) break;
  }
  return fraction;
}

}  // namespace

double NormalCumulative(double z) { return Erfc(-z / std::numbers::sqrt2) / 2; }

double NormalQuantile(double probability) {
  if (!(probability >= 0 && probability <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (probability == 0) return -std::numeric_limits<double>::infinity();
  if (probability == 1) return std::numeric_limits<double>::infinity();
  const double p = std::min(probability, 1 - probability);
  double z = RoughNormalQuantile(p);
  // Halley's steps; beyond this their numbers would leave the range of double.
  constexpr double kLeastRefined = 1e-300;
  for (int i = 0; i < 2 && p > kLeastRefined; ++i) {
    const double excess = NormalCumulative(z) - p;
    const double step = excess * std::sqrt(2 * std::numbers::pi) * Exp(z * z / 2);
    z -= step / (1 + z * step / 2);
  }
  return probability < 0.5 ? z : -z;
}

double RegularizedBeta(double a, double b, double x) {
  SHOAL_CHECK(a > 0 && b > 0, "the beta distribution's parameters are positive");
  if (std::isnan(x)) return x;
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  const double log_front = LogGamma(a + b) - LogGamma(a) - LogGamma(b) + a * Log(x) + b * Log1p(-x);
  if (x < (a + 1) / (a + b + 2)) return Exp(log_front) * BetaFraction(a, b, x) / a;
  return 1 - Exp(log_front) * BetaFraction(b, a, 1 - x) / b;
}

double BetaQuantile(double a, double b, double probability) {
  SHOAL_CHECK(probability >= 0 && probability <= 1, "a probability is in [0, 1]");
  if (probability == 0 || probability == 1) return probability;
  const double log_scale = LogGamma(a + b) - LogGamma(a) - LogGamma(b);
  double low = 0;
  double high = 1;
  double x = a / (a + b);
  // Newton's steps where they stay between the bounds, else halves.
  for (int i = 0; i < 200; ++i) {
    const double excess = RegularizedBeta(a, b, x) - probability;
    (excess < 0 ? low : high) = x;
    const double density = Exp(log_scale + (a - 1) * Log(x) + (b - 1) * Log1p(-x));
    double next = x - excess / density;
    if (!(next > low && next < high)) next = (low + high) / 2;
    const double step = std::abs(next - x);
    x = next;
    if (step <= 1e-15 * x) break;
  }
  return x;
}

double StudentTwoSidedTail(double degrees, double t) {
  SHOAL_CHECK(degrees > 0, "Student's t has more than 0 degrees of freedom");
  if (std::isinf(t)) return 0;
  return RegularizedBeta(degrees / 2, 0.5, degrees / (degrees + t * t));
}

double StudentCumulative(double degrees, double t) {
  const double tail = StudentTwoSidedTail(degrees, t) / 2;
  return t < 0 ? tail : 1 - tail;
}

double StudentCritical(double degrees, double confidence) {
  SHOAL_CHECK(degrees > 0, "Student's t has more than 0 degrees of freedom");
  SHOAL_CHECK(confidence >= 0 && confidence <= 1, "a confidence is in [0, 1]");
  const double tail = 1 - confidence;
  if (tail == 0) return std::numeric_limits<double>::infinity();
  const double log_scale =
      LogGamma((degrees + 1) / 2) - LogGamma(degrees / 2) - Log(degrees * std::numbers::pi) / 2;
  // The tail is convex above 0, and the normal quantile is below the root: Newton's steps rise
  // towards it and never pass it.
  double t = -NormalQuantile(tail / 2);
  for (int i = 0; i < 200; ++i) {
    const double density = Exp(log_scale - (degrees + 1) / 2 * Log1p(t * t / degrees));
    const double step = (StudentTwoSidedTail(degrees, t) - tail) / (2 * density);
    t += step;
    if (std::abs(step) <= 1e-14 * (1 + t)) break;
  }
  return t;
}

double BinomialCumulative(int64_t successes, int64_t trials, double probability) {
  SHOAL_CHECK(trials >= 0, "a number of trials is not negative");
  if (successes < 0) return 0;
  if (successes >= trials) return 1;
  return RegularizedBeta(static_cast<double>(trials - successes),
                         static_cast<double>(successes) + 1, 1 - probability);
}

}  // namespace shoal
