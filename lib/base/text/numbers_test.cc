#include "lib/base/text/numbers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstring>
#include <limits>

namespace shoal::numbers_test {

TEST(ReadNumber, TakesTheWholeTextOrNothing) {
  EXPECT_EQ(ReadNumber<double>("-0.5"), -0.5);
  EXPECT_EQ(ReadNumber<double>("+1e3"), 1000);
  EXPECT_EQ(ReadNumber<int>("+7"), 7);
  for (const char* text : {"", "+", "-", "+-5", "-+5", "--5", "5 ", " 5", "5x", "0x10", "1,5",
                           "nan", "inf", "-inf", "1e999"}) {
    EXPECT_FALSE(ReadNumber<double>(text)) << text;
  }
}

TEST(ReadNumber, RefusesWhatDoesNotFitTheType) {
  EXPECT_FALSE(ReadNumber<int8_t>("128"));
  EXPECT_EQ(ReadNumber<int8_t>("-128"), -128);
  EXPECT_FALSE(ReadNumber<size_t>("-1"));
  EXPECT_FALSE(ReadNumber<int>("1.0"));
}

RC_GTEST_PROP(ShortestText, ReadsBackAsTheSameBits, ()) {
  const auto bits = *rc::gen::arbitrary<uint64_t>();
  double number = 0;
  std::memcpy(&number, &bits, sizeof number);
  RC_PRE(std::isfinite(number));
  const std::optional<double> read = ReadNumber<double>(ShortestText(number));
  RC_ASSERT(read.has_value());
  RC_ASSERT(std::memcmp(&*read, &number, sizeof number) == 0);
}

TEST(ZeroPadded, FillsUpBehindTheSignAndCutsNothingOff) {
  EXPECT_EQ(ZeroPadded(7, 3), "007");
  EXPECT_EQ(ZeroPadded(-7, 3), "-07");
  EXPECT_EQ(ZeroPadded(12345, 3), "12345");
}

}  // namespace shoal::numbers_test
