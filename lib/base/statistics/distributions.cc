#include "lib/base/statistics/distributions.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/SpecialFunctions>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"

namespace shoal {

double NormalCumulative(double z) { return Erfc(-z / std::numbers::sqrt2) / 2; }

double NormalQuantile(double probability) {
  if (!(probability >= 0 && probability <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (probability == 0) return -std::numeric_limits<double>::infinity();
  if (probability == 1) return std::numeric_limits<double>::infinity();
  return Eigen::numext::ndtri(probability);
}

double RegularizedBeta(double a, double b, double x) {
  SHOAL_CHECK(a > 0 && b > 0, "the beta distribution's parameters are positive");
  if (std::isnan(x)) return x;
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  return Eigen::numext::betainc(a, b, x);
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
