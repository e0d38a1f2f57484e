// Changes of a mission file by places on a map. Everything else of the text stays as it is:
// comments, order, blanks. What the changed file then means, and whether it is a mission, is for
// LoadMissionText to find out.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

/// Puts a point of a handle elsewhere (plan_text.h has the numbers of handles and points).
struct MovePoint {
  size_t handle = 0;
  size_t point = 0;
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();
};
/// Adds a point to a line or polygon, before the point of this number, or at its end.
struct InsertPoint {
  size_t handle = 0;
  size_t before = 0;
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
};
/// Takes a point out of a line or polygon: one stays of a line, three of a polygon.
struct RemovePoint {
  size_t handle = 0;
  size_t point = 0;
};
/// Adds a task to a vehicle: "waypoints" (one or more points), "loiter" (its centre; a second point
/// lies on its circle), "station_keep" (its point) or "survey" (three corners or more).
struct AddTask {
  std::string vehicle = {};
  std::string kind = {};
  std::vector<Eigen::Vector2d> points_m = {};
};
/// Adds an [[obstacle]], three corners or more.
struct AddObstacle {
  std::vector<Eigen::Vector2d> points_m = {};
};
/// Adds op_area to [mission], three corners or more.
struct AddArea {
  std::vector<Eigen::Vector2d> points_m = {};
};

using PlanEdit = std::variant<MovePoint, InsertPoint, RemovePoint, AddTask, AddObstacle, AddArea>;

/// Places beyond this are refused, m.
inline constexpr double kFarthestPlan_m = 1e6;

/// Returns the text with the change, or why it cannot be made. Numbers are written to 0.1 m.
[[nodiscard]] Result<std::string> EditPlan(std::string_view text, const PlanEdit& edit);

}  // namespace shoal
