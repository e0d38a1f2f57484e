// Never deeper than a limit.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "max_depth". Never deeper than a limit.
struct MaxDepthOptions {
  static constexpr std::string_view kKind = "max_depth";

  double max_depth = 0;  ///< m.
  double tolerance =
      0;  ///< m over which the value falls from 100 to 0 below the limit (basewidth of others).
  std::string depth_slack_var = {};

  bool operator==(const MaxDepthOptions&) const = default;
};

class MaxDepthBehavior final : public BehaviorWith<MaxDepthOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }
};

}  // namespace shoal
