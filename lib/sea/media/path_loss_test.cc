#include "lib/sea/media/path_loss.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace shoal::path_loss_test {

TEST(FreeSpaceLoss, Is91dBAtOneKilometreAnd900MHz) {
  // Link budgets in MHz and km: 32.45 + 20 log10(900) + 20 log10(1) = 91.53 dB.
  EXPECT_NEAR(FreeSpaceLoss_db(1000, 900), 32.4478 + 20 * std::log10(900.0), 1e-3);
}

TEST(FreeSpaceLoss, GrowsBySixDecibelsWithEachDoubledRange) {
  for (const double range_m : {1.0, 50.0, 3000.0}) {
    EXPECT_NEAR(FreeSpaceLoss_db(2 * range_m, 450) - FreeSpaceLoss_db(range_m, 450), 6.0206, 1e-4);
  }
  EXPECT_EQ(FreeSpaceLoss_db(0, 450), FreeSpaceLoss_db(1, 450)) << "nearer than 1 m counts as 1 m";
}

TEST(LogDistanceLoss, IsFreeSpaceWithExponentTwo) {
  for (const double range_m : {1.0, 10.0, 7777.0}) {
    EXPECT_NEAR(LogDistanceLoss_db(range_m, 900, 2), FreeSpaceLoss_db(range_m, 900), 1e-9);
  }
}

TEST(LogDistanceLoss, GrowsByTenTimesTheExponentPerDecade) {
  EXPECT_NEAR(LogDistanceLoss_db(5000, 900, 3.3) - LogDistanceLoss_db(500, 900, 3.3), 33, 1e-9);
}

TEST(TwoRayLoss, ContinuesFreeSpaceAtTheCrossover) {
  // 4 pi 2 m 3 m / (c / 900 MHz) = 226.35 m.
  const double crossover_m = 226.3525;
  EXPECT_NEAR(TwoRayLoss_db(crossover_m - 1e-3, 900, 2, 3),
              TwoRayLoss_db(crossover_m + 1e-3, 900, 2, 3), 1e-3);
  EXPECT_NEAR(TwoRayLoss_db(200, 900, 2, 3), FreeSpaceLoss_db(200, 900), 1e-9);
  EXPECT_GT(TwoRayLoss_db(300, 900, 2, 3), FreeSpaceLoss_db(300, 900) + 1);
}

TEST(TwoRayLoss, FallsWithTheFourthPowerOfTheRangeWhateverTheFrequency) {
  EXPECT_NEAR(TwoRayLoss_db(10'000, 900, 2, 3) - TwoRayLoss_db(1000, 900, 2, 3), 40, 1e-9);
  EXPECT_NEAR(TwoRayLoss_db(10'000, 900, 2, 3), TwoRayLoss_db(10'000, 450, 2, 3), 1e-9);
  // 40 log10(10,000) - 20 log10(6) = 144.44 dB.
  EXPECT_NEAR(TwoRayLoss_db(10'000, 900, 2, 3), 144.4370, 1e-4);
}

TEST(Reach, IsTheRangeAtWhichTheLossIsThatMuch) {
  for (const double loss_db : {50.0, 79.0, 95.0, 130.0}) {
    EXPECT_NEAR(LogDistanceLoss_db(LogDistanceReach_m(loss_db, 900, 2.7), 900, 2.7), loss_db, 1e-9);
    EXPECT_NEAR(TwoRayLoss_db(TwoRayReach_m(loss_db, 900, 2, 3), 900, 2, 3), loss_db, 1e-9);
  }
  EXPECT_EQ(LogDistanceReach_m(-20, 900, 2), 1);
  EXPECT_EQ(TwoRayReach_m(-20, 900, 2, 3), 1);
}

TEST(RadioHorizon, IsFourPointOneTwoKilometresTimesTheRootOfTheHeight) {
  // The engineer's formula for k = 4/3: 4.12 (sqrt(h1) + sqrt(h2)) km.
  EXPECT_NEAR(RadioHorizon_m(4, 9), 4120 * (2 + 3), 10);
  EXPECT_EQ(RadioHorizon_m(0, -1), 0);
  EXPECT_EQ(RadioHorizon_m(5, 0), RadioHorizon_m(0, 5));
}

TEST(TwoRayTerms, GiveTheSameBitsAsWithoutThem) {
  constexpr double kLoss_db = 120;
  constexpr double kFrequency_mhz = 900;
  const TwoRayTerms terms = TwoRayTermsOf(kLoss_db, kFrequency_mhz, 2);
  for (const double height_m : {0.0, 1.5, 2.0}) {
    for (const double other_m : {2.0, 3.0}) {
      EXPECT_EQ(TwoRayReach_m(terms, kFrequency_mhz, height_m, other_m),
                TwoRayReach_m(kLoss_db, kFrequency_mhz, height_m, other_m));
      for (double range_m = 0.5; range_m < 1e5; range_m *= 1.37) {
        EXPECT_EQ(TwoRayLoss_db(terms, range_m, kFrequency_mhz, height_m, other_m),
                  TwoRayLoss_db(range_m, kFrequency_mhz, height_m, other_m));
      }
    }
  }
}

}  // namespace shoal::path_loss_test
