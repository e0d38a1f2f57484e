#include "lib/tools/metrics/report_ages.h"

#include <algorithm>

#include "lib/base/time/time_units.h"

namespace shoal {

void ReportAges::Add(size_t vehicle, size_t contact, int64_t report_utime, int64_t utime) {
  if (report_utime < -kLatest_us || report_utime > kLatest_us) return;
  Known& known = known_[{vehicle, contact}];
  if (!known.teeth.empty()) {
    if (report_utime <= known.report_utime) return;
    known.teeth.back().length_us = utime - known.teeth.back().taken_utime;
  }
  known.report_utime = report_utime;
  known.teeth.push_back(
      {.taken_utime = utime, .begin_us = std::max<int64_t>(0, utime - report_utime)});
}

std::vector<AgeTooth> ReportAges::Teeth(size_t vehicle, size_t contact, int64_t end_utime) const {
  const auto found = known_.find({vehicle, contact});
  if (found == known_.end()) return {};
  std::vector<AgeTooth> teeth = found->second.teeth;
  teeth.back().length_us = std::max<int64_t>(0, end_utime - teeth.back().taken_utime);
  return teeth;
}

}  // namespace shoal
