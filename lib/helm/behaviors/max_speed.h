// Never faster than a limit.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "max_speed". Never faster than a limit.
struct MaxSpeedOptions {
  static constexpr std::string_view kKind = "max_speed";

  double max_speed = 0;    ///< m/s.
  double tolerance = 0.5;  ///< m/s over which the value falls from 100 to 0 above it.
  std::string speed_slack_var = {};

  bool operator==(const MaxSpeedOptions&) const = default;
};

class MaxSpeedBehavior final : public BehaviorWith<MaxSpeedOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }
};

}  // namespace shoal
