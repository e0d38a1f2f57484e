// Keeps a depth.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "constant_depth". Keeps a depth.
struct ConstantDepthOptions {
  static constexpr std::string_view kKind = "constant_depth";

  double depth = 0;         ///< m.
  double peakwidth = 3;     ///< m.
  double basewidth = 100;   ///< m.
  double summitdelta = 50;  ///< 0 to 100.
  std::string depth_mismatch_var = {};

  bool operator==(const ConstantDepthOptions&) const = default;
};

class ConstantDepthBehavior final : public BehaviorWith<ConstantDepthOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
};

}  // namespace shoal
