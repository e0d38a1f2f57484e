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

std::optional<double> TakeDay(Scanner* text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  const bool is_date = text->Take(&year) && text->TakeMark("-") && text->Take(&month) &&
                       text->TakeMark("-") && text->Take(&day);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  if (!is_date || year < 0 || year > 9999 || !date.ok()) return std::nullopt;
  return kDay_s * static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
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

std::optional<CfTimeUnit> ParseCfTimeUnit(std::string_view units) {
  units = Trimmed(units);
  const size_t end = units.find(' ');
  if (end == std::string_view::npos) return std::nullopt;
  const auto unit = std::ranges::find(kTimeUnits, LowerCase(units.substr(0, end)),
                                      [](const auto& row) { return row.first; });
  std::string_view rest = Trimmed(units.substr(end));
  if (unit == kTimeUnits.end() || LowerCase(rest.substr(0, 6)) != "since ") return std::nullopt;
  Scanner text(Trimmed(rest.substr(6)));
  const std::optional<double> day_s = TakeDay(&text);
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

}  // namespace shoal
