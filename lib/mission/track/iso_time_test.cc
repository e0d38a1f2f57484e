#include "lib/mission/track/iso_time.h"

#include <gtest/gtest.h>

namespace shoal::iso_time_test {

TEST(IsoTime, CountsMicrosecondsSince1970) {
  EXPECT_EQ(ParseLoggedTime("1970-01-01T00:00:00Z"), 0);
  // `date -u -d 2026-11-23T09:30:00Z +%s`
  EXPECT_EQ(ParseLoggedTime("2026-11-23T09:30:00Z"), 1'795'426'200'000'000);
  EXPECT_EQ(ParseLoggedTime("2026-11-23 09:30:00"), 1'795'426'200'000'000);
  EXPECT_EQ(ParseLoggedTime("2026-11-23T09:30:00.25Z"), 1'795'426'200'250'000);
  EXPECT_EQ(ParseLoggedTime("2026-11-23T09:30:00,1234567Z"), 1'795'426'200'123'456);
}

TEST(IsoTime, TakesOffsetsFromUtc) {
  EXPECT_EQ(ParseLoggedTime("2026-11-23T10:30:00+01:00"), 1'795'426'200'000'000);
  EXPECT_EQ(ParseLoggedTime("2026-11-23T06:00:00-0330"), 1'795'426'200'000'000);
  EXPECT_EQ(ParseLoggedTime("2026-11-23T11:30:00+02"), 1'795'426'200'000'000);
}

TEST(IsoTime, KnowsTheCalendar) {
  EXPECT_TRUE(ParseLoggedTime("2024-02-29T00:00:00Z"));
  EXPECT_FALSE(ParseLoggedTime("2026-02-29T00:00:00Z"));
  EXPECT_FALSE(ParseLoggedTime("2026-13-01T00:00:00Z"));
  EXPECT_FALSE(ParseLoggedTime("2026-00-01T00:00:00Z"));
  EXPECT_FALSE(ParseLoggedTime("2026-11-23T09:60:00Z"));
  EXPECT_EQ(ParseLoggedTime("2016-12-31T23:59:60Z"), ParseLoggedTime("2017-01-01T00:00:00Z"));
  EXPECT_FALSE(ParseLoggedTime("2200-01-01T00:00:00Z"));
}

TEST(IsoTime, CountsBackwardsBefore1970) {
  EXPECT_EQ(ParseLoggedTime("1969-12-31T23:59:59.75Z"), -250'000);
  // `date -u -d 1969-05-01T10:00:00Z +%s`
  EXPECT_EQ(ParseLoggedTime("1969-05-01T10:00:00Z"), -21'132'000'000'000);
  // `date -u -d 1583-01-01T00:00:00Z +%s`
  EXPECT_EQ(ParseLoggedTime("1583-01-01T00:00:00Z"), -12'212'553'600'000'000);
  EXPECT_FALSE(ParseLoggedTime("1582-12-31T23:59:59Z"));
  EXPECT_FALSE(ParseLoggedTime("0000-00-00T00:00:00Z"));
}

TEST(IsoTime, TakesTwentyFourHoursAsTheNextMidnight) {
  EXPECT_EQ(ParseLoggedTime("2024-05-01T24:00:00Z"), ParseLoggedTime("2024-05-02T00:00:00Z"));
  EXPECT_EQ(ParseLoggedTime("2024-12-31T24:00"), ParseLoggedTime("2025-01-01T00:00:00Z"));
  EXPECT_FALSE(ParseLoggedTime("2024-05-01T24:00:01Z"));
  EXPECT_FALSE(ParseLoggedTime("2024-05-01T24:01Z"));
  EXPECT_FALSE(ParseLoggedTime("2024-05-01T24:00:00.5Z"));
  EXPECT_FALSE(ParseLoggedTime("2024-05-01T25:00:00Z"));
}

TEST(IsoTime, MayHaveNoSecondsAndNoMarks) {
  for (const char* text : {"2026-11-23T09:30Z", "2026-11-23 09:30", "2026-11-23T10:30+01:00",
                           "20261123T093000Z", "20261123T0930", "20261123T103000.0+0100"}) {
    EXPECT_EQ(ParseLoggedTime(text), 1'795'426'200'000'000) << text;
  }
}

TEST(IsoTime, RefusesWhatOnlyBeginsAsATime) {
  for (const char* text :
       {"", "2026", "2026-11-23", "2026-11-23T09", "2026-11-23T09:30:", "2026-11-23T09:30:00.",
        "2026-11-23T09:30.5Z", "20261123T09:30:00Z", "2026-11-23T093000Z", "20261123T0930Z0",
        "2026-11-23T09:30:00+24:00", "2026-11-23T09:30+01:60", "2026-11-23T09:30:00Zx",
        "2026-11-23T09:30:00+1", "x026-11-23T09:30:00", "2026-11-23T09:30:00 Z",
        "2026/11/23T09:30:00Z"}) {
    EXPECT_FALSE(ParseLoggedTime(text)) << text;
  }
}

}  // namespace shoal::iso_time_test
