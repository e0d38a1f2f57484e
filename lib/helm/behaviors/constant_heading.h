// Keeps a heading.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "constant_heading". Keeps a heading.
struct ConstantHeadingOptions {
  static constexpr std::string_view kKind = "constant_heading";

  double heading = 0;           ///< Degrees.
  double peakwidth = 10;        ///< Degrees.
  double basewidth = 170;       ///< Degrees.
  double summitdelta = 25;      ///< 0 to 100.
  double complete_thresh = -1;  ///< Degrees; ends when within; -1: off.
  std::string heading_mismatch_var = {};

  bool operator==(const ConstantHeadingOptions&) const = default;
};

class ConstantHeadingBehavior final : public BehaviorWith<ConstantHeadingOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
};

}  // namespace shoal
