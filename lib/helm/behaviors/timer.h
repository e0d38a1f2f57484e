// Has no preference: its duration and flags make things happen.
#pragma once

#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "timer". Has no preference: its duration and flags make things happen.
struct TimerOptions {
  static constexpr std::string_view kKind = "timer";

  bool operator==(const TimerOptions&) const = default;
};

class TimerBehavior final : public BehaviorWith<TimerOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs&) override { return {}; }
};

}  // namespace shoal
