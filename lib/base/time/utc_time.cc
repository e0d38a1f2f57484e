#include "lib/base/time/utc_time.h"

#include <algorithm>
#include <chrono>

#include "lib/base/text/numbers.h"
#include "lib/base/time/time_units.h"

namespace shoal {
namespace {

bool IsWithin(int number, int low, int high) { return number >= low && number <= high; }

}  // namespace

CalendarTime ToCalendar(int64_t utc_us) {
  using std::chrono::sys_days;
  constexpr sys_days kFirst = std::chrono::year::min() / std::chrono::January / 1;
  constexpr sys_days kLast = std::chrono::year::max() / std::chrono::December / 31;
  const int64_t microsecond = (utc_us % kSecond_us + kSecond_us) % kSecond_us;
  const int64_t second = utc_us / kSecond_us - (utc_us % kSecond_us < 0 ? 1 : 0);
  const std::chrono::sys_seconds time{std::chrono::seconds(second)};
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::hh_mm_ss in_day(time - day);
  const std::chrono::year_month_day date(std::clamp(day, kFirst, kLast));
  return {.year = static_cast<int>(date.year()),
          .month = static_cast<int>(static_cast<unsigned>(date.month())),
          .day = static_cast<int>(static_cast<unsigned>(date.day())),
          .hour = static_cast<int>(in_day.hours().count()),
          .minute = static_cast<int>(in_day.minutes().count()),
          .second = static_cast<int>(in_day.seconds().count()),
          .microsecond = static_cast<int>(microsecond)};
}

std::optional<int64_t> ToUtc(const CalendarTime& time) {
  if (time.year < 1970 || time.year > kLastClockYear) return std::nullopt;
  if (!IsWithin(time.month, 1, 12) || !IsWithin(time.day, 1, 31)) return std::nullopt;
  if (!IsWithin(time.hour, 0, 23) || !IsWithin(time.minute, 0, 59)) return std::nullopt;
  if (!IsWithin(time.second, 0, 60) || !IsWithin(time.microsecond, 0, 999'999)) {
    return std::nullopt;
  }
  const std::chrono::year_month_day date(std::chrono::year(static_cast<int>(time.year)),
                                         std::chrono::month(static_cast<unsigned>(time.month)),
                                         std::chrono::day(static_cast<unsigned>(time.day)));
  if (!date.ok()) return std::nullopt;  // 31 April.
  const std::chrono::sys_time<std::chrono::microseconds> utc =
      std::chrono::sys_days(date) + std::chrono::hours(time.hour) +
      std::chrono::minutes(time.minute) + std::chrono::seconds(time.second) +
      std::chrono::microseconds(time.microsecond);
  return utc.time_since_epoch().count();
}

std::string ClockText(int64_t utc_us, int decimals) {
  const CalendarTime time = ToCalendar(utc_us);
  std::string text =
      ZeroPadded(time.hour, 2) + ZeroPadded(time.minute, 2) + ZeroPadded(time.second, 2);
  if (decimals > 0) {
    text += "." + ZeroPadded(time.microsecond, 6).substr(0, static_cast<size_t>(decimals));
  }
  return text;
}

std::string IsoTimeText(int64_t utc_us) {
  const CalendarTime time = ToCalendar(utc_us);
  return ZeroPadded(time.year, 4) + "-" + ZeroPadded(time.month, 2) + "-" +
         ZeroPadded(time.day, 2) + "T" + ZeroPadded(time.hour, 2) + ":" +
         ZeroPadded(time.minute, 2) + ":" + ZeroPadded(time.second, 2) + "Z";
}

std::optional<int64_t> ParseIsoTime(std::string_view text) {
  constexpr std::string_view kPattern = "dddd-dd-ddTdd:dd:ddZ";
  if (text.size() != kPattern.size()) return std::nullopt;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool is_digit = text[i] >= '0' && text[i] <= '9';
    if (kPattern[i] == 'd' ? !is_digit : text[i] != kPattern[i]) return std::nullopt;
  }
  const auto number = [text](size_t place, size_t length) {
    int value = 0;
    for (const char digit : text.substr(place, length)) value = 10 * value + (digit - '0');
    return value;
  };
  return ToUtc({.year = number(0, 4),
                .month = number(5, 2),
                .day = number(8, 2),
                .hour = number(11, 2),
                .minute = number(14, 2),
                .second = number(17, 2)});
}

}  // namespace shoal
