// Pulls the vessel back to a point, the harder the farther it is away.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "rubber_band". Pulls the vessel back to a point, the harder the farther it is away.
struct RubberBandOptions {
  static constexpr std::string_view kKind = "rubber_band";

  std::optional<Eigen::Vector2d> point = {};  ///< x East, y North; absent: where it begins.
  double inner_radius = 4;                    ///< m; no preference within.
  double outer_radius = 15;                   ///< m; > inner_radius.
  double outer_speed = 1.2;  ///< m/s at outer_radius and beyond; rises from 0 at inner_radius.
  double extra_speed = 0;    ///< m/s beyond outer_radius; 0: outer_speed.
  double stiffness = 0.1;    ///< The weight grows by this share per outer_radius beyond it.

  bool operator==(const RubberBandOptions&) const = default;
};

class RubberBandBehavior final : public BehaviorWith<RubberBandOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  std::optional<Eigen::Vector2d> begin_m_;  ///< Without a point: where it began.
};

}  // namespace shoal
