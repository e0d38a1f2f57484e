#include "lib/sea/acoustics/propagation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace shoal::propagation_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(TransmissionLoss, IsSpreadingAndAbsorption) {
  EXPECT_NEAR(TransmissionLoss(1000, 2, 0), 60, 1e-12);
  EXPECT_NEAR(TransmissionLoss(1000, 1, 0), 30, 1e-12);
  EXPECT_NEAR(TransmissionLoss(1000, 1.5, 5), 50, 1e-12);
  EXPECT_NEAR(TransmissionLoss(2000, 2, 5), 66.0206 + 10, 1e-4);
}

TEST(TransmissionLoss, IsTheHalvingRuleOfSphericalSpreading) {
  // 6 dB per doubling of the distance (Urick, ch. 5).
  EXPECT_NEAR(TransmissionLoss(200, 2, 0) - TransmissionLoss(100, 2, 0), 6.0206, 1e-4);
}

TEST(TransmissionLoss, HasNoSpreadingWithinAMetre) {
  EXPECT_EQ(TransmissionLoss(0, 2, 10), 0);
  EXPECT_EQ(TransmissionLoss(1, 2, 0), 0);
  EXPECT_NEAR(TransmissionLoss(0.5, 2, 10), 0.005, 1e-15);
}

TEST(TransmissionLoss, IsInfiniteWhereItsArgumentsAreInvalid) {
  EXPECT_EQ(TransmissionLoss(kInfinity, 2, 0), kInfinity);
  EXPECT_EQ(TransmissionLoss(kInfinity, 0, 0), kInfinity);
  EXPECT_EQ(TransmissionLoss(0, 2, kInfinity), kInfinity);
  for (const double nonsense : {kNaN, -1.0, -kInfinity}) {
    EXPECT_EQ(TransmissionLoss(nonsense, 2, 1), kInfinity);
    EXPECT_EQ(TransmissionLoss(100, nonsense, 1), kInfinity);
    EXPECT_EQ(TransmissionLoss(100, 2, nonsense), kInfinity);
  }
}

TEST(SignalToNoise, IsThePassiveSonarEquation) { EXPECT_EQ(SignalToNoise(185, 60, 80), 45); }

TEST(SignalToNoise, IsNoneWhereItIsNotANumber) {
  EXPECT_EQ(SignalToNoise(185, kInfinity, 80), -kInfinity);
  EXPECT_EQ(SignalToNoise(kInfinity, kInfinity, 80), -kInfinity);
  EXPECT_EQ(SignalToNoise(kNaN, 60, 80), -kInfinity);
}

RC_GTEST_PROP(TransmissionLoss, NeverFallsWithRangeAndIsContinuous, ()) {
  const double exponent = *rc::gen::inRange(5, 40) / 10.0;
  const double absorption = *rc::gen::inRange(0, 1000) / 10.0;
  const double range_m = *rc::gen::inRange(0, 20'000'000) / 1000.0;
  const double here = TransmissionLoss(range_m, exponent, absorption);
  RC_ASSERT(here >= 0);
  const double farther = TransmissionLoss(range_m + 0.001, exponent, absorption);
  RC_ASSERT(farther >= here);
  RC_ASSERT(farther - here < 0.02);
}

}  // namespace shoal::propagation_test
