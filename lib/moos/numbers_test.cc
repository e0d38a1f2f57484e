#include "lib/moos/numbers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace shoal {
namespace {

constexpr int64_t kMin = std::numeric_limits<int64_t>::min();
constexpr int64_t kMax = std::numeric_limits<int64_t>::max();

RC_GTEST_PROP(SecondsText, ReadsBackAsTheSameMicroseconds, (int64_t utime)) {
  RC_ASSERT(ParseSeconds(SecondsText(utime)) == std::optional(utime));
}

TEST(SecondsText, HasNoMoreDigitsThanNeeded) {
  EXPECT_EQ(SecondsText(0), "0");
  EXPECT_EQ(SecondsText(12'300'000), "12.3");
  EXPECT_EQ(SecondsText(-1), "-0.000001");
  EXPECT_EQ(SecondsText(1'252'348'077'590'001), "1252348077.590001");
}

TEST(ParseSeconds, KeepsTheEndsOfTheRangeAndRefusesWhatIsBeyond) {
  EXPECT_EQ(ParseSeconds(SecondsText(kMin)), std::optional(kMin));
  EXPECT_EQ(ParseSeconds(SecondsText(kMax)), std::optional(kMax));
  EXPECT_EQ(ParseSeconds("9223372036854.775808"), std::nullopt);
  EXPECT_EQ(ParseSeconds("-9223372036854.775809"), std::nullopt);
  EXPECT_EQ(ParseSeconds(std::string(1000, '9')), std::nullopt);
  EXPECT_EQ(ParseSeconds("18446744073709.5516155"), std::nullopt);
}

TEST(ParseSeconds, RoundsBelowAMicrosecond) {
  EXPECT_EQ(ParseSeconds("1.0000004"), std::optional<int64_t>(1'000'000));
  EXPECT_EQ(ParseSeconds("1.0000005"), std::optional<int64_t>(1'000'001));
  EXPECT_EQ(ParseSeconds("1.9999999"), std::optional<int64_t>(2'000'000));
  EXPECT_EQ(ParseSeconds("1.00000049999"), std::optional<int64_t>(1'000'000));
}

TEST(ParseSeconds, TakesOtherWritingsOfANumber) {
  EXPECT_EQ(ParseSeconds(" +1.5 "), std::optional<int64_t>(1'500'000));
  EXPECT_EQ(ParseSeconds("1.5e3"), std::optional<int64_t>(1'500'000'000));
  EXPECT_EQ(ParseSeconds(".5"), std::optional<int64_t>(500'000));
  EXPECT_EQ(ParseSeconds("5."), std::optional<int64_t>(5'000'000));
}

TEST(ParseSeconds, RefusesWhatIsNoNumber) {
  for (const char* text : {"", ".", "-", "+-1", "--1", "1.2.3", "1 2", "nan", "inf", "1e99", "x"}) {
    EXPECT_EQ(ParseSeconds(text), std::nullopt) << text;
  }
}

RC_GTEST_PROP(NumberText, ReadsBackAsTheSameNumber, (double number)) {
  RC_PRE(std::isfinite(number));
  const auto again = ParseNumber(NumberText(number));
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == number);
  RC_ASSERT(std::signbit(*again) == std::signbit(number));
}

TEST(ParseNumber, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", "nan", "inf", "-inf", "1e999", "+-1", "1,5", "5m", "0x10", "1 2"}) {
    EXPECT_EQ(ParseNumber(text), std::nullopt) << text;
  }
  EXPECT_EQ(ParseNumber(" +1.5\t"), std::optional(1.5));
}

}  // namespace
}  // namespace shoal
