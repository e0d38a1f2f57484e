// Likes the present heading the more the steadier the vessel was of late.
#pragma once

#include <deque>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "hysteresis". Likes courses near the present heading, in a window that is the wider the
/// steadier the vessel was of late.
struct HysteresisOptions {
  static constexpr std::string_view kKind = "hysteresis";

  double memory_time = 0;           ///< s; > 0.
  double min_heading_window = 10;   ///< Degrees, both sides together, after turns.
  double max_heading_window = 60;   ///< Degrees, after a steady course; >= min_heading_window.
  double max_window_utility = 100;  ///< 0 to 100: the weight inside the window, per cent.

  bool operator==(const HysteresisOptions&) const = default;
};

/// 100 inside the window, 0 outside. Its width falls linearly to the least one at 30 degrees of
/// standard deviation of the headings of memory_time.
class HysteresisBehavior final : public BehaviorWith<HysteresisOptions> {
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
  double Deviation_deg() const;

  std::deque<Memory> memory_;
};

}  // namespace shoal
