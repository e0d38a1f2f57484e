#include "lib/mission/toml/table_writer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <variant>

#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/table_reader.h"

namespace shoal::table_writer_test {

double ReadBack(const std::string& number) {
  const auto value = ParseTomlValue(number, {});
  if (!value) return std::numeric_limits<double>::quiet_NaN();
  if (const auto* integer = std::get_if<int64_t>(&value->data)) {
    return static_cast<double>(*integer);
  }
  return std::get<double>(value->data);
}

TEST(TomlNumber, IsAsShortAsItCanBe) {
  EXPECT_EQ(TomlNumber(5), "5");
  EXPECT_EQ(TomlNumber(0.1), "0.1");
  EXPECT_EQ(TomlNumber(-70.3304), "-70.3304");
  EXPECT_EQ(TomlNumber(-0.0), "-0.0");
}

RC_GTEST_PROP(TomlNumber, ReadsBackToTheBit, (uint64_t bits)) {
  double number = 0;
  std::memcpy(&number, &bits, sizeof number);
  RC_PRE(std::isfinite(number));
  const double back = ReadBack(TomlNumber(number));
  RC_ASSERT(back == number);
  RC_ASSERT(std::signbit(back) == std::signbit(number));
}

TEST(TomlNumber, ReadsBackAtTheLimits) {
  using Limits = std::numeric_limits<double>;
  for (const double number : {Limits::max(), Limits::min(), Limits::denorm_min(), 1e15, 1e16, 1e18,
                              9223372036854775808.0, 12345678901234567890.0, 1e19, 1e22}) {
    EXPECT_EQ(ReadBack(TomlNumber(number)), number);
  }
}

RC_GTEST_PROP(TomlString, ReadsBackAnyText, ()) {
  // Any sequence of ASCII characters, the control characters with them.
  const auto text = *rc::gen::container<std::string>(rc::gen::inRange<char>(0, 127));
  const auto value = ParseTomlValue(TomlString(text), {});
  RC_ASSERT(value.has_value());
  RC_ASSERT(std::get<std::string>(value->data) == text);
}

std::string Written(std::string word) {
  TableWriter writer;
  writer.Scalar("value", word);
  return writer.TakeText();
}

TEST(Scalar, WritesNumbersAndYesOrNoBareAndWordsInQuotes) {
  EXPECT_EQ(Written("true"), "value = true\n");
  EXPECT_EQ(Written("-2.5e-07"), "value = -2.5e-07\n");
  EXPECT_EQ(Written("nolimit"), "value = \"nolimit\"\n");
  EXPECT_EQ(Written(""), "value = \"\"\n");
  EXPECT_EQ(Written("inf"), "value = \"inf\"\n");
}

TEST(Scalar, WritesAWholeNumberThatIsTooLargeForTomlWithAFraction) {
  EXPECT_EQ(Written("123456789012345680000"), "value = 123456789012345680000.0\n");
  EXPECT_EQ(Written("123456789012345678"), "value = 123456789012345678\n");
}

std::string ReadBackScalar(const std::string& value) {
  const auto table = ParseTomlValue("{value = " + value + "}", {});
  if (!table) return "(no TOML)";
  Problems problems("", {});
  std::string word = "(unchanged)";
  TableReader(*table, "table", problems).Scalar("value", word);
  return problems.empty() ? word : problems.InOrder().front();
}

TEST(Scalar, ReadsEveryFieldWithOneValue) {
  EXPECT_EQ(ReadBackScalar("true"), "true");
  EXPECT_EQ(ReadBackScalar("2"), "2");
  EXPECT_EQ(ReadBackScalar("0.25"), "0.25");
  EXPECT_EQ(ReadBackScalar("'nolimit'"), "nolimit");
  EXPECT_NE(ReadBackScalar("[2]").find("value must be a number, true or false, or a string"),
            std::string::npos);
  EXPECT_NE(ReadBackScalar("2020-01-01").find("not a date or time"), std::string::npos);
}

}  // namespace shoal::table_writer_test
