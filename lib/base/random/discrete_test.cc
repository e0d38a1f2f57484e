// Binomial and Poisson against their probabilities: chi-square at one in a thousand, fixed seeds.
#include "lib/base/random/discrete.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "lib/base/random/stream.h"

namespace shoal::discrete_test {

constexpr int kDraws = 20'000;

/// Returns the value that chi-square of this many degrees of freedom exceeds once in a thousand
/// (Wilson and Hilferty, 1931).
double ChiSquareLimit(double degrees) {
  const double variance = 2 / (9 * degrees);
  return degrees * std::pow(1 - variance + 3.0902 * std::sqrt(variance), 3);
}

/// Compares draws with probabilities: neighbouring values are pooled until at least 20 are
/// expected in a bin.
void ExpectDistribution(const std::function<int64_t()>& draw, int64_t largest,
                        const std::function<double(int64_t)>& probability) {
  std::vector<int> counts(static_cast<size_t>(largest) + 1);
  for (int i = 0; i < kDraws; ++i) {
    const int64_t value = draw();
    ASSERT_GE(value, 0);
    ASSERT_LE(value, largest);
    ++counts[static_cast<size_t>(value)];
  }
  double chi_square = 0;
  int bins = 0;
  double expected = 0;
  double observed = 0;
  double left = kDraws;
  for (int64_t k = 0; k <= largest; ++k) {
    expected += kDraws * probability(k);
    observed += counts[static_cast<size_t>(k)];
    const bool last = k == largest;
    if (last) expected = left;
    if (!last && (expected < 20 || left - expected < 20)) continue;
    chi_square += (observed - expected) * (observed - expected) / expected;
    ++bins;
    left -= expected;
    expected = observed = 0;
  }
  ASSERT_GT(bins, 1);
  EXPECT_LT(chi_square, ChiSquareLimit(bins - 1)) << bins << " bins";
}

double BinomialProbability(int64_t k, int64_t n, double p) {
  const auto kd = static_cast<double>(k);
  const auto nd = static_cast<double>(n);
  return std::exp(std::lgamma(nd + 1) - std::lgamma(kd + 1) - std::lgamma(nd - kd + 1) +
                  kd * std::log(p) + (nd - kd) * std::log1p(-p));
}

struct BinomialCase {
  int64_t trials;
  double probability;
};
class Binomial : public testing::TestWithParam<BinomialCase> {};

TEST_P(Binomial, DrawsWithItsProbabilities) {
  const auto [trials, probability] = GetParam();
  Stream stream(21, "test", trials);
  ExpectDistribution([&] { return DrawBinomial(trials, probability, &stream); }, trials,
                     [&](int64_t k) { return BinomialProbability(k, trials, probability); });
}

// Both methods, both sides of their border, both sides of one half, and a long packet's bit errors.
INSTANTIATE_TEST_SUITE_P(SmallAndLarge, Binomial,
                         testing::Values(BinomialCase{1, 0.3}, BinomialCase{20, 0.1},
                                         BinomialCase{99, 0.1}, BinomialCase{101, 0.1},
                                         BinomialCase{40, 0.5}, BinomialCase{200, 0.85},
                                         BinomialCase{100'000, 1e-5},
                                         BinomialCase{100'000, 0.003}));

TEST(Binomial, IsCertainAtTheEnds) {
  Stream stream(22, "test");
  EXPECT_EQ(DrawBinomial(0, 0.5, &stream), 0);
  EXPECT_EQ(DrawBinomial(1000, 0, &stream), 0);
  EXPECT_EQ(DrawBinomial(1000, 1, &stream), 1000);
}

}  // namespace shoal::discrete_test
