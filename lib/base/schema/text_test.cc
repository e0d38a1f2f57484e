#include "lib/base/schema/text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lcmtypes/lcm_sources.h"
#include "shoal/comms_fates_t.hpp"

namespace shoal::text_test {

std::string Text(const Scalar& value) {
  std::string text;
  AppendScalar(value, &text);
  return text;
}

std::string Quoted(std::string_view value) {
  std::string text;
  AppendQuoted(value, &text);
  return text;
}

std::string Seconds(int64_t utime) {
  std::string text;
  AppendSeconds(utime, &text);
  return text;
}

template <class T>
std::string TextOf(const T& message, std::string_view skip) {
  std::vector<LcmSource> sources;
  for (const std::string_view text : LcmSources())
    sources.push_back({"lcmtypes", std::string(text)});
  const auto schema = Schema::Build(sources);
  std::vector<uint8_t> bytes(static_cast<size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return MessageText(*schema, *schema->FindByFingerprint(T::getHash()), bytes, skip);
}

TEST(AppendScalar, WritesNumbersAsShortAsTheyReadBack) {
  EXPECT_EQ(Text(0.1), "0.1");
  EXPECT_EQ(Text(0.1F), "0.1");
  EXPECT_EQ(Text(1e300), "1e+300");
  EXPECT_EQ(Text(-0.0), "-0");
  EXPECT_EQ(Text(std::nan("")), "nan");
  EXPECT_EQ(Text(-std::nan("")), "nan");
  EXPECT_EQ(Text(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(Text(std::numeric_limits<int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(Text(true), "true");
}

RC_GTEST_PROP(AppendScalar, LosesNothingOfADouble, (double value)) {
  RC_ASSERT(std::stod(Text(value)) == value);
}

TEST(AppendQuoted, QuotesOnlyWhatWouldMislead) {
  EXPECT_EQ(Quoted("alpha-1"), "alpha-1");
  EXPECT_EQ(Quoted(""), "\"\"");
  EXPECT_EQ(Quoted("a b"), "\"a b\"");
  EXPECT_EQ(Quoted("a=1"), "\"a=1\"");
  EXPECT_EQ(Quoted("\"\\"), R"("\"\\")");
  EXPECT_EQ(Quoted("a\nb\x1b[2J"), R"("a\nb\x1b[2J")");
  EXPECT_EQ(Quoted("\xc2\x9b"
                   "2J"),
            R"("\xc2\x9b2J")");
  EXPECT_EQ(Quoted("M\xc3\xb6we"), "M\xc3\xb6we");
}

TEST(AppendSeconds, WritesMillisecondsAndMicrosecondsWhereTheyMatter) {
  EXPECT_EQ(Seconds(0), "0.000");
  EXPECT_EQ(Seconds(12'300'000), "12.300");
  EXPECT_EQ(Seconds(12'300'001), "12.300001");
  EXPECT_EQ(Seconds(-500'000), "-0.500");
  EXPECT_EQ(Seconds(std::numeric_limits<int64_t>::min()), "-9223372036854.775808");
}

TEST(MessageText, ShowsNestedArraysAndLeavesOutTheirLengths) {
  comms_fates_t fates{};
  fates.utime = 5;
  fates.num_fates = 2;
  fates.fates.resize(2);
  fates.fates[0].kind = "report";
  fates.fates[0].range_m = 12.5;
  EXPECT_EQ(TextOf(fates, "utime"),
            "fates=[{kind=report source=\"\" destination=\"\" count=0 number=0 cause=\"\" "
            "override_rule=\"\" range_m=12.5 limit_m=0 age_s=0 age_limit_s=0 wait_s=0 loss_pct=0 "
            "length_bytes=0 length_limit_bytes=0 path=[]} {kind=\"\" source=\"\" destination=\"\" "
            "count=0 "
            "number=0 cause=\"\" override_rule=\"\" range_m=0 limit_m=0 age_s=0 age_limit_s=0 "
            "wait_s=0 loss_pct=0 length_bytes=0 length_limit_bytes=0 path=[]}]");
}

TEST(MessageText, ShowsEmptyArraysAndAllMembersButTheOneToSkip) {
  comms_fates_t fates{};
  fates.utime = 5;
  EXPECT_EQ(TextOf(fates, ""), "utime=5 fates=[]");
  EXPECT_EQ(TextOf(fates, "fates"), "utime=5");
}

}  // namespace shoal::text_test
