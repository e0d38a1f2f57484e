#include "lib/run/moos_text/numbers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <system_error>

#include "lib/base/text/numbers.h"

namespace shoal::numbers_test {

constexpr int64_t kMin = std::numeric_limits<int64_t>::min();
constexpr int64_t kMax = std::numeric_limits<int64_t>::max();

RC_GTEST_PROP(SecondsText, HoldsAllMicrosecondsWithoutATrailingZero, (int64_t utime)) {
  const std::string text = SecondsText(utime);
  const size_t point = text.find('.');
  std::string micros = text.substr(0, point);
  std::string decimals = point == std::string::npos ? "" : text.substr(point + 1);
  RC_ASSERT(decimals.size() <= 6U && (point == std::string::npos) == decimals.empty());
  RC_ASSERT(decimals.empty() || decimals.back() != '0');
  micros += decimals + std::string(6 - decimals.size(), '0');
  int64_t again = 0;
  const auto [stop, error] = std::from_chars(micros.data(), micros.data() + micros.size(), again);
  RC_ASSERT(error == std::errc() && stop == micros.data() + micros.size());
  RC_ASSERT(again == utime);
}

TEST(SecondsText, HasNoMoreDigitsThanNeeded) {
  EXPECT_EQ(SecondsText(0), "0");
  EXPECT_EQ(SecondsText(12'300'000), "12.3");
  EXPECT_EQ(SecondsText(-1), "-0.000001");
  EXPECT_EQ(SecondsText(1'252'348'077'590'001), "1252348077.590001");
  EXPECT_EQ(SecondsText(kMin), "-9223372036854.775808");
  EXPECT_EQ(SecondsText(kMax), "9223372036854.775807");
}

RC_GTEST_PROP(NumberText, ReadsBackAsTheSameNumber, (double number)) {
  RC_PRE(std::isfinite(number));
  const auto again = NumberIn(NumberText(number));
  RC_ASSERT(again.has_value());
  RC_ASSERT(*again == number);
  RC_ASSERT(std::signbit(*again) == std::signbit(number));
}

TEST(ParseNumber, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"", "nan", "inf", "-inf", "1e999", "+-1", "1,5", "5m", "0x10", "1 2"}) {
    EXPECT_EQ(NumberIn(text), std::nullopt) << text;
  }
  EXPECT_EQ(NumberIn(" +1.5\t"), std::optional(1.5));
}

}  // namespace shoal::numbers_test
