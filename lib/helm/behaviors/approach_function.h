// How well a course and speed bring own ship to a point that may move.
#pragma once

#include "lib/helm/decision/cpa_function.h"
#include "lib/helm/decision/objective.h"
#include "lib/helm/decision/speed_along.h"

namespace shoal {

/// closing_share * (closing speed, -top speed..top speed as 0..1)
///   + near_share * (1 - closest distance / present distance).
class ApproachFunction final : public CourseSpeedFunction {
 public:
  struct Target {
    Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();  ///< From own ship. Not zero.
    Eigen::Vector2d velocity_mps = Eigen::Vector2d::Zero();
    double horizon_s = 60;
  };
  struct Shares {
    double closing = 0;
    double near = 100;
  };

  ApproachFunction(const Target& target, const Shares& shares, const Domain& domain);

  double At(int course, int speed) const override;
  Range Bound(const GridBox& box) const override;

 private:
  CpaGrid cpa_;
  SpeedAlong closing_;
  Shares shares_;
  double top_mps_;
};

}  // namespace shoal
