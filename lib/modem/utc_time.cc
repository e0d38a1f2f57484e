#include "lib/modem/utc_time.h"

#include <algorithm>

#include "lib/check/time_units.h"
#include "lib/modem/sentence_text.h"

namespace shoal {
namespace {

constexpr int64_t kDay_s = 86'400;
constexpr int64_t kDaysIn400Years = 146'097;
constexpr int64_t kDaysFromMarch0000To1970 = 719'468;

int64_t FloorDivide(int64_t number, int64_t by) { return number / by - (number % by < 0 ? 1 : 0); }

// Years are counted from March here, so that the leap day is a year's last.
int64_t DaysBeforeMonth(int64_t months_since_march) { return (153 * months_since_march + 2) / 5; }
int64_t DaysBeforeYear(int64_t year) {
  return 365 * year + FloorDivide(year, 4) - FloorDivide(year, 100) + FloorDivide(year, 400);
}

int64_t DaysSince1970(int64_t year, int month, int day) {
  const int64_t year_from_march = month <= 2 ? year - 1 : year;
  const int64_t months_since_march = (month + 9) % 12;
  return DaysBeforeYear(year_from_march) + DaysBeforeMonth(months_since_march) + day - 1 -
         kDaysFromMarch0000To1970;
}

void SetDate(int64_t days_since_1970, CalendarTime* time) {
  const int64_t days = days_since_1970 + kDaysFromMarch0000To1970;
  int64_t year = FloorDivide(days, kDaysIn400Years) * 400;
  const int64_t in_400_years = days - DaysBeforeYear(year);
  year += std::min<int64_t>(in_400_years / 365, 399);
  while (DaysBeforeYear(year) > days) --year;
  const int64_t in_year = days - DaysBeforeYear(year);
  const int64_t months_since_march = (5 * in_year + 2) / 153;
  time->month = static_cast<int>((months_since_march + 2) % 12 + 1);
  time->day = static_cast<int>(in_year - DaysBeforeMonth(months_since_march) + 1);
  time->year = time->month <= 2 ? year + 1 : year;
}

bool IsWithin(int number, int low, int high) { return number >= low && number <= high; }

}  // namespace

CalendarTime ToCalendar(int64_t utc_us) {
  const int64_t utc_s = FloorDivide(utc_us, kSecond_us);
  const int64_t days = FloorDivide(utc_s, kDay_s);
  const auto in_day_s = static_cast<int>(utc_s - days * kDay_s);
  CalendarTime time;
  SetDate(days, &time);
  time.hour = in_day_s / 3600;
  time.minute = in_day_s / 60 % 60;
  time.second = in_day_s % 60;
  time.microsecond = static_cast<int>(utc_us - utc_s * kSecond_us);
  return time;
}

std::optional<int64_t> ToUtc(const CalendarTime& time) {
  if (time.year < 1970 || time.year > 2200) return std::nullopt;
  if (!IsWithin(time.month, 1, 12) || !IsWithin(time.day, 1, 31)) return std::nullopt;
  if (!IsWithin(time.hour, 0, 23) || !IsWithin(time.minute, 0, 59)) return std::nullopt;
  if (!IsWithin(time.second, 0, 60) || !IsWithin(time.microsecond, 0, 999'999)) {
    return std::nullopt;
  }
  const int64_t days = DaysSince1970(time.year, time.month, time.day);
  CalendarTime date;
  SetDate(days, &date);
  if (date.month != time.month) return std::nullopt;  // 31 April is in May.
  const int64_t in_day_s = time.hour * 3600 + time.minute * 60 + time.second;
  return (days * kDay_s + in_day_s) * kSecond_us + time.microsecond;
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
