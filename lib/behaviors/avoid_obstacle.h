// Keeps clear of one obstacle.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/behaviors/behavior.h"

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

}  // namespace shoal
