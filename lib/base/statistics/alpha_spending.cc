#include "lib/base/statistics/alpha_spending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/statistics/distributions.h"

namespace shoal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A value of the Brownian motion sum / sqrt(total), and the probability of being there undecided.
struct Node {
  double value = 0;
  double weight = 0;
};

/// The values of the motion at a look, for motions that no look has decided so far.
struct Undecided {
  double fraction = 0;
  std::vector<Node> nodes = {{0, 1}};  ///< At the start, at 0 for certain.
};

/// Returns the probability of being beyond `bound` at the look `fraction`.
double ProbabilityBeyond(const Undecided& before, double fraction, double bound) {
  const double limit = bound * std::sqrt(fraction);
  const double deviation = std::sqrt(fraction - before.fraction);
  double sum = 0;
  for (const Node& node : before.nodes) {
    sum += node.weight * (NormalCumulative((-limit - node.value) / deviation) +
                          NormalCumulative((node.value - limit) / deviation));
  }
  return sum;
}

/// Returns the bound that spends `alpha` at the look `fraction`.
double BoundThatSpends(const Undecided& before, double fraction, double alpha) {
  constexpr double kLeast = 1e-15;  // Beyond 8 standard deviations.
  if (alpha < kLeast) return kInfinity;
  double low = 0;
  double high = 10;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (ProbabilityBeyond(before, fraction, middle) > alpha ? low : high) = middle;
  }
  return high;
}

/// Returns where the motion is at the look `fraction` when it is not beyond `bound`: by Simpson's
/// rule, in steps that are small beside the motion since the look before and until the next.
Undecided Continue(const Undecided& before, double fraction, double bound, double next_fraction) {
  constexpr double kFarthest = 9;  // Standard deviations: 1e-19 is beyond.
  const double limit = std::min(bound, kFarthest) * std::sqrt(fraction);
  const double since = fraction - before.fraction;
  const double deviation = std::sqrt(since);
  const double finest = std::min(deviation, std::sqrt(next_fraction - fraction));
  const int num_steps = 2 * std::clamp(static_cast<int>(std::ceil(limit / finest * 4)), 32, 1000);
  const double step = 2 * limit / num_steps;
  Undecided after{.fraction = fraction, .nodes = {}};
  after.nodes.reserve(static_cast<size_t>(num_steps) + 1);
  for (int i = 0; i <= num_steps; ++i) {
    const double value = -limit + i * step;
    double density = 0;
    for (const Node& node : before.nodes) {
      const double z = (value - node.value) / deviation;
      density += node.weight * Exp(-z * z / 2);
    }
    density /= deviation * std::sqrt(2 * std::numbers::pi);
    const double simpson = i == 0 || i == num_steps ? 1 : i % 2 == 1 ? 4 : 2;
    after.nodes.push_back({value, density * simpson * step / 3});
  }
  return after;
}

}  // namespace

double SpentAlpha(SpendingCurve curve, double alpha, double fraction) {
  SHOAL_CHECK(fraction >= 0 && fraction <= 1, "a share of the data is in [0, 1]");
  if (fraction == 0) return 0;
  if (curve == SpendingCurve::kPocock) {
    return alpha * Log1p((std::numbers::e - 1) * fraction);
  }
  // Symmetric: cdf(-z) instead of 1 - cdf(z), which would lose small tails.
  return 4 * NormalCumulative(NormalQuantile(alpha / 4) / std::sqrt(fraction));
}

std::vector<double> SpendingBounds(SpendingCurve curve, double alpha,
                                   std::span<const double> fractions) {
  SHOAL_CHECK(alpha > 0 && alpha < 1, "an error probability is in (0, 1)");
  std::vector<double> bounds;
  Undecided undecided;
  double spent = 0;
  for (size_t i = 0; i < fractions.size(); ++i) {
    const double fraction = fractions[i];
    SHOAL_CHECK(fraction > undecided.fraction && fraction <= 1, "looks rise, up to 1");
    const double to_spend = SpentAlpha(curve, alpha, fraction);
    const double bound = BoundThatSpends(undecided, fraction, to_spend - spent);
    bounds.push_back(bound);
    if (std::isfinite(bound)) spent = to_spend;
    if (i + 1 < fractions.size()) {
      undecided = Continue(undecided, fraction, bound, fractions[i + 1]);
    }
  }
  return bounds;
}

double RepeatedConfidence(double bound) { return 1 - 2 * NormalCumulative(-bound); }

}  // namespace shoal
