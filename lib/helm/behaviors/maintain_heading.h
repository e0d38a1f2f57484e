// Keeps the heading that the vessel had when the behavior began.
#pragma once

#include <optional>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "maintain_heading". Keeps the heading that the vessel had when the behavior began.
struct MaintainHeadingOptions {
  static constexpr std::string_view kKind = "maintain_heading";

  double peakwidth = 10;    ///< Degrees.
  double basewidth = 170;   ///< Degrees.
  double summitdelta = 25;  ///< 0 to 100.

  bool operator==(const MaintainHeadingOptions&) const = default;
};

class MaintainHeadingBehavior final : public BehaviorWith<MaintainHeadingOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  /// Takes the heading again after a pause.
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  std::optional<double> heading_deg_;
};

}  // namespace shoal
