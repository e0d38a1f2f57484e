// UTC as people and modems write it. The Gregorian calendar, without leap seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace shoal {

inline constexpr int kLastClockYear = 2199;  ///< That ToUtc takes: a modem's clock ends with it.

struct CalendarTime {
  int64_t year = 1970;
  int month = 1;  ///< From 1.
  int day = 1;    ///< From 1.
  int hour = 0;
  int minute = 0;
  int second = 0;
  int microsecond = 0;

  bool operator==(const CalendarTime&) const = default;
};

/// Returns the calendar's time of a number of microseconds since 1970. Dates before the year -32767
/// and after 32767 are those years' first and last.
[[nodiscard]] CalendarTime ToCalendar(int64_t utc_us);

/// Returns the microseconds since 1970. A second 60 is the next minute's first. Nothing for a day
/// or a time that does not exist, and for years before 1970 and after kLastClockYear.
[[nodiscard]] std::optional<int64_t> ToUtc(const CalendarTime& time);

/// Returns "hhmmss", with 1 to 6 decimals "hhmmss.ssss", cut off, not rounded.
[[nodiscard]] std::string ClockText(int64_t utc_us, int decimals = 0);

/// Returns "2026-11-21T02:25:24Z".
[[nodiscard]] std::string IsoTimeText(int64_t utc_us);

/// Reads what IsoTimeText writes. Nothing for anything else.
[[nodiscard]] std::optional<int64_t> ParseIsoTime(std::string_view text);

}  // namespace shoal
