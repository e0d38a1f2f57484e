#include "apps/node_reporter/dead_reckoning.h"

#include <cmath>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/time/seconds.h"

namespace shoal {

bool Predicts(const node_report_t& last, const node_report_t& now,
              const DeadReckoningLimits& limits) {
  const double age_s = Seconds(now.utime - last.utime);
  if (!(age_s < limits.max_gap_s)) return false;
  const auto [east, north] = SinCos(last.course_over_ground_deg * std::numbers::pi / 180);
  const double run_m = last.speed_over_ground_mps * age_s;
  const double miss_m = std::hypot(last.x_m + run_m * east - now.x_m,
                                   last.y_m + run_m * north - now.y_m, last.depth_m - now.depth_m);
  const double turned_deg = std::abs(std::remainder(now.heading_deg - last.heading_deg, 360));
  return miss_m < limits.position_m && turned_deg < limits.heading_deg;
}

}  // namespace shoal
