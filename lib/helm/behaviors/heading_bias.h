// Likes turns to one side better than those to the other.
#pragma once

#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "heading_bias". Likes turns to one side better than those to the other.
struct HeadingBiasOptions {
  static constexpr std::string_view kKind = "heading_bias";

  std::string bias = "right";  ///< right or left.

  bool operator==(const HeadingBiasOptions&) const = default;
};

/// 100 on the half circle to that side of the heading, ends included, 0 on the other.
class HeadingBiasBehavior final : public BehaviorWith<HeadingBiasOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }
};

}  // namespace shoal
