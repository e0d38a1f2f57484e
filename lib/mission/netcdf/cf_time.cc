#include "lib/mission/netcdf/cf_time.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <string>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/netcdf/cf_words.h"

namespace shoal {

namespace {

constexpr double kMinute_s = 60;
constexpr double kHour_s = 3600;
constexpr double kDay_s = 86'400;
/// 1582-10-15, the first day of the Gregorian calendar, since 1970.
constexpr double kGregorian_s = -141'427 * kDay_s;

constexpr std::array<std::pair<std::string_view, double>, 16> kTimeUnits = {{
    {"seconds", 1},
    {"second", 1},
    {"secs", 1},
    {"sec", 1},
    {"s", 1},
    {"minutes", kMinute_s},
    {"minute", kMinute_s},
    {"mins", kMinute_s},
    {"min", kMinute_s},
    {"hours", kHour_s},
    {"hour", kHour_s},
    {"hrs", kHour_s},
    {"hr", kHour_s},
    {"h", kHour_s},
    {"days", kDay_s},
    {"day", kDay_s},
}};

/// Reads numbers and marks off the front of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  template <class T>
  bool Take(T* number) {
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), *number);
    if (error != std::errc()) return false;
    rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
    return true;
  }
  bool TakeMark(std::string_view marks) {
    if (rest_.empty() || marks.find(rest_.front()) == std::string_view::npos) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void SkipBlanks() { rest_ = Trimmed(rest_); }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

/// Returns the days from 1970-01-01 to a date of the Julian calendar, which has a leap year in
/// every fourth; nothing where it has no such date.
std::optional<int> DaysOfJulian(int year, unsigned month, unsigned day) {
  constexpr std::array<unsigned, 12> kBefore = {0,   31,  59,  90,  120, 151,
                                                181, 212, 243, 273, 304, 334};
  constexpr int kDaysTo1970 = 719'164;  // From 0001-01-01 of that calendar.
  if (year < 1 || month < 1 || month > 12 || day < 1) return std::nullopt;
  const bool is_leap = year % 4 == 0;
  const unsigned days_of_month = (month == 12 ? 365U : kBefore[month]) - kBefore[month - 1] +
                                 (month == 2 && is_leap ? 1U : 0U);
  if (day > days_of_month) return std::nullopt;
  const unsigned day_of_year = kBefore[month - 1] + (month > 2 && is_leap ? 1U : 0U) + day - 1;
  return (year - 1) * 365 + (year - 1) / 4 + static_cast<int>(day_of_year) - kDaysTo1970;
}

std::optional<double> TakeDay(Scanner* text, bool has_julian_dates) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  const bool is_date = text->Take(&year) && text->TakeMark("-") && text->Take(&month) &&
                       text->TakeMark("-") && text->Take(&day);
  if (!is_date || year < 0 || year > 9999) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  const double gregorian_s =
      date.ok()
          ? kDay_s * static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count())
          : kGregorian_s - 1;  // 1500-02-29: a Julian date alone.
  if (!has_julian_dates || gregorian_s >= kGregorian_s) {
    return date.ok() ? std::optional(gregorian_s) : std::nullopt;
  }
  const std::optional<int> days = DaysOfJulian(year, month, day);
  if (!days || *days * kDay_s >= kGregorian_s) return std::nullopt;
  return *days * kDay_s;
}

/// Reads "06:00", "6:0:0.5", or nothing, which is midnight.
std::optional<double> TakeTimeOfDay(Scanner* text) {
  if (!text->TakeMark("T")) text->SkipBlanks();
  unsigned hours = 0;
  unsigned minutes = 0;
  double seconds = 0;
  if (text->rest().empty() || !text->Take(&hours)) return 0;
  if (!text->TakeMark(":") || !text->Take(&minutes)) return std::nullopt;
  if (text->TakeMark(":") && !text->Take(&seconds)) return std::nullopt;
  if (hours > 24 || minutes > 59 || !(seconds >= 0 && seconds <= 60)) return std::nullopt;
  return kHour_s * hours + kMinute_s * minutes + seconds;
}

/// Reads how far the text's clock is ahead of UTC, to the end.
std::optional<double> TakeOffset(Scanner* text) {
  text->SkipBlanks();
  const std::string word = LowerCase(text->rest());
  if (word.empty() || word == "z" || word == "utc" || word == "gmt") return 0;
  const bool is_behind = word.front() == '-';
  if (!text->TakeMark("+-")) return std::nullopt;
  unsigned hours = 0;
  unsigned minutes = 0;
  if (!text->Take(&hours)) return std::nullopt;
  if (text->TakeMark(":") && !text->Take(&minutes)) return std::nullopt;
  if (hours > 99) {  // +0100
    minutes = hours % 100;
    hours /= 100;
  }
  if (!text->rest().empty() || hours > 14 || minutes > 59) return std::nullopt;
  return (is_behind ? -1 : 1) * (kHour_s * hours + kMinute_s * minutes);
}

}  // namespace

std::optional<CfTimeUnit> ParseCfTimeUnit(std::string_view units, std::string_view calendar) {
  units = Trimmed(units);
  const size_t end = units.find(' ');
  if (end == std::string_view::npos) return std::nullopt;
  const auto unit = std::ranges::find(kTimeUnits, LowerCase(units.substr(0, end)),
                                      [](const auto& row) { return row.first; });
  std::string_view rest = Trimmed(units.substr(end));
  if (unit == kTimeUnits.end() || LowerCase(rest.substr(0, 6)) != "since ") return std::nullopt;
  Scanner text(Trimmed(rest.substr(6)));
  const std::optional<double> day_s = TakeDay(&text, HasJulianDates(calendar));
  if (!day_s) return std::nullopt;
  const std::optional<double> time_s = TakeTimeOfDay(&text);
  if (!time_s) return std::nullopt;
  const std::optional<double> offset_s = TakeOffset(&text);
  if (!offset_s) return std::nullopt;
  return CfTimeUnit{.unit_s = unit->second, .epoch_s = *day_s + *time_s - *offset_s};
}

bool IsRealCalendar(std::string_view calendar) {
  const std::string word = LowerCase(Trimmed(calendar));
  return word.empty() || word == "standard" || word == "gregorian" || word == "proleptic_gregorian";
}

bool HasJulianDates(std::string_view calendar) {
  const std::string word = LowerCase(Trimmed(calendar));
  return word.empty() || word == "standard" || word == "gregorian";
}

bool IsBeforeGregorian(const CfTimeUnit& unit) { return unit.epoch_s < kGregorian_s; }

}  // namespace shoal
