#include "lib/helm/behaviors/track_line.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

void Diversion::Look(bool avoids, const Leg& leg, const Eigen::Vector2d& position_m, double lead_m,
                     double return_deg) {
  if (avoids) {
    is_on_ = true;
  } else if (is_on_) {
    const double off_m = std::abs(Project(leg, position_m).cross_track_m);
    const double return_rad = DegToRad(return_deg);
    is_on_ = off_m * Cos(return_rad) > std::max(0.0, lead_m) * Sin(return_rad);
  }
}

Eigen::Vector2d SteeringPoint(const Leg& leg, const Eigen::Vector2d& position_m,
                              const TrackLead& lead) {
  const double length_m = Length(leg);
  if (lead.lead_m < 0 || length_m == 0) return leg.to_m;
  const TrackPosition track = Project(leg, position_m);
  const double off_m = std::abs(track.cross_track_m);
  double lead_m = lead.lead_m;
  if (off_m < lead.lead_damper_m) lead_m *= 1 + 2 * (1 - off_m / lead.lead_damper_m);
  if (lead.return_deg < 90) {
    const double return_rad = DegToRad(lead.return_deg);
    lead_m = std::max(lead_m, off_m * Cos(return_rad) / Sin(return_rad));
  }
  const double along_m = std::max(0.0, track.along_m) + lead_m;
  return along_m >= length_m
             ? leg.to_m
             : Eigen::Vector2d(leg.from_m + along_m / length_m * (leg.to_m - leg.from_m));
}

}  // namespace shoal
