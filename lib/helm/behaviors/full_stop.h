// Wants speed 0.
#pragma once

#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "full_stop". Wants speed 0.
struct FullStopOptions {
  static constexpr std::string_view kKind = "full_stop";

  bool operator==(const FullStopOptions&) const = default;
};

class FullStopBehavior final : public BehaviorWith<FullStopOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
};

}  // namespace shoal
