#include "apps/node_reporter/report_schedule.h"

#include <algorithm>
#include <cmath>

namespace shoal {

namespace {
constexpr int64_t kMilliHertzMicroseconds = 1'000'000'000;  ///< One period, in mHz x us.
}

ReportSchedule::ReportSchedule(double rate_hz, int64_t start_utime, int64_t tick_us)
    : start_utime_(start_utime),
      rate_mhz_(0),
      every_step_(rate_hz * static_cast<double>(tick_us) >= 1e6) {
  if (rate_hz > 0 && !every_step_) {
    rate_mhz_ = std::max<int64_t>(1, std::llround(rate_hz * 1000));
  }
}

bool ReportSchedule::IsDue(int64_t utime) {
  if (every_step_) return true;
  if (rate_mhz_ == 0 || utime < start_utime_) return false;
  // Whole seconds apart from the rest: years of mission time do not overflow.
  const int64_t seconds = (utime - start_utime_) / 1'000'000;
  const int64_t rest_us = (utime - start_utime_) % 1'000'000;
  const int64_t millis = seconds * rate_mhz_;  // Thousandths of a slot.
  const int64_t slot =
      millis / 1000 + ((millis % 1000) * 1'000'000 + rest_us * rate_mhz_) / kMilliHertzMicroseconds;
  const bool due = slot > last_slot_;
  last_slot_ = std::max(slot, last_slot_);
  return due;
}

}  // namespace shoal
