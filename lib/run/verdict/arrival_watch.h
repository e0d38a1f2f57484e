// Watches whether one vehicle gets to a point in time, and stays.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>

#include "lib/run/verdict/outcome.h"

namespace shoal {

/// Times are seconds of mission time since the mission's start.
struct ArrivalGoal {
  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
  double within_m = 20;  ///< There: this near, or nearer.
  double by_s = 0;       ///< The latest time that counts.
  bool stays = false;  ///< There without a break from some time, `by_s` at the latest, to the end.
};

class ArrivalWatch {
 public:
  explicit ArrivalWatch(const ArrivalGoal& goal) : goal_(goal) {}

  /// Takes note of where the vehicle is. @pre times do not go back
  void Look(const Eigen::Vector2d& position_m, double time_s);

  /// Returns true where the vehicle was there when it was first seen, and this alone counts.
  [[nodiscard]] bool is_met_from_start() const { return was_there_first_ && !goal_.stays; }

  /// Returns the verdict, should the mission end now.
  [[nodiscard]] Outcome Find() const;

 private:
  ArrivalGoal goal_;
  bool was_there_first_ = false;
  std::optional<double> first_there_s_;
  std::optional<double> there_since_s_;  ///< Absent while it is elsewhere.
  double distance_m_ = std::numeric_limits<double>::infinity();
  double closest_m_ = std::numeric_limits<double>::infinity();
  double closest_s_ = 0;
};

}  // namespace shoal
