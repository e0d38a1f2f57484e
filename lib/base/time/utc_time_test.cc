#include "lib/base/time/utc_time.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace shoal::utc_time_test {

constexpr int64_t kSecond_us = 1'000'000;

TEST(UtcTime, KnowsDaysThatOthersKnow) {
  EXPECT_EQ(ToUtc({}), 0);
  EXPECT_EQ(ToUtc({.year = 2000, .month = 3, .day = 1}), 951'868'800 * kSecond_us);
  EXPECT_EQ(ToUtc({.year = 2009, .month = 2, .day = 13, .hour = 23, .minute = 31, .second = 30}),
            1'234'567'890 * kSecond_us);
  EXPECT_EQ(ToUtc({.year = 2100, .month = 3, .day = 1}), 4'107'542'400 * kSecond_us);
  EXPECT_EQ(ToCalendar(-1), (CalendarTime{.year = 1969,
                                          .month = 12,
                                          .day = 31,
                                          .hour = 23,
                                          .minute = 59,
                                          .second = 59,
                                          .microsecond = 999'999}));
  EXPECT_EQ(ToCalendar(1'709'164'800 * kSecond_us),
            (CalendarTime{.year = 2024, .month = 2, .day = 29}));
}

TEST(UtcTime, KnowsNoDaysAndTimesThatDoNotExist) {
  const CalendarTime wrong[] = {{.year = 1969},
                                {.year = 2200},
                                {.month = 0},
                                {.month = 13},
                                {.day = 0},
                                {.day = 32},
                                {.month = 4, .day = 31},
                                {.year = 2026, .month = 2, .day = 29},
                                {.year = 2100, .month = 2, .day = 29},
                                {.hour = 24},
                                {.minute = 60},
                                {.second = 61},
                                {.microsecond = 1'000'000}};
  for (const CalendarTime& time : wrong) {
    EXPECT_FALSE(ToUtc(time)) << time.year << " " << time.month << " " << time.day;
  }
  EXPECT_EQ(ToUtc({.second = 60}), 60 * kSecond_us);
}

RC_GTEST_PROP(UtcTimeProperty, ComesBackAsItWas, ()) {
  const int64_t utc_us = *rc::gen::inRange<int64_t>(0, 7'258'118'400 * kSecond_us);
  RC_ASSERT(ToUtc(ToCalendar(utc_us)) == utc_us);
  RC_ASSERT(ParseIsoTime(IsoTimeText(utc_us)) == utc_us / kSecond_us * kSecond_us);
}

TEST(UtcTime, KnowsTheTimeOfDayAtBothEndsOfInt64) {
  // The years lie outside std::chrono's; the times of day are those of Python's integers.
  for (const int64_t later_us : {0, 1, 224'191, 224'192}) {
    const CalendarTime first = ToCalendar(std::numeric_limits<int64_t>::min() + later_us);
    EXPECT_EQ(first.year, -32'767);
    EXPECT_EQ(first.hour, 19);
    EXPECT_EQ(first.minute, 59);
    EXPECT_EQ(first.second, 5);
    EXPECT_EQ(first.microsecond, 224'192 + later_us);
  }
  const CalendarTime last = ToCalendar(std::numeric_limits<int64_t>::max());
  EXPECT_EQ(last.year, 32'767);
  EXPECT_EQ(last.hour, 4);
  EXPECT_EQ(last.minute, 0);
  EXPECT_EQ(last.second, 54);
  EXPECT_EQ(last.microsecond, 775'807);
}

RC_GTEST_PROP(UtcTimeProperty, IsADateOfItsMonthAtAnyTime, ()) {
  const auto time = ToCalendar(*rc::gen::arbitrary<int64_t>());
  RC_ASSERT(time.month >= 1 && time.month <= 12 && time.day >= 1 && time.day <= 31);
  RC_ASSERT(time.hour >= 0 && time.hour < 24 && time.microsecond >= 0);
}

TEST(ClockText, CutsDecimalsOff) {
  const int64_t utc_us = *ToUtc({.hour = 1, .minute = 2, .second = 3, .microsecond = 987'654});
  EXPECT_EQ(ClockText(utc_us), "010203");
  EXPECT_EQ(ClockText(utc_us, 2), "010203.98");
  EXPECT_EQ(ClockText(utc_us, 4), "010203.9876");
}

TEST(IsoTime, IsReadInOneFormOnly) {
  EXPECT_EQ(ParseIsoTime("1970-01-01T00:01:00Z"), 60 * kSecond_us);
  for (const char* text : {"", "1970-01-01T00:01:00", "1970-01-01 00:01:00Z", "1970-1-1T0:1:0Z",
                           "1970-02-30T00:01:00Z", "+970-01-01T00:01:00Z"}) {
    EXPECT_FALSE(ParseIsoTime(text)) << text;
  }
}

}  // namespace shoal::utc_time_test
