#include "lib/vehicle/navigation/assumed_motion.h"

#include "lib/vehicle/navigation/navigation_filter.h"
#include "lib/vehicle/vehicle/sway_in_turns.h"

namespace shoal {

// Tuned so that 92 to 98 % of positions lie in the ellipse of 95 %:
// tests/closed_loops/navigation_coverage_test.cc.
void AssumeMotionOf(const Remus100& auv, FilterOptions* options) {
  options->sway_in_turns = SwayInTurnsOf(auv);
  options->sway_mps = 0.02;
  options->sway_share = 0.2;
  options->sway_time_s = 10;
}

}  // namespace shoal
