// When a vehicle reports: at a fixed rate from the mission's start, in whole microseconds, with no
// drift however long the mission.
#pragma once

#include <cstdint>

namespace shoal {

class ReportSchedule {
 public:
  /// A report is due at `start_utime` and every 1 / `rate_hz` from there; the rate counts in whole
  /// millihertz. A rate at or above one per `tick_us` makes one due in every step. One that is not
  /// above zero: never.
  ReportSchedule(double rate_hz, int64_t start_utime, int64_t tick_us);

  /// Returns true in the first step at or after each due time. Call it once per step, in order; a
  /// due time that was missed is gone.
  bool IsDue(int64_t utime);

 private:
  int64_t start_utime_;
  int64_t rate_mhz_;
  bool every_step_;
  int64_t last_slot_ = -1;
};

}  // namespace shoal
