// The position that others derive from a vehicle's last report alone.
#pragma once

#include <cstdint>

#include "shoal/node_report_t.hpp"

namespace shoal {

/// How far from the truth a listener's dead reckoning may be.
struct DeadReckoningLimits {
  double position_m = 0.25;
  double heading_deg = 1;
  double max_gap_s = 5;  ///< An older report predicts nothing.
};

/// Returns true where `last`, carried on along its course over ground, comes closer to `now` than
/// the limits in place and heading, and is younger than the largest gap.
[[nodiscard]] bool Predicts(const node_report_t& last, const node_report_t& now,
                            const DeadReckoningLimits& limits);

}  // namespace shoal
