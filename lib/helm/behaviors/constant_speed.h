// Keeps a speed.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "constant_speed". Keeps a speed.
struct ConstantSpeedOptions {
  static constexpr std::string_view kKind = "constant_speed";

  double speed = 0;        ///< m/s.
  double peakwidth = 0;    ///< m/s.
  double basewidth = 0.2;  ///< m/s.
  double summitdelta = 0;  ///< 0 to 100.
  std::string speed_mismatch_var = {};

  bool operator==(const ConstantSpeedOptions&) const = default;
};

class ConstantSpeedBehavior final : public BehaviorWith<ConstantSpeedOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
};

}  // namespace shoal
