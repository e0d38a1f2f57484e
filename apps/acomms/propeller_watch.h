// How fast a leader's propeller is changing its speed: what its reports predict from
// (PredictAtPoint, lib/vehicle/guidance/motion_prediction.h).
#pragma once

#include <cstdint>
#include <optional>

#include "lib/mission/model/vehicle.h"
#include "lib/vehicle/guidance/motion_prediction.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "shoal/actuators_t.hpp"

namespace shoal {

/// Knows the rate n of the commanded revolutions, in rpm/s. It is 0, as in muNet, unless the rate
/// of the propeller is limited (`max_propeller_rate_rpmps`) and its revolutions still change toward
/// their set point.
class PropellerWatch {
 public:
  /// ACTUATORS that are older than this state no rate.
  static constexpr int64_t kTimeout_us = 2'000'000;

  explicit PropellerWatch(const AnyModel& model);

  /// True where the revolutions can have a rate; the others need no ACTUATORS.
  bool is_needed() const { return remus_.has_value(); }

  void OnActuators(const actuators_t& actuators);

  /// Returns the plan of a vehicle that moves as `own` does: with a rate, the acceleration is
  /// the slope of the map from rpm to speed times n, and no speed is above that of full revolutions
  /// (or the own one). @pre own is finite
  [[nodiscard]] SpeedPlan PlanOf(const Motion& own, int64_t utime) const;

 private:
  struct Remus {
    Remus100 auv;
    bool is_munet = false;
    double max_rate_rpmps = 0;
  };

  std::optional<Remus> remus_;  ///< With a limited rate.
  std::optional<int64_t> utime_;
  double rpm_ = 0;
  double rate_rpmps_ = 0;
};

}  // namespace shoal
