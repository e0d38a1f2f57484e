// Alternates between no preference and a speed.
#pragma once

#include <optional>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "periodic_speed". Alternates between no preference and a speed.
struct PeriodicSpeedOptions {
  static constexpr std::string_view kKind = "periodic_speed";

  double period_lazy = 0;   ///< s without preference; > 0.
  double period_busy = 0;   ///< s with a preference; > 0.
  double period_speed = 0;  ///< m/s.
  double peakwidth = 0;     ///< m/s.
  double basewidth = 0;     ///< m/s.
  double summitdelta = 25;  ///< 0 to 100.
  bool initially_busy = false;
  bool reset_upon_running = true;  ///< Starts again after a pause.

  bool operator==(const PeriodicSpeedOptions&) const = default;
};

class PeriodicSpeedBehavior final : public BehaviorWith<PeriodicSpeedOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  std::optional<double> since_s_;  ///< Of the present half; absent: not begun.
  bool is_busy_ = false;
  int num_busy_ = 0;
};

}  // namespace shoal
