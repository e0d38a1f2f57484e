// Never nearer to the sea floor than a limit.
#pragma once

#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "min_altitude". Never nearer to the sea floor than a limit.
struct MinAltitudeOptions {
  static constexpr std::string_view kKind = "min_altitude";

  double min_altitude = 0;                ///< m above the floor.
  double tolerance = 0;                   ///< m over which the value falls from 100 to 0 below it.
  bool missing_altitude_critical = true;  ///< An all-stop while the altitude is not known.

  bool operator==(const MinAltitudeOptions&) const = default;
};

class MinAltitudeBehavior final : public BehaviorWith<MinAltitudeOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }
};

}  // namespace shoal
