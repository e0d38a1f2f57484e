// The ages of what vehicles know of each other by node reports.
//
//   ReportAges ages;
//   ages.Add(0, 1, report.utime, step_utime);   // vehicle 0 received a report of vehicle 1
//   std::vector<AgeTooth> teeth = ages.Teeth(0, 1, last_utime);
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "lib/tools/analysis/age_teeth.h"

namespace shoal {

class ReportAges {
 public:
  /// Takes a report that was made at `report_utime` and received at `utime`. A report older than
  /// the last one changes nothing. A report from the future has age 0 when it arrives. Times
  /// outside every mission are ignored.
  void Add(size_t vehicle, size_t contact, int64_t report_utime, int64_t utime);

  /// Returns how the age went up to `end_utime`; empty where no report came.
  [[nodiscard]] std::vector<AgeTooth> Teeth(size_t vehicle, size_t contact,
                                            int64_t end_utime) const;

 private:
  struct Known {
    int64_t report_utime = 0;
    std::vector<AgeTooth> teeth;  ///< The last one goes on: its length is not known.
  };
  std::map<std::pair<size_t, size_t>, Known> known_;
};

}  // namespace shoal
