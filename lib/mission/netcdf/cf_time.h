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

/// Returns what "hours since 1950-01-01 06:00:00" means; nothing where it is another form. Units
/// are seconds, minutes, hours, days, and their usual short forms; the date is of the Gregorian
/// calendar, its time and its offset ("Z", "UTC", "+01:00") may be absent.
[[nodiscard]] std::optional<CfTimeUnit> ParseCfTimeUnit(std::string_view units);

/// Returns whether days of the calendar (attribute `calendar`; empty: it has none) are real ones.
[[nodiscard]] bool IsRealCalendar(std::string_view calendar);

}  // namespace shoal
