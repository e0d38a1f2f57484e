// Stays near a point.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "station_keep". Stays near a point.
struct StationKeepOptions {
  static constexpr std::string_view kKind = "station_keep";

  std::optional<Eigen::Vector2d> station_pt = {};  ///< Absent: center_activate must be true.
  bool center_activate = false;  ///< Its point is where the vessel is when it begins to run.
  double swing_time = 0;       ///< s, 0 to 60: after that start the point still follows the vessel.
  double inner_radius = 4;     ///< m.
  double outer_radius = 15;    ///< m; > inner_radius.
  double outer_speed = 1.2;    ///< m/s at outer_radius.
  double transit_speed = 2.5;  ///< m/s beyond it.
  double hibernation_radius = -1;  ///< m; no preference inside; -1: off.

  bool operator==(const StationKeepOptions&) const = default;
};

/// Posts PSKEEP_MODE, SEEKING_STATION or HIBERNATING, where it hibernates, and
/// DIST_TO_STATION.
class StationKeepBehavior final : public BehaviorWith<StationKeepOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  struct Past {
    double time_s = 0;
    double distance_m = 0;
  };

  double Speed(double distance_m) const;
  void Hibernate(double time_s, double distance_m);

  std::optional<double> begun_s_;  ///< Absent: idle before.
  Eigen::Vector2d activated_at_m_ = Eigen::Vector2d::Zero();
  bool hibernates_ = false;
  std::deque<Past> past_;  ///< Of the last seconds awake.
};

}  // namespace shoal
