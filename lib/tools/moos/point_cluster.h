// The obstacle that pObstacleMgr makes of the points of one label.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "lib/tools/moos/moos_file.h"

namespace shoal {

struct PointCluster {
  std::vector<Eigen::Vector2d> points_m;
  std::string origin;  ///< Of the first point's line.
  std::string text;
  bool is_lasso = false;  ///< A polygon about the mean, whatever the points are.
  double lasso_radius_m = 5;
  int lasso_points = 6;
  size_t most_points = 20;
};

/// Returns the settings of the first pObstacleMgr, without points.
[[nodiscard]] PointCluster ClusterSettings(const std::vector<MoosFile>& files);

/// Returns the convex polygon of a cluster; of points that have none, an octagon about their mean.
/// @pre it has a point
[[nodiscard]] std::vector<Eigen::Vector2d> HullOf(const PointCluster& cluster);

}  // namespace shoal
