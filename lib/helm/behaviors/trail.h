// Follows a contact at a distance and an angle.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_options.h"

namespace shoal {

/// kind = "trail". Follows a contact at a distance and an angle.
struct TrailOptions {
  static constexpr std::string_view kKind = "trail";

  ContactOptions contact = {};                ///< Which contact, and how it is tracked.
  double trail_range = 50;                    ///< m.
  double trail_angle = 180;                   ///< Degrees from the contact's bow.
  std::string trail_angle_type = "relative";  ///< relative or absolute.
  double radius = 5;                          ///< m.
  double nm_radius = 20;                      ///< m.
  double pwt_outer_dist = 0;                  ///< m; 0: always.

  bool operator==(const TrailOptions&) const = default;
};

class TrailBehavior final : public BehaviorWith<TrailOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
};

}  // namespace shoal
