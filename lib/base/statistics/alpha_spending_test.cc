#include "lib/base/statistics/alpha_spending.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/base/statistics/distributions.h"

namespace shoal {

namespace {

void ExpectBounds(SpendingCurve curve, const std::vector<double>& fractions,
                  const std::vector<double>& expected) {
  const std::vector<double> bounds = SpendingBounds(curve, 0.05, fractions);
  ASSERT_EQ(bounds.size(), expected.size());
  for (size_t i = 0; i < bounds.size(); ++i) EXPECT_NEAR(bounds[i], expected[i], 6e-4) << i;
}

}  // namespace

// Reboussin, DeMets, Kim and Lan 2000, "Computations for group sequential boundaries using the
// Lan-DeMets spending function method": five equal looks, two-sided 0.05.
TEST(SpendingBounds, AreThePublishedOnesOfFiveEqualLooks) {
  const std::vector<double> fractions = {0.2, 0.4, 0.6, 0.8, 1};
  ExpectBounds(SpendingCurve::kObrienFleming, fractions, {4.877, 3.357, 2.680, 2.290, 2.031});
  ExpectBounds(SpendingCurve::kPocock, fractions, {2.438, 2.427, 2.410, 2.397, 2.386});
}

TEST(SpendingBounds, OfOneLookAreThoseOfAPlainTest) {
  ExpectBounds(SpendingCurve::kObrienFleming, {1}, {1.95996});
  ExpectBounds(SpendingCurve::kPocock, {1}, {1.95996});
}

TEST(SpendingBounds, SpendAllOfAlphaInSimulatedLooks) {
  const std::vector<double> fractions = {0.1, 0.13, 0.55, 0.9, 1};
  for (const auto curve : {SpendingCurve::kObrienFleming, SpendingCurve::kPocock}) {
    const std::vector<double> bounds = SpendingBounds(curve, 0.05, fractions);
    constexpr int kRuns = 100'000;
    int num_beyond = 0;
    Stream stream(18, "looks", static_cast<int>(curve));
    for (int run = 0; run < kRuns; ++run) {
      double sum = 0;
      double before = 0;
      bool is_beyond = false;
      for (size_t i = 0; i < fractions.size(); ++i) {
        sum += std::sqrt(fractions[i] - before) * stream.Normal();
        before = fractions[i];
        is_beyond = is_beyond || std::abs(sum) > bounds[i] * std::sqrt(fractions[i]);
      }
      if (is_beyond) ++num_beyond;
    }
    EXPECT_NEAR(static_cast<double>(num_beyond) / kRuns, 0.05, 3 * std::sqrt(0.05 * 0.95 / kRuns));
  }
}

TEST(SpendingBounds, AreInfiniteWhereThereIsNothingToSpend) {
  const std::vector<double> bounds =
      SpendingBounds(SpendingCurve::kObrienFleming, 0.05, std::vector<double>{0.01, 1});
  EXPECT_EQ(bounds[0], std::numeric_limits<double>::infinity());
  EXPECT_NEAR(bounds[1], 1.95996, 1e-4) << "all of it is left for the last look";
}

TEST(SpendingBounds, DoNotDependOnHowCloseTheLooksAre) {
  std::vector<double> fractions;
  for (int i = 0; i < 6; ++i) fractions.push_back(0.5 + i * 5e-4);
  fractions.push_back(1);
  const std::vector<double> many = SpendingBounds(SpendingCurve::kPocock, 0.05, fractions);
  const std::vector<double> few =
      SpendingBounds(SpendingCurve::kPocock, 0.05, std::vector<double>{0.5025, 1});
  // What is spent by then is the same; so is nearly what is left to be found at the end.
  EXPECT_NEAR(many.back(), few.back(), 0.02);
}

TEST(SpentAlpha, IsNothingAtFirstAndAllAtTheEnd) {
  for (const auto curve : {SpendingCurve::kObrienFleming, SpendingCurve::kPocock}) {
    EXPECT_EQ(SpentAlpha(curve, 0.05, 0), 0);
    EXPECT_NEAR(SpentAlpha(curve, 0.05, 1), 0.05, 1e-15);
    EXPECT_LT(SpentAlpha(curve, 0.05, 0.3), SpentAlpha(curve, 0.05, 0.31));
  }
}

TEST(RepeatedConfidence, IsThatOfTheBound) {
  EXPECT_NEAR(RepeatedConfidence(NormalQuantile(0.975)), 0.95, 1e-15);
  EXPECT_EQ(RepeatedConfidence(std::numeric_limits<double>::infinity()), 1);
}

}  // namespace shoal
