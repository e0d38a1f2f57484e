// Where a vessel steers that keeps to the line between two points.
#pragma once

#include <Eigen/Core>

#include "lib/base/geometry/leg.h"

namespace shoal {

/// How far ahead on the line it steers.
struct TrackLead {
  double lead_m = -1;         ///< -1: for the end of the leg.
  double lead_damper_m = -1;  ///< -1: off.
};

/// Returns the point of the leg that is the lead ahead of the point beside the vessel, never beyond
/// its end. Within lead_damper_m of the line the lead grows linearly, to three times itself on the
/// line. A vessel before the leg counts as beside its beginning.
[[nodiscard]] Eigen::Vector2d SteeringPoint(const Leg& leg, const Eigen::Vector2d& position_m,
                                            const TrackLead& lead);

}  // namespace shoal
