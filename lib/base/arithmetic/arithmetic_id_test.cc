#include "lib/base/arithmetic/arithmetic_id.h"

#include <gtest/gtest.h>

namespace shoal::arithmetic_id_test {

// The same on every processor. It changes only with the functions of vendor/musl or with what is
// digested; then logs change too, and CHANGELOG.md states it.
TEST(ArithmeticId, IsThatOfThisVersion) { EXPECT_EQ(ArithmeticId(), "447ee7f6e820c757"); }

TEST(BitsDigest, DiffersByOneBitOfOneNumber) {
  BitsDigest one;
  BitsDigest other;
  one.Add(1);
  other.Add(1 + 0x1p-52);
  EXPECT_NE(one.value(), other.value());
}

TEST(BitsDigest, KeepsZerosOfBothSignsApart) {
  BitsDigest positive;
  BitsDigest negative;
  positive.Add(0.0);
  negative.Add(-0.0);
  EXPECT_NE(positive.value(), negative.value());
}

// The published first output of SplitMix64 from 0 is 0xe220a8397b1dcdaf.
TEST(FixedSequence, IsSplitMix64) {
  EXPECT_EQ(FixedSequence(0).Next(), static_cast<double>(0xe220a8397b1dcdafU >> 11U) * 0x1p-53);
}

}  // namespace shoal::arithmetic_id_test
