#include "lib/base/statistics/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace shoal {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Simpson's rule over 20,000 steps.
template <class Function>
double IntegralOf(Function function, double from, double to) {
  constexpr int kSteps = 20'000;
  const double step = (to - from) / kSteps;
  double sum = function(from) + function(to);
  for (int i = 1; i < kSteps; ++i) sum += (i % 2 == 1 ? 4 : 2) * function(from + i * step);
  return sum * step / 3;
}

double BetaDensity(double a, double b, double x) {
  return std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + (a - 1) * std::log(x) +
                  (b - 1) * std::log1p(-x));
}

}  // namespace

TEST(Normal, HasThePublishedQuantiles) {
  EXPECT_NEAR(NormalQuantile(0.975), 1.959963984540054, 1e-14);
  EXPECT_NEAR(NormalQuantile(0.95), 1.644853626951473, 1e-14);
  EXPECT_NEAR(NormalQuantile(0.995), 2.575829303548901, 1e-14);
  EXPECT_EQ(NormalQuantile(0.5), 0);
}

TEST(Normal, KnowsItsEnds) {
  EXPECT_EQ(NormalQuantile(0), -kInfinite);
  EXPECT_EQ(NormalQuantile(1), kInfinite);
  EXPECT_TRUE(std::isnan(NormalQuantile(-0.1)));
  EXPECT_TRUE(std::isnan(NormalQuantile(std::nan(""))));
}

TEST(Normal, IsAccurateFarOut) {
  EXPECT_NEAR(NormalCumulative(-8) / 6.220960574271785e-16, 1, 1e-12);
  EXPECT_NEAR(NormalQuantile(NormalCumulative(-8)), -8, 1e-12);
}

// Tables of Student's t: Abramowitz and Stegun 1964, table 26.10.
TEST(Student, HasThePublishedQuantiles) {
  EXPECT_NEAR(StudentCritical(1, 0.95), 12.706, 5e-4);
  EXPECT_NEAR(StudentCritical(2, 0.99), 9.925, 5e-4);
  EXPECT_NEAR(StudentCritical(5, 0.90), 2.015, 5e-4);
  EXPECT_NEAR(StudentCritical(30, 0.95), 2.042, 5e-4);
  EXPECT_NEAR(StudentCritical(120, 0.99), 2.617, 5e-4);
}

TEST(Student, IsTheCauchyDistributionAtOneDegree) {
  for (const double confidence : {0.1, 0.5, 0.95, 0.999999}) {
    const double exact = std::tan(confidence * std::numbers::pi / 2);
    EXPECT_NEAR(StudentCritical(1, confidence) / exact, 1, 1e-9) << confidence;
  }
}

TEST(Student, IsTheNormalDistributionAtManyDegrees) {
  EXPECT_NEAR(StudentCritical(1e9, 0.95), NormalQuantile(0.975), 1e-6);
}

TEST(Student, IsTheIntegralOfItsDensity) {
  for (const double degrees : {1.0, 3.5, 20.0}) {
    const double scale = std::exp(std::lgamma((degrees + 1) / 2) - std::lgamma(degrees / 2)) /
                         std::sqrt(degrees * std::numbers::pi);
    const double half = IntegralOf(
        [&](double t) { return scale * std::pow(1 + t * t / degrees, -(degrees + 1) / 2); }, 0,
        1.7);
    EXPECT_NEAR(StudentCumulative(degrees, 1.7), 0.5 + half, 1e-10) << degrees;
    EXPECT_NEAR(StudentCumulative(degrees, -1.7), 0.5 - half, 1e-10) << degrees;
  }
}

TEST(Student, KnowsItsEnds) {
  EXPECT_EQ(StudentCritical(5, 0), 0);
  EXPECT_EQ(StudentCritical(5, 1), kInfinite);
  EXPECT_EQ(StudentTwoSidedTail(5, kInfinite), 0);
  EXPECT_EQ(StudentTwoSidedTail(5, 0), 1);
}

TEST(Beta, IsTheIntegralOfItsDensity) {
  for (const auto& [a, b, x] :
       {std::array{2.0, 3.0, 0.4}, std::array{50.5, 7.0, 0.9}, std::array{1000.0, 3000.0, 0.24}}) {
    const double integral =
        IntegralOf([&, a = a, b = b](double t) { return BetaDensity(a, b, t); }, 1e-12, x);
    EXPECT_NEAR(RegularizedBeta(a, b, x), integral, 1e-9) << a << " " << b;
  }
}

TEST(Beta, IsAccurateForAMillionTrials) {
  constexpr double kA = 500'001;
  constexpr double kB = 500'000;
  for (const double x : {0.4985, 0.5, 0.5005}) {
    const double integral = IntegralOf([](double t) { return BetaDensity(kA, kB, t); }, 0.49, x);
    EXPECT_NEAR(RegularizedBeta(kA, kB, x), integral, 1e-7);
  }
}

TEST(Beta, KnowsItsEnds) {
  EXPECT_EQ(RegularizedBeta(2, 3, 0), 0);
  EXPECT_EQ(RegularizedBeta(2, 3, -1), 0);
  EXPECT_EQ(RegularizedBeta(2, 3, 1), 1);
  EXPECT_TRUE(std::isnan(RegularizedBeta(2, 3, std::nan(""))));
}

TEST(BetaQuantile, InvertsTheDistribution) {
  for (const double p : {1e-9, 0.025, 0.5, 0.975}) {
    EXPECT_NEAR(RegularizedBeta(3, 18, BetaQuantile(3, 18, p)) / p, 1, 1e-9) << p;
  }
  EXPECT_NEAR(BetaQuantile(1, 10, 0.3), 1 - std::pow(0.7, 0.1), 1e-14) << "its closed form";
}

TEST(Binomial, IsTheSumOfItsTerms) {
  double sum = 0;
  for (int k = 0; k <= 12; ++k) {
    sum += std::exp(std::lgamma(13.0) - std::lgamma(k + 1.0) - std::lgamma(13.0 - k)) *
           std::pow(0.3, k) * std::pow(0.7, 12 - k);
    EXPECT_NEAR(BinomialCumulative(k, 12, 0.3), sum, 1e-12) << k;
  }
  EXPECT_EQ(BinomialCumulative(-1, 12, 0.3), 0);
  EXPECT_EQ(BinomialCumulative(0, 0, 0.3), 1);
}

}  // namespace shoal
