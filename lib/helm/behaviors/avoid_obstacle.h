// Keeps clear of one obstacle.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "avoid_obstacle". Keeps clear of one obstacle.
struct AvoidObstacleOptions {
  static constexpr std::string_view kKind = "avoid_obstacle";

  std::string id = {};                        ///< Of the obstacle; filled in when it is spawned.
  std::vector<Eigen::Vector2d> polygon = {};  ///< Convex; empty: of the obstacle with this id.
  double allowable_ttc = 20;                  ///< s.
  double min_util_cpa_dist = 8;               ///< m.
  double max_util_cpa_dist = 16;              ///< m.
  double pwt_inner_dist = 10;                 ///< m.
  double pwt_outer_dist = 50;                 ///< m.
  double completed_dist = 50;                 ///< m.
  double turn_radius = 0;                     ///< m; own.
  bool holonomic_ok = false;
  bool allstop_on_breach = true;
  std::vector<std::string> rng_flag = {};
  std::vector<std::string> cpa_flag = {};

  bool operator==(const AvoidObstacleOptions&) const = default;
};

/// Values each course by how far the path, a turn and then straight on, stays clear of the
/// obstacle.
class AvoidObstacleBehavior final : public BehaviorWith<AvoidObstacleOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  bool is_constraint() const override { return true; }

 private:
  /// On which side the obstacle is left, once it is near.
  enum class Side { kFree, kObstacleToPort, kObstacleToStarboard };

  const std::vector<Eigen::Vector2d>* Polygon(const BehaviorInputs& inputs) const;
  void LockSide(const Eigen::Vector2d& centre_m, const VesselMotion& own, double relevance);
  /// Whether a course passes the obstacle on the other side than the one begun with, or the turn to
  /// it goes across the obstacle.
  bool LeadsAcross(double bearing_deg, double heading_deg, double course_deg) const;
  void FireFlags(double distance_m, BehaviorAnswer& answer);

  Side side_ = Side::kFree;
  double last_distance_m_ = -1;  ///< < 0: none yet.
  bool came_near_ = false;
  bool passed_ = false;
};

}  // namespace shoal
