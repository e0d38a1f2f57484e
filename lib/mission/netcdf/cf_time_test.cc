#include "lib/mission/netcdf/cf_time.h"

#include <gtest/gtest.h>

namespace shoal::cf_time_test {

// `date -u -d "2026-11-24 06:00" +%s`, and of 1950-01-01 and 1900-01-01.
constexpr double k2026_s = 1'795'500'000;
constexpr double k1950_s = -631'152'000;
constexpr double k1900_s = -2'208'988'800;

void ExpectUnit(std::string_view units, double unit_s, double epoch_s) {
  const auto unit = ParseCfTimeUnit(units);
  ASSERT_TRUE(unit.has_value()) << units;
  EXPECT_EQ(unit->unit_s, unit_s) << units;
  EXPECT_EQ(unit->epoch_s, epoch_s) << units;
}

TEST(CfTimeUnit, CountsSecondsMinutesHoursAndDays) {
  ExpectUnit("seconds since 2026-11-24 06:00:00", 1, k2026_s);
  ExpectUnit("minutes since 2026-11-24 06:00", 60, k2026_s);
  ExpectUnit("Hours since 1950-01-01", 3600, k1950_s);
  ExpectUnit("days since 1900-1-1 0:0:0", 86'400, k1900_s);
  ExpectUnit("s since 1970-01-01T00:00:01.5Z", 1, 1.5);
}

TEST(CfTimeUnit, TakesOffsetsFromUtc) {
  ExpectUnit("seconds since 2026-11-24 07:30:00 +01:30", 1, k2026_s);
  ExpectUnit("seconds since 2026-11-24T01:00:00-0500", 1, k2026_s);
  ExpectUnit("seconds since 2026-11-24 05:00:00 -1", 1, k2026_s);
  ExpectUnit("seconds since 2026-11-24 06:00:00 UTC", 1, k2026_s);
}

TEST(CfTimeUnit, IsNothingElse) {
  for (const char* units :
       {"", "hours", "hours since", "months since 1950-01-01", "hours since 1950-13-01",
        "hours since 1950-02-30", "hours since yesterday", "hours since 1950-01-01 25:00",
        "hours since 1950-01-01 06:00 CET", "hours since 1950-01-01 06:00:00 +99:00",
        "hours before 1950-01-01", "m s-1"}) {
    EXPECT_FALSE(ParseCfTimeUnit(units).has_value()) << units;
  }
}

TEST(CfCalendar, IsRealWhereItsDaysAre) {
  for (const char* real : {"", "standard", "Gregorian", "proleptic_gregorian"}) {
    EXPECT_TRUE(IsRealCalendar(real)) << real;
  }
  for (const char* other : {"360_day", "noleap", "julian"}) EXPECT_FALSE(IsRealCalendar(other));
}

}  // namespace shoal::cf_time_test
