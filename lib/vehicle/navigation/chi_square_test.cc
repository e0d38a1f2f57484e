#include "lib/vehicle/navigation/chi_square.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shoal::chi_square_test {

// Closed forms: one degree is a squared normal variable, two are exponential.
TEST(ChiSquare, IsTheClosedFormForOneAndTwoDegrees) {
  for (const double value : {1e-6, 0.1, 1.0, 3.0, 10.0, 40.0}) {
    EXPECT_NEAR(ChiSquareCumulative(1, value), std::erf(std::sqrt(value / 2)), 1e-14) << value;
    EXPECT_NEAR(ChiSquareCumulative(2, value), -std::expm1(-value / 2), 1e-14) << value;
  }
}

// Abramowitz and Stegun, 1964, table 26.8: values exceeded with probability 0.95, 0.05, 0.001.
TEST(ChiSquare, IsThatOfTheTables) {
  EXPECT_NEAR(ChiSquareQuantile(3, 0.95), 7.81473, 5e-6);
  EXPECT_NEAR(ChiSquareQuantile(3, 0.999), 16.266, 5e-4);
  EXPECT_NEAR(ChiSquareQuantile(10, 0.05), 3.94030, 5e-6);
  EXPECT_NEAR(ChiSquareQuantile(10, 0.95), 18.3070, 5e-5);
  EXPECT_NEAR(ChiSquareQuantile(100, 0.95), 124.342, 5e-4);
  EXPECT_NEAR(ChiSquareQuantile(100, 0.05), 77.9295, 5e-5);
}

// Wilson and Hilferty, 1931: the cube root of value / degrees is nearly normal.
TEST(ChiSquare, IsNearlyThatOfWilsonAndHilfertyForManyDegrees) {
  const int degrees = 12'000;
  const double part = 2.0 / (9 * degrees);
  const double expected = degrees * std::pow(1 - part + 3.290527 * std::sqrt(part), 3);
  EXPECT_NEAR(ChiSquareQuantile(degrees, 0.9995), expected, 1e-2);
}

TEST(ChiSquare, HasQuantilesThatAreTheInverse) {
  for (const int degrees : {1, 2, 3, 7, 2000}) {
    for (const double probability : {0.0005, 0.5, 0.999}) {
      EXPECT_NEAR(ChiSquareCumulative(degrees, ChiSquareQuantile(degrees, probability)),
                  probability, 1e-10);
    }
  }
}

TEST(ChiSquare, IsZeroUpToZero) {
  EXPECT_EQ(ChiSquareCumulative(3, 0), 0);
  EXPECT_EQ(ChiSquareCumulative(3, -1), 0);
  EXPECT_EQ(ChiSquareQuantile(3, 0), 0);
}

}  // namespace shoal::chi_square_test
