#include "lib/sea/acoustics/modulation_code.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace shoal::modulation_code_test {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr BlockCode kHamming = {.block_bits = 7, .data_bits = 4, .corrected_bits = 1};
constexpr BlockCode kGolay = {.block_bits = 23, .data_bits = 12, .corrected_bits = 3};

/// All patterns of wrong bits in a block, one by one.
double BlockErrorRateByEnumeration(double p, const BlockCode& code) {
  double rate = 0;
  for (unsigned pattern = 0; pattern < (1U << code.block_bits); ++pattern) {
    int wrong = 0;
    double probability = 1;
    for (int bit = 0; bit < code.block_bits; ++bit) {
      const bool is_wrong = (pattern >> bit & 1U) != 0;
      wrong += is_wrong ? 1 : 0;
      probability *= is_wrong ? p : 1 - p;
    }
    if (wrong > code.corrected_bits) rate += probability;
  }
  return rate;
}

TEST(PacketErrorRate, WithoutACodeIsThatAnyBitIsWrong) {
  EXPECT_NEAR(PacketErrorRate(1e-3, 37), 1 - std::pow(1 - 1e-3, 296), 1e-12);
  EXPECT_NEAR(PacketErrorRate(1e-12, 1000), 8e-9, 1e-13);
}

TEST(PacketErrorRate, IsNoneForNoBytesAndForNoErrors) {
  EXPECT_EQ(PacketErrorRate(0.5, 0), 0);
  EXPECT_EQ(PacketErrorRate(0.5, 0, kGolay), 0);
  EXPECT_EQ(PacketErrorRate(0, 1000), 0);
  EXPECT_EQ(PacketErrorRate(0, 1000, kGolay), 0);
}

TEST(PacketErrorRate, IsThatOfAllItsBlocks) {
  // 37 bytes are 296 bits: 25 Golay blocks of 12.
  const double block = BlockErrorRate(0.01, kGolay);
  EXPECT_NEAR(PacketErrorRate(0.01, 37, kGolay), 1 - std::pow(1 - block, 25), 1e-12);
}

TEST(PacketErrorRate, IsOneForGiantPackets) {
  EXPECT_EQ(PacketErrorRate(0.01, UINT64_MAX), 1);
  EXPECT_EQ(PacketErrorRate(0.01, UINT64_MAX, kGolay), 1);
}

TEST(BlockErrorRate, IsThatOfAllPatternsOfWrongBits) {
  for (const BlockCode& code :
       {BlockCode{}, kHamming, BlockCode{.block_bits = 15, .data_bits = 5, .corrected_bits = 3}}) {
    for (const double p : {0.001, 0.01, 0.1, 0.3, 0.5}) {
      const double enumerated = BlockErrorRateByEnumeration(p, code);
      EXPECT_NEAR(BlockErrorRate(p, code) / enumerated, 1, 1e-9) << code.block_bits << " " << p;
    }
  }
}

TEST(BlockErrorRate, OfTheGolayCodeHasThePublishedLeadingTerm) {
  // C(23, 4) p^4 = 8855 p^4 (Proakis, Digital Communications, section 8.1).
  EXPECT_NEAR(BlockErrorRate(1e-5, kGolay) / (8855 * 1e-20), 1, 1e-3);
}

TEST(BlockErrorRate, OfTheLargestBlockIsANumberInRange) {
  const BlockCode largest = {.block_bits = 1023, .data_bits = 11, .corrected_bits = 255};
  ASSERT_EQ(ProblemOf(largest), "");
  EXPECT_NEAR(BlockErrorRate(0.5, largest), 1, 1e-12);
  EXPECT_NEAR(BlockErrorRate(0.25, largest), 0.5, 0.1);
  EXPECT_LT(BlockErrorRate(0.1, largest), 1e-30);
}

TEST(BlockErrorRate, TakesInvalidInputForTheWorst) {
  EXPECT_EQ(BlockErrorRate(kNaN, kGolay), BlockErrorRate(0.5, kGolay));
  EXPECT_EQ(BlockErrorRate(2, kGolay), BlockErrorRate(0.5, kGolay));
  EXPECT_EQ(BlockErrorRate(-1, kGolay), 0);
}

TEST(BlockCode, IsPossibleWhereItsKindIsKnown) {
  for (const BlockCode& code : std::vector<BlockCode>{{},
                                                      {7, 4, 1},    // Hamming, perfect
                                                      {23, 12, 3},  // Golay, perfect
                                                      {24, 12, 3},  // Golay, extended
                                                      {3, 1, 1},    // repetition, perfect
                                                      {63, 36, 5},  // BCH
                                                      {127, 64, 10},
                                                      {127, 92, 5},
                                                      {255, 131, 18},
                                                      {1023, 513, 57}}) {
    EXPECT_EQ(ProblemOf(code), "") << code.block_bits;
  }
}

TEST(BlockCode, IsImpossibleBeyondHammingsBound) {
  EXPECT_EQ(ProblemOf({7, 4, 2}),
            "no code of 7 bits with 4 data bits corrects 2 errors: there are 3 check bits, and "
            "distinguishing the error patterns takes 5");
  EXPECT_NE(ProblemOf({23, 12, 4}), "");
  EXPECT_NE(ProblemOf({1, 1, 1}), "");
}

TEST(BlockCode, IsImpossibleWhereItsNumbersAre) {
  EXPECT_EQ(ProblemOf({0, 0, 0}), "a block of 0 bits; allowed: 1 to 1023");
  EXPECT_EQ(ProblemOf({1024, 4, 1}), "a block of 1024 bits; allowed: 1 to 1023");
  EXPECT_EQ(ProblemOf({7, 8, 0}), "8 data bits in a block of 7 bits; allowed: 1 to 7");
  EXPECT_EQ(ProblemOf({7, 0, 0}), "0 data bits in a block of 7 bits; allowed: 1 to 7");
  EXPECT_EQ(ProblemOf({7, 4, -1}), "-1 corrected bits in a block of 7 bits; allowed: 0 to 7");
  EXPECT_EQ(ProblemOf({7, 4, 8}), "8 corrected bits in a block of 7 bits; allowed: 0 to 7");
}

RC_GTEST_PROP(PacketErrorRate, RisesWithErrorsAndLengthAndFallsWithCorrection, ()) {
  const double p = *rc::gen::inRange(0, 4999) / 1e4;
  const uint64_t bytes = *rc::gen::inRange<uint64_t>(1, 2000);
  const BlockCode weaker = {.block_bits = 63, .data_bits = 36, .corrected_bits = 4};
  const BlockCode stronger = {.block_bits = 63, .data_bits = 36, .corrected_bits = 5};
  const double rate = PacketErrorRate(p, bytes, stronger);
  RC_ASSERT(rate >= 0);
  RC_ASSERT(rate <= 1);
  RC_ASSERT(PacketErrorRate(p + 1e-4, bytes, stronger) >= rate);
  RC_ASSERT(PacketErrorRate(p, bytes + 9, stronger) >= rate);
  RC_ASSERT(PacketErrorRate(p, bytes, weaker) >= rate);
}

}  // namespace shoal::modulation_code_test
