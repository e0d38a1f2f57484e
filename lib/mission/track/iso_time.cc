#include "lib/mission/track/iso_time.h"

#include <chrono>

#include "lib/base/time/time_units.h"
#include "lib/base/time/utc_time.h"

namespace shoal {

namespace {

/// Takes digits and marks off the front of a text; once one does not fit, `ok` stays false.
class IsoReader {
 public:
  explicit IsoReader(std::string_view text) : rest_(text) {}

  int Digits(int count) {
    int number = 0;
    for (int i = 0; i < count; ++i) {
      const char c = Next();
      ok_ = ok_ && c >= '0' && c <= '9';
      number = ok_ ? number * 10 + (c - '0') : 0;
    }
    return number;
  }
  void Mark(std::string_view one_of) {
    const char c = Next();
    ok_ = ok_ && c != '\0' && one_of.find(c) != std::string_view::npos;
  }
  /// Takes `mark` where it comes next.
  bool Took(char mark) {
    if (rest_.empty() || rest_.front() != mark) return false;
    rest_.remove_prefix(1);
    return true;
  }
  /// Reads the digits behind the decimal point of the seconds.
  int64_t Fraction_us() {
    int64_t fraction_us = 0;
    int64_t unit_us = kSecond_us;
    bool any = false;
    while (!rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9') {
      unit_us /= 10;
      fraction_us += unit_us * (rest_.front() - '0');
      rest_.remove_prefix(1);
      any = true;
    }
    ok_ = ok_ && any;
    return fraction_us;
  }
  /// What the text has is not a time.
  void Refuse() { ok_ = false; }
  bool ok() const { return ok_; }
  bool ends_or_has_offset() const {
    return rest_.empty() || std::string_view("Zz+-").find(rest_.front()) != std::string_view::npos;
  }
  bool at_end() const { return rest_.empty(); }

 private:
  char Next() {
    if (rest_.empty()) return '\0';
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  std::string_view rest_;
  bool ok_ = true;
};

/// Returns the offset from UTC in seconds: "Z", "+01:00", "+0100", "+01"; none is UTC.
int64_t OffsetOf(IsoReader& reader) {
  if (reader.at_end() || reader.Took('Z') || reader.Took('z')) return 0;
  const bool is_west = reader.Took('-');
  if (!is_west) reader.Mark("+");
  const int hours = reader.Digits(2);
  int minutes = 0;
  if (!reader.at_end()) {
    reader.Took(':');
    minutes = reader.Digits(2);
  }
  if (hours > 23 || minutes > 59) reader.Refuse();
  const int64_t offset_s = int64_t{3600} * hours + int64_t{60} * minutes;
  return is_west ? -offset_s : offset_s;
}

}  // namespace

std::optional<int64_t> ParseLoggedTime(std::string_view text) {
  IsoReader reader(text);
  const int year = reader.Digits(4);
  // The basic format has no marks within day and time of day, the extended one has all.
  const bool is_extended = reader.Took('-');
  const int month = reader.Digits(2);
  if (is_extended) reader.Mark("-");
  const int day = reader.Digits(2);
  reader.Mark("T t");
  const int hour = reader.Digits(2);
  if (is_extended) reader.Mark(":");
  const int minute = reader.Digits(2);
  int second = 0;
  int64_t fraction_us = 0;
  if (!reader.ends_or_has_offset()) {
    if (is_extended) reader.Mark(":");
    second = reader.Digits(2);
    if (reader.Took('.') || reader.Took(',')) fraction_us = reader.Fraction_us();
  }
  const int64_t offset_s = OffsetOf(reader);
  if (!reader.ok() || !reader.at_end()) return std::nullopt;
  const std::chrono::year_month_day date(std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day)));
  if (year < kFirstLoggedYear || year > kLastClockYear || !date.ok()) return std::nullopt;
  const bool is_midnight = hour == 24 && minute == 0 && second == 0 && fraction_us == 0;
  if ((hour > 23 && !is_midnight) || minute > 59 || second > 60) return std::nullopt;
  const std::chrono::seconds utc = std::chrono::sys_days(date).time_since_epoch() +
                                   std::chrono::hours(hour) + std::chrono::minutes(minute) +
                                   std::chrono::seconds(second - offset_s);
  return utc.count() * kSecond_us + fraction_us;
}

}  // namespace shoal
