// Where a vessel steers that keeps to the line between two points.
#pragma once

#include <Eigen/Core>

#include "lib/base/geometry/leg.h"

namespace shoal {

/// How far ahead on the line it steers.
struct TrackLead {
  double lead_m = -1;         ///< -1: for the end of the leg.
  double lead_damper_m = -1;  ///< -1: off.
  /// The lead is at least so long that it comes back to the leg at no more than this; 90: any.
  double return_deg = 90;
};

/// Whether a vessel is off its leg because it kept clear of a contact.
class Diversion {
 public:
  /// `avoids`: it has a contact to keep clear of. It is over so near to the leg that a lead of
  /// `lead_m`, m, comes back at no more than `return_deg`, degrees: the course does not jump there.
  void Look(bool avoids, const Leg& leg, const Eigen::Vector2d& position_m, double lead_m,
            double return_deg);
  /// The leg is another, or the vessel was taken elsewhere.
  void Forget() { is_on_ = false; }
  [[nodiscard]] bool is_on() const { return is_on_; }

 private:
  bool is_on_ = false;
};

/// Returns the point of the leg that is the lead ahead of the point beside the vessel, never beyond
/// its end. Within lead_damper_m of the line the lead grows linearly, to three times itself on the
/// line. A vessel before the leg counts as beside its beginning.
[[nodiscard]] Eigen::Vector2d SteeringPoint(const Leg& leg, const Eigen::Vector2d& position_m,
                                            const TrackLead& lead);

}  // namespace shoal
