// Keeps near the mean of its last headings.
#pragma once

#include <deque>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "memory_turn_limit". Keeps near the mean of its last headings.
struct MemoryTurnLimitOptions {
  static constexpr std::string_view kKind = "memory_turn_limit";

  double memory_time = 0;  ///< s; > 0.
  double turn_range = 0;   ///< Degrees; > 0.

  bool operator==(const MemoryTurnLimitOptions&) const = default;
};

class MemoryTurnLimitBehavior final : public BehaviorWith<MemoryTurnLimitOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  /// Remembers headings too.
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }

 private:
  struct Memory {
    double time_s = 0;
    double heading_deg = 0;
  };

  void Remember(const BehaviorInputs& inputs);

  std::deque<Memory> memory_;
};

}  // namespace shoal
