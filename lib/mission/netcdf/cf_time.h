// Time units of NetCDF files ("CF Conventions" 1.11, section 4.4).
#pragma once

#include <optional>
#include <string_view>

namespace shoal {

/// What a number of a time axis means: `epoch_s` + number * `unit_s`, in seconds since 1970, UTC.
struct CfTimeUnit {
  double unit_s = 1;
  double epoch_s = 0;
};

/// Returns whether days of the calendar (attribute `calendar`; empty: it has none) are real ones.
[[nodiscard]] bool IsRealCalendar(std::string_view calendar);

/// Returns whether dates before 1582-10-15 are Julian ones: those of the calendars "standard" and
/// "gregorian", and without the attribute.
[[nodiscard]] bool HasJulianDates(std::string_view calendar);

/// Returns what "hours since 1950-01-01 06:00:00" means; nothing where it is another form. Units
/// are seconds, minutes, hours, days, and their usual short forms; the time of the date and its
/// offset ("Z", "UTC", "+01:00") may be absent. The date is of the Gregorian calendar, of a
/// calendar with Julian dates it is one of those before 1582-10-15; the ten days before that, and
/// the year 0, which that calendar does not have, are nothing.
[[nodiscard]] std::optional<CfTimeUnit> ParseCfTimeUnit(std::string_view units,
                                                        std::string_view calendar = "");

/// Returns whether the date of such a unit is before 1582-10-15, where calendars differ.
[[nodiscard]] bool IsBeforeGregorian(const CfTimeUnit& unit);

}  // namespace shoal
