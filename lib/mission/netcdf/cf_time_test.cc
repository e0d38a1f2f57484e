#include "lib/mission/netcdf/cf_time.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

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

// As cftime and udunits2 count: 0001-01-01 of the Julian calendar is two days before that of the
// Gregorian one, `date -u -d 0001-01-01 +%s`.
constexpr double kGregorianYear1_s = -62'135'596'800;

TEST(CfTimeUnit, CountsFromJulianDatesBefore1582InTheStandardCalendar) {
  for (const char* calendar : {"", "standard", "Gregorian"}) {
    const auto unit = ParseCfTimeUnit("hours since 1-1-1 00:00:0.0", calendar);
    ASSERT_TRUE(unit.has_value()) << calendar;
    EXPECT_EQ(unit->epoch_s, kGregorianYear1_s - 2 * 86'400.0) << calendar;
    EXPECT_EQ(unit->epoch_s + unit->unit_s * 17'758'680, 1'795'478'400) << "2026-11-24";
  }
  EXPECT_EQ(ParseCfTimeUnit("hours since 1-1-1", "proleptic_gregorian")->epoch_s,
            kGregorianYear1_s);
}

TEST(CfTimeUnit, HasTheDayAfterTheLastJulianOneAndNoneBetween) {
  const auto epoch_s = [](const std::string& date, const char* calendar = "standard") {
    const auto unit = ParseCfTimeUnit("s since " + date, calendar);
    return unit ? std::optional(unit->epoch_s) : std::nullopt;
  };
  EXPECT_EQ(epoch_s("1582-10-15").value() - epoch_s("1582-10-04").value(), 86'400);
  for (const char* none : {"1582-10-05", "1582-10-14", "0-1-1", "1500-02-30", "1501-02-29",
                           "1582-00-01", "1582-04-31", "1900-02-29"}) {
    EXPECT_FALSE(epoch_s(none).has_value()) << none;
  }
  EXPECT_EQ(epoch_s("1500-03-01").value() - epoch_s("1500-02-29").value(), 86'400)
      << "a leap year of the Julian calendar";
  EXPECT_EQ(epoch_s("1500-12-31").value() - epoch_s("1500-01-01").value(), 365 * 86'400.0);
  EXPECT_TRUE(epoch_s("1582-10-10", "proleptic_gregorian").has_value());
  EXPECT_FALSE(epoch_s("1500-02-29", "proleptic_gregorian").has_value());
  EXPECT_TRUE(epoch_s("0-1-1", "proleptic_gregorian").has_value());
}

TEST(CfTimeUnit, IsBeforeTheGregorianCalendarUpToTheDayOfItsReform) {
  EXPECT_TRUE(IsBeforeGregorian(*ParseCfTimeUnit("s since 1582-10-04")));
  EXPECT_FALSE(IsBeforeGregorian(*ParseCfTimeUnit("s since 1582-10-15")));
}

TEST(CfCalendar, IsRealWhereItsDaysAre) {
  for (const char* real : {"", "standard", "Gregorian", "proleptic_gregorian"}) {
    EXPECT_TRUE(IsRealCalendar(real)) << real;
  }
  for (const char* other : {"360_day", "noleap", "julian"}) EXPECT_FALSE(IsRealCalendar(other));
}

}  // namespace shoal::cf_time_test
