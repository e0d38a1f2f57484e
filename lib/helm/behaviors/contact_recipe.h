// When a recipe makes a behavior for a contact or an obstacle, and when that one ends.
#pragma once

#include <optional>
#include <string>

#include "lib/helm/behaviors/any_behavior.h"
#include "lib/helm/behaviors/behavior_runner.h"

namespace shoal {

/// The distances at which a contact concerns a behavior.
struct AlertRange {
  double alert_m = 0;
  double cpa_m = 0;  ///< Within it, a contact that will come within alert_m concerns it.
  bool ends = true;  ///< What was spawned ends where the contact is farther away.
};

/// Returns the ranges of behaviors that keep clear: alert_m = pwt_outer_dist, cpa_m =
/// completed_dist; of others with alert_range both are this and a metre more. Nothing for the rest,
/// which are spawned by updates only.
[[nodiscard]] std::optional<AlertRange> AlertRangeOf(const AnyBehavior& what);

/// Returns true if the contact is within cpa_m, and is within alert_m now or later if both keep
/// course and speed. It is false beyond cpa_m. A behavior that was spawned ends a tenth farther
/// away: a contact that comes back spawns another one.
[[nodiscard]] bool IsAlert(const AlertRange& range, const VesselMotion& own,
                           const VesselMotion& contact);

/// Returns the keys that all contact behaviors have, or nullptr for other kinds.
[[nodiscard]] const ContactOptions* ContactOptionsOf(const AnyBehavior& what);

/// Returns true where neither match_ nor ignore_ keys exclude the contact. Upper and lower case
/// count alike.
[[nodiscard]] bool Passes(const ContactOptions& filter, const ContactView& contact);

/// Returns the distance from a point to a convex polygon, 0 inside. @pre it has a corner
[[nodiscard]] double DistanceTo(const std::vector<Eigen::Vector2d>& polygon_m,
                                const Eigen::Vector2d& point_m);

/// Returns why a behavior that was spawned ends now; empty: it does not.
[[nodiscard]] std::string EndReason(const BehaviorOptions& options, const BehaviorOrigin& origin,
                                    const BehaviorInputs& inputs);

}  // namespace shoal
